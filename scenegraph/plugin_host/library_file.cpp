#include "hatchway/plugin_host/library_file.hpp"

#include <elf.h>

#include <cstring>
#include <fstream>
#include <system_error>
#include <vector>

namespace hw {
namespace {

namespace fs = std::filesystem;

/// Whether `count` entries of `entry_bytes` at `offset` end inside of the file.
bool fits(std::uint64_t offset, std::uint64_t count, std::uint64_t entry_bytes, std::uint64_t file_bytes)
{
    return offset <= file_bytes && (entry_bytes == 0 || count <= (file_bytes - offset) / entry_bytes);
}

bool is_elf_64(const Elf64_Ehdr& header)
{
    return std::memcmp(header.e_ident, ELFMAG, SELFMAG) == 0 && header.e_ident[EI_CLASS] == ELFCLASS64;
}

bool is_whole(std::ifstream& file, const Elf64_Ehdr& header, std::uint64_t file_bytes)
{
    if (header.e_phentsize != sizeof(Elf64_Phdr)) return false;
    if (!fits(header.e_phoff, header.e_phnum, sizeof(Elf64_Phdr), file_bytes)) return false;
    if (!fits(header.e_shoff, header.e_shnum, header.e_shentsize, file_bytes)) return false;
    std::vector<Elf64_Phdr> segments(header.e_phnum);
    file.seekg(static_cast<std::streamoff>(header.e_phoff));
    file.read(reinterpret_cast<char*>(segments.data()),
              static_cast<std::streamsize>(segments.size() * sizeof(Elf64_Phdr)));
    for (const Elf64_Phdr& segment : segments)
        if (!fits(segment.p_offset, segment.p_filesz, 1, file_bytes)) return false;
    return file.good();
}

}  // namespace

std::string library_refusal(const fs::path& library)
{
    std::error_code failed;
    if (!fs::is_regular_file(library, failed)) return "it is not a regular file";
    const std::uint64_t file_bytes = fs::file_size(library, failed);
    std::ifstream file(library, std::ios::binary);
    Elf64_Ehdr header = {};
    if (!file.read(reinterpret_cast<char*>(&header), sizeof header) || !is_elf_64(header)) return "";
    return is_whole(file, header, file_bytes) ? "" : "the file is cut off";
}

}  // namespace hw
