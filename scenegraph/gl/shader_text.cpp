#include "hatchway/gl/shader_text.hpp"

#include <algorithm>
#include <optional>
#include <regex>
#include <sstream>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/limits.hpp"

namespace hw {
namespace fs = std::filesystem;
namespace {

constexpr int kMaxIncludeDepth = 16;

/// "ink.glsl" or "lines/line.glsl": no name leads out of the folder that it is looked for in.
bool is_plain_name(std::string_view name)
{
    const auto is_allowed = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '/';
    };
    return !name.empty() && name.front() != '.' && name.front() != '/' && name.find("/.") == std::string_view::npos &&
           std::all_of(name.begin(), name.end(), is_allowed);
}

std::optional<fs::path> find_in(std::span<const fs::path> folders, std::string_view name)
{
    for (const fs::path& folder : folders)
        if (std::error_code ignored; fs::is_regular_file(folder / name, ignored)) return folder / name;
    return std::nullopt;
}

/// The name in an `#include "name"` line.
std::optional<std::string_view> included_name(std::string_view line)
{
    const auto skip_blanks = [&] { line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size())); };
    skip_blanks();
    if (!line.starts_with('#')) return std::nullopt;
    line.remove_prefix(1);
    skip_blanks();
    if (!line.starts_with("include")) return std::nullopt;
    const std::size_t open = line.find('"');
    const std::size_t close = line.find('"', open + 1);
    if (open == std::string_view::npos || close == std::string_view::npos) return std::string_view();
    return line.substr(open + 1, close - open - 1);
}

class Includer {
 public:
    Includer(std::span<const fs::path> folders, ShaderText& result) : folders_(folders), result_(result) {}

    void add(std::string_view name, const std::string& named_in, const std::string& line, int depth)
    {
        const std::optional<fs::path> file = is_plain_name(name) ? find_in(folders_, name) : std::nullopt;
        if (!file || depth > kMaxIncludeDepth)
            throw Error({.what = file ? "includes lie too deep" : "no shader file \"" + std::string(name) + "\"",
                         .file = named_in,
                         .pointer = line,
                         .expected = file ? "at most 16 files in a chain" : "a file in " + folder_list()});
        if (std::find(result_.files.begin(), result_.files.end(), *file) != result_.files.end()) return;
        const std::size_t number = result_.files.size();
        result_.files.push_back(*file);
        append_lines(read_text_file(*file, limits::kMaxShaderBytes), *file, number, depth);
    }

 private:
    void append_lines(const std::string& text, const fs::path& file, std::size_t number, int depth)
    {
        result_.text += "#line 1 " + std::to_string(number) + "\n";
        int line_number = 0;
        for (std::size_t start = 0; start < text.size();) {
            const std::size_t end = std::min(text.find('\n', start), text.size());
            const std::string_view line = std::string_view(text).substr(start, end - start);
            start = end + 1;
            ++line_number;
            if (const auto name = included_name(line)) {
                add(*name, file.string(), "line " + std::to_string(line_number), depth + 1);
                result_.text += "#line " + std::to_string(line_number + 1) + " " + std::to_string(number) + "\n";
            } else {
                result_.text.append(line).append("\n");
            }
        }
    }

    std::string folder_list() const
    {
        std::string list;
        for (const fs::path& folder : folders_) list += (list.empty() ? "" : " or ") + folder.string();
        return list;
    }

    std::span<const fs::path> folders_;
    ShaderText& result_;
};

}  // namespace

ShaderText load_shader(std::string_view name, std::span<const fs::path> folders, std::string_view defines)
{
    ShaderText result{.text = std::string(defines), .files = {"defines"}};
    if (!result.text.empty() && result.text.back() != '\n') result.text += '\n';
    Includer(folders, result).add(name, std::string(name), "", 0);
    return result;
}

std::string shader_header(bool is_es)
{
    if (!is_es) return "#version 330 core\n#line 1 0\n";
    return "#version 300 es\n"
           "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\nprecision highp "
           "sampler2DShadow;\nprecision highp usampler2D;\n"
           "#line 1 0\n";
}

std::string located_message(const std::string& log, const ShaderText& shader)
{
    // Mesa: "2:14(5): error: text"; NVIDIA: "2(14) : error C1: text"; others: "ERROR: 2:14: text".
    static const std::regex place(R"((\d+)(?::(\d+)(?:\(\d+\))?|\((\d+)\)) ?: ?(.*))");
    std::istringstream lines(log);
    std::string line;
    std::string first_line;
    std::string number;
    std::string message;
    std::size_t file = 0;
    while (std::getline(lines, line)) {
        if (first_line.empty()) first_line = line;
        std::smatch match;
        const bool is_error = line.find("rror") != std::string::npos || line.find("ERROR") != std::string::npos;
        if (!is_error || !std::regex_search(line, match, place)) continue;
        const std::string own_number = match[2].matched ? match[2] : match[3];
        // Mesa forgets the file of an unknown name, but tells it in the error that follows from it on the same line.
        if (!message.empty() && own_number != number) break;
        if (message.empty()) message = match[4];
        number = own_number;
        file = std::min<std::size_t>(std::stoul(match[1]), shader.files.size() - 1);
        if (file != 0) break;
    }
    // Number 0 is the defines', which are ours: where nothing else was told, the author's file is meant.
    const std::string author_file = shader.files.size() > 1 ? shader.files[1].string() : "shader";
    if (message.empty()) return author_file + ": " + first_line;
    return (file == 0 ? author_file : shader.files[file].string()) + ":" + number + ": " + message;
}

}  // namespace hw
