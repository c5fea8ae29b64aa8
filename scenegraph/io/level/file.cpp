#include "hatchway/io/level/file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/io/json/places.hpp"
#include "hatchway/io/level/reader.hpp"
#include "hatchway/io/model/import.hpp"

namespace hw {
namespace fs = std::filesystem;
namespace {

std::string lower_extension(const fs::path& file)
{
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return extension;
}

Level bare_model(const fs::path& file)
{
    std::error_code failed;
    if (!fs::is_regular_file(file, failed))
        throw Error({.what = fs::exists(file, failed) ? "is not a regular file" : "there is no such file",
                     .file = file.string(),
                     .expected = fmt::format("a level (.json) or a model ({})", kModelFormats)});
    Level level;
    level.file = file;
    level.project_root = find_project_root(file);
    level.scene_file = file;
    return level;
}

/// JSON objects are read in the order of their keys; people count in the order of the file.
template <typename Named>
void put_in_order(std::vector<Named>& all, const std::vector<std::string>& names)
{
    std::map<std::string_view, std::size_t> place;
    for (std::size_t i = 0; i < names.size(); ++i) place[names[i]] = i;
    std::ranges::sort(all, {}, [&](const Named& one) { return place.at(one.name); });
}

}  // namespace

fs::path marked_project(const fs::path& file)
{
    std::error_code failed;
    fs::path root = fs::absolute(file).lexically_normal().parent_path();
    while (true) {
        if (fs::exists(root / "hatchway.project", failed) || fs::exists(root / ".git", failed)) return root;
        if (root == root.parent_path()) return {};
        root = root.parent_path();
    }
}

fs::path find_project_root(const fs::path& file)
{
    const fs::path marked = marked_project(file);
    if (!marked.empty()) return marked;
    const fs::path folder = fs::absolute(file).lexically_normal().parent_path();
    return folder.filename() == "levels" ? folder.parent_path() : folder;
}

Level parse_level(const std::string& text, const fs::path& file)
{
    Level level;
    level.file = file;
    level.project_root = find_project_root(file);
    const nlohmann::json document = parse_json(text, file.string(), JsonComments::allowed);
    LevelReader::read(document, level);
    put_in_order(level.cameras, member_names(text, "cameras"));
    put_in_order(level.paths, member_names(text, "paths"));
    return level;
}

Level read_level(const fs::path& file)
{
    const std::string extension = lower_extension(file);
    if (is_model_file(file)) return bare_model(file);
    if (extension == ".json") return parse_level(read_text_file(file, limits::kMaxLevelFileBytes), file);
    throw Error({.what = "a file of this kind cannot be opened",
                 .file = file.string(),
                 .expected = fmt::format("a level (.json) or a model ({})", kModelFormats)});
}

}  // namespace hw
