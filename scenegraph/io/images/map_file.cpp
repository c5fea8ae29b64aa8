#include "hatchway/io/images/map_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/core/lower_snake.hpp"
#include "hatchway/io/images/images.hpp"
#include "hatchway/io/json/text.hpp"

namespace hw {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

constexpr std::string_view kFormat = "hatchway-map/1";
constexpr std::array<std::string_view, 5> kKeys{"format", "kind", "levels", "size_m", "spacing_texels"};
constexpr std::uint64_t kMaxMapFileBytes = 1 << 16;
constexpr int kMaxLevels = 15;  // of a map 16384 texels wide

/// What map.json states.
class MapDescription {
 public:
    explicit MapDescription(const fs::path& folder) : file_((folder / "map.json").string())
    {
        std::error_code failed;
        if (!fs::is_regular_file(folder / "map.json", failed))
            throw Error({.what = "is no map", .file = folder.string(), .expected = "a folder with a map.json"});
        const fs::path inside = resolve_inside(folder, folder, "map.json", file_, "");
        values_ = parse_json(read_text_file(inside, kMaxMapFileBytes), file_, JsonComments::allowed);
        if (!values_.is_object()) refuse("", "an object", values_);
        for (const auto& [name, value] : values_.items())
            if (std::ranges::find(kKeys, name) == kKeys.end())
                throw Error({.what = fmt::format("there is no key \"{}\" here", name),
                             .file = file_,
                             .pointer = pointer_to("", name),
                             .expected = fmt::format("one of: {}", fmt::join(kKeys, ", "))});
        const std::string format = fmt::format("\"{}\"", kFormat);
        if (at("format", format) != kFormat) refuse("format", format, at("format"));
    }

    MapKind kind() const
    {
        const json& value = at("kind");
        const std::string stated = value.is_string() ? value.get<std::string>() : "";
        const auto found = std::ranges::find(kMapKinds, stated, &MapKindFacts::name);
        if (found != kMapKinds.end()) return static_cast<MapKind>(found - kMapKinds.begin());
        std::vector<std::string_view> names;
        for (const MapKindFacts& kind : kMapKinds) names.push_back(kind.name);
        refuse("kind", fmt::format("one of: {}", fmt::join(names, ", ")), value);
    }

    int level_count() const
    {
        const double count = number("levels", 1, kMaxLevels);
        if (count != std::floor(count)) refuse("levels", "a whole number", at("levels"));
        return static_cast<int>(count);
    }

    double number(const char* name, double min, double max) const
    {
        const json& value = at(name);
        const double stated = value.is_number() ? value.get<double>() : std::nan("");
        if (!(stated >= min && stated <= max)) refuse(name, fmt::format("a number from {} to {}", min, max), value);
        return stated;
    }

    bool has(const char* name) const { return values_.contains(name); }

 private:
    const json& at(const char* name, const std::string& expected = "") const
    {
        const auto found = values_.find(name);
        if (found == values_.end())
            throw Error({.what = fmt::format("the key \"{}\" is missing", name), .file = file_, .expected = expected});
        return *found;
    }
    [[noreturn]] void refuse(const char* name, const std::string& expected, const json& value) const
    {
        throw Error({.what = "stands " + described(value),
                     .file = file_,
                     .pointer = *name ? pointer_to("", name) : "",
                     .expected = expected});
    }

    std::string file_;
    json values_;
};

void check_level(const MapLevels& map, const Pixels& level, const std::string& file)
{
    const auto refuse = [&](std::string expected) {
        throw Error({.what = fmt::format("is {} x {} with {} channels", level.width, level.height, level.channels),
                     .file = file,
                     .expected = std::move(expected)});
    };
    const MapKindFacts& kind = facts_of(map.kind);
    if (level.channels != 1 && !kind.is_colour) refuse("a gray image without alpha");
    if (level.height != 1 && kind.is_strip) refuse(fmt::format("a {} map one texel high", kind.name));
    if (!map.levels.empty() && kind.is_lone) refuse(fmt::format("a {} map of one level", kind.name));
    if (map.levels.empty()) return;
    const int width = std::max(map.levels.back().width / 2, 1);
    const int height = std::max(map.levels.back().height / 2, 1);
    if (level.width != width || level.height != height)
        refuse(fmt::format("half the level before, {} x {}", width, height));
}

/// The maps that come with the program, in the order of their names.
std::vector<std::string> names_in(const fs::path& folder)
{
    std::vector<std::string> names;
    std::error_code failed;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed))
        names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

}  // namespace

MapLevels read_map(const fs::path& folder)
{
    const MapDescription description(folder);
    MapLevels map;
    map.kind = description.kind();
    if (description.has("size_m")) map.size_m = description.number("size_m", 1e-6, 1e6);
    if (description.has("spacing_texels")) map.spacing_texels = description.number("spacing_texels", 1e-3, 1e6);
    const int count = description.level_count();
    for (int i = 0; i < count; ++i) {
        const std::string name = fmt::format("level_{}.png", i);
        const fs::path file = resolve_inside(folder, folder, name, (folder / "map.json").string(), "/levels");
        Pixels level = read_image(file);
        check_level(map, level, file.string());
        map.levels.push_back(std::move(level));
    }
    return map;
}

fs::path find_map(const Level& level, MapKind kind, const std::string& name, const std::string& pointer)
{
    const fs::path built_in = installation_prefix() / "share" / "hatchway" / "maps" / facts_of(kind).name / name;
    std::error_code failed;
    if (is_lower_snake(name) && fs::is_regular_file(built_in / "map.json", failed)) return built_in;
    const fs::path folder =
        resolve_inside(level.project_root, level.file.parent_path(), name, level.file.string(), pointer);
    if (fs::is_regular_file(folder / "map.json", failed)) return folder;
    throw Error({.what = fmt::format("there is no map \"{}\" of the kind {}", name, facts_of(kind).name),
                 .file = level.file.string(),
                 .pointer = pointer,
                 .expected = is_lower_snake(name) ? fmt::format("the path of a map's folder, or one of: {}",
                                                                fmt::join(names_in(built_in.parent_path()), ", "))
                                                  : fmt::format("a folder with a map.json: {}", folder.string())});
}

}  // namespace hw
