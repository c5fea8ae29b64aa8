#include "hatchway/plugin_host/new_style.hpp"

#include <fmt/format.h>

#include <cctype>
#include <system_error>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/files/folder_draft.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/plugin_host/plugin_registry.hpp"

namespace hw {
namespace {

namespace fs = std::filesystem;

/// Template file -> written file, in both of which @name@ stands for the style's name.
struct TemplateFile {
    const char* from;
    const char* to;
};
constexpr TemplateFile kFiles[] = {{"style.cpp.in", "@name@.cpp"},
                                   {"style.frag.in", "@name@.frag"},
                                   {"CMakeLists.txt.in", "CMakeLists.txt"},
                                   {"README.md.in", "README.md"}};

/// "soft_pencil" -> "SoftPencil".
std::string type_name(const std::string& name)
{
    std::string result;
    bool starts_word = true;
    for (const char c : name) {
        if (c != '_') result += starts_word ? static_cast<char>(std::toupper(c)) : c;
        starts_word = c == '_';
    }
    return result;
}

std::string replaced(std::string text, const std::string& what, const std::string& with)
{
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
    return text;
}

void refuse_bad_name(const std::string& name)
{
    const bool starts_with_letter = !name.empty() && name[0] >= 'a' && name[0] <= 'z';
    if (is_plugin_name(name) && starts_with_letter) return;
    throw Error(
        {.what = fmt::format("the style's name is \"{}\"", name), .expected = "a-z, 0-9 and _, with a letter first"});
}

}  // namespace

std::vector<fs::path> write_new_style(const std::string& name, const fs::path& parent)
{
    refuse_bad_name(name);
    const fs::path folder = parent / name;
    std::error_code failed;
    if (fs::exists(fs::symlink_status(folder, failed)))
        throw Error({.what = "there is already something of that name", .file = folder.string()});

    const fs::path templates = installation_prefix() / "share" / "hatchway" / "new_style";
    std::vector<std::pair<fs::path, std::string>> files;
    for (const TemplateFile& file : kFiles) {
        std::string text = read_text_file(templates / file.from, limits::kMaxShaderBytes);
        text = replaced(replaced(std::move(text), "@Type@", type_name(name)), "@name@", name);
        files.emplace_back(replaced(file.to, "@name@", name), std::move(text));
    }
    FolderDraft draft(folder);
    draft.fill([&](const fs::path& place) {
        for (const auto& [file, text] : files) write_file_atomically(place / file, text);
    });
    draft.put_new();
    std::vector<fs::path> written;
    for (const auto& [file, text] : files) written.push_back(folder / file);
    return written;
}

}  // namespace hw
