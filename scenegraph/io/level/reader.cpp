#include "hatchway/io/level/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <nlohmann/json.hpp>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/lower_snake.hpp"
#include "hatchway/core/srgb.hpp"
#include "hatchway/io/level/inherited_styles.hpp"
#include "hatchway/param/param_reader.hpp"

namespace hw {

using nlohmann::json;

LevelReader::LevelReader(const Level& level, const json& object, std::string pointer)
    : level_(level), object_(object), pointer_(std::move(pointer))
{
    if (!object_.is_object()) refuse(pointer_, "stands " + described(object_), "an object");
}

void LevelReader::read(const json& document, Level& level)
{
    LevelReader(level, document, "").read_object(document, "", level);
}

void LevelReader::refuse(const std::string& pointer, std::string what, std::string expected) const
{
    throw Error(
        {.what = std::move(what), .file = level_.file.string(), .pointer = pointer, .expected = std::move(expected)});
}

const json* LevelReader::find(const LevelKey& key)
{
    visited_.emplace_back(key.name);
    const auto found = object_.find(key.name);
    if (found != object_.end()) return &*found;
    if (key.is_required)
        refuse(pointer_, fmt::format("the key \"{}\" is missing", key.name),
               fmt::format("\"{}\": {}", key.name, key.help));
    return nullptr;
}

const json* LevelReader::find_list(const LevelKey& key)
{
    const json* value = find(key);
    if (!value) return nullptr;
    const std::string expected = fmt::format("an array of at most {} elements", limits::kMaxNames);
    if (!value->is_array() || value->size() > static_cast<std::size_t>(limits::kMaxNames))
        refuse(pointer_to(pointer_, key.name), "stands " + described(*value), expected);
    return value;
}

std::optional<std::vector<LevelReader::Part>> LevelReader::elements_of(const LevelKey& key)
{
    const json* stated = find_list(key);
    if (!stated) return {};
    std::vector<Part> parts;
    for (const json& value : *stated)
        parts.push_back({value, pointer_to(pointer_to(pointer_, key.name), parts.size()), {}});
    return parts;
}

std::optional<std::vector<LevelReader::Part>> LevelReader::members_of(const LevelKey& key)
{
    const json* stated = find(key);
    if (!stated) return {};
    const std::string pointer = pointer_to(pointer_, key.name);
    if (!stated->is_object() || stated->size() > static_cast<std::size_t>(limits::kMaxNames))
        refuse(pointer, "stands " + described(*stated),
               fmt::format("an object of at most {} names", limits::kMaxNames));
    if (stated->contains("")) refuse(pointer, "a name is empty", "a text");
    std::vector<Part> parts;
    for (const auto& [name, value] : stated->items()) parts.push_back({value, pointer_to(pointer, name), name});
    return parts;
}

bool LevelReader::has(std::string_view name) const
{
    return object_.contains(name);
}

std::optional<std::string> LevelReader::text_of(const LevelKey& key)
{
    const json* stated = find(key);
    if (!stated) return {};
    if (!stated->is_string() || stated->get_ref<const std::string&>().empty())
        refuse(pointer_to(pointer_, key.name), "stands " + described(*stated), "a text that is not empty");
    return stated->get<std::string>();
}

std::optional<bool> LevelReader::flag_of(const LevelKey& key)
{
    const json* stated = find(key);
    if (!stated) return {};
    if (!stated->is_boolean()) refuse(pointer_to(pointer_, key.name), "stands " + described(*stated), "true or false");
    return stated->get<bool>();
}

std::optional<double> LevelReader::number(const LevelKey& key, const LevelRange& range)
{
    const json* stated = find(key);
    if (!stated) return {};
    const double value = stated->is_number() ? stated->get<double>() : std::nan("");
    if (!(value >= range.min && value <= range.max))
        refuse(pointer_to(pointer_, key.name), "stands " + described(*stated),
               fmt::format("a number from {} to {}", range.min, range.max));
    return value;
}

bool LevelReader::whole(const LevelKey& key, const LevelRange& range, int& value)
{
    const std::optional<double> stated = number(key, range);
    if (!stated) return false;
    if (*stated != std::floor(*stated))
        refuse(pointer_to(pointer_, key.name), fmt::format("stands the number {}", *stated),
               fmt::format("a whole number from {} to {}", range.min, range.max));
    value = static_cast<int>(*stated);
    return true;
}

bool LevelReader::angle(const LevelKey& key, const LevelRange& range_deg, float& rad)
{
    const std::optional<double> deg = number(key, range_deg);
    if (deg) rad = static_cast<float>(glm::radians(*deg));
    return deg.has_value();
}

bool LevelReader::point(const LevelKey& key, glm::dvec3& value)
{
    const json* stated = find(key);
    if (!stated) return false;
    const std::string pointer = pointer_to(pointer_, key.name);
    if (!stated->is_array() || stated->size() != 3)
        refuse(pointer, "stands " + described(*stated), "three numbers [x, y, z]");
    for (int axis = 0; axis < 3; ++axis) {
        const json& part = (*stated)[static_cast<std::size_t>(axis)];
        value[axis] = part.is_number() ? part.get<double>() : std::nan("");
        if (!(value[axis] >= kMetres.min && value[axis] <= kMetres.max))
            refuse(pointer_to(pointer, static_cast<std::size_t>(axis)), "stands " + described(part),
                   fmt::format("a number from {} to {}", kMetres.min, kMetres.max));
    }
    return true;
}

std::optional<glm::vec3> LevelReader::colour_of(const LevelKey& key)
{
    const json* stated = find(key);
    if (!stated) return {};
    glm::vec3 srgb;
    if (!stated->is_string() || !parse_colour(stated->get<std::string>(), srgb))
        refuse(pointer_to(pointer_, key.name), "stands " + described(*stated), "a colour such as \"#1a2b3c\"");
    return srgb;
}

bool LevelReader::linear_colour(const LevelKey& key, glm::vec3& linear)
{
    const std::optional<glm::vec3> srgb = colour_of(key);
    for (int i = 0; srgb && i < 3; ++i) linear[i] = linear_from_srgb((*srgb)[i]);
    return srgb.has_value();
}

bool LevelReader::file(const LevelKey& key, std::filesystem::path& value)
{
    std::string stated;
    if (!text(key, stated)) return false;
    const std::string pointer = pointer_to(pointer_, key.name);
    value = resolve_inside(level_.project_root, level_.file.parent_path(), stated, level_.file.string(), pointer);
    std::error_code failed;
    if (!std::filesystem::is_regular_file(value, failed))
        refuse(pointer, "there is no file \"" + stated + '"', "a path relative to the level file");
    return true;
}

bool LevelReader::constant(const LevelKey& key, std::string_view expected)
{
    const std::string quoted = fmt::format("\"{}\"", expected);
    if (key.is_required && !has(key.name)) refuse(pointer_, fmt::format("the key \"{}\" is missing", key.name), quoted);
    const json* stated = find(key);
    if (!stated) return false;
    if (!stated->is_string() || stated->get_ref<const std::string&>() != expected)
        refuse(pointer_to(pointer_, key.name), "stands " + described(*stated), quoted);
    return true;
}

std::optional<std::vector<std::string>> LevelReader::texts_of(const LevelKey& key)
{
    const json* stated = find_list(key);
    if (!stated) return {};
    std::vector<std::string> values;
    for (std::size_t i = 0; i < stated->size(); ++i) {
        const json& value = (*stated)[i];
        if (!value.is_string() || value.get_ref<const std::string&>().empty())
            refuse(pointer_to(pointer_to(pointer_, key.name), i), "stands " + described(value),
                   "a text that is not empty");
        values.push_back(value.get<std::string>());
    }
    return values;
}

std::optional<std::size_t> LevelReader::index_of(const LevelKey& key, std::span<const std::string_view> names)
{
    const json* stated = find(key);
    if (!stated) return {};
    const auto found =
        stated->is_string() ? std::ranges::find(names, stated->get_ref<const std::string&>()) : names.end();
    if (found == names.end())
        refuse(pointer_to(pointer_, key.name), "stands " + described(*stated),
               fmt::format("one of: {}", fmt::join(names, ", ")));
    return found - names.begin();
}

void LevelReader::one_of(std::string_view first, std::string_view second) const
{
    const std::string expected = fmt::format("either \"{}\" or \"{}\"", first, second);
    if (!has(first) && !has(second))
        refuse(pointer_, fmt::format("the keys \"{}\" and \"{}\" are missing", first, second), expected);
    if (has(first) && has(second))
        refuse(pointer_to(pointer_, second), fmt::format("stands beside \"{}\"", first), expected);
}

void LevelReader::not_both(std::string_view first, std::string_view second) const
{
    if (has(first) && has(second))
        refuse(pointer_to(pointer_, second), fmt::format("stands beside \"{}\"", first), "one of the two");
}

void LevelReader::params(ParamSettings& values)
{
    is_open_ = true;
    for (const auto& [name, value] : object_.items()) {
        if (std::ranges::find(visited_, name) != visited_.end()) continue;
        ParamSetting setting{.value = {}, .pointer = pointer_to(pointer_, name)};
        if (value.is_boolean())
            setting.value = value.get<bool>();
        else if (value.is_number())
            setting.value = value.get<double>();
        else if (value.is_string())
            setting.value = value.get<std::string>();
        else
            refuse(setting.pointer, "stands " + described(value), "a number, a text, true or false");
        values.emplace(name, std::move(setting));
    }
}

void LevelReader::refuse_unknown() const
{
    for (const auto& [name, value] : object_.items()) {
        if (is_open_ || std::ranges::find(visited_, name) != visited_.end()) continue;
        refuse(pointer_to(pointer_, name), fmt::format("there is no key \"{}\" here", name),
               fmt::format("one of: {}", fmt::join(visited_, ", ")));
    }
}

void LevelReader::require_look(const glm::dvec3& position, const glm::dvec3& look_at, const std::string& pointer) const
{
    if (position == look_at) refuse(pointer + "/look_at", "the eye looks at itself", "another point than \"position\"");
}

void LevelReader::finish(const LevelReader& reader, StyleDesc& style)
{
    style.pointer = reader.pointer();
    if (style.like.empty() && !is_lower_snake(style.plugin))
        reader.refuse(reader.pointer() + "/plugin", "stands the text \"" + style.plugin + '"',
                      "a plugin's name of a-z, 0-9 and _");
}

void LevelReader::finish(const LevelReader& reader, AssignRule& rule)
{
    rule.pointer = reader.pointer();
    if (rule.presence && !rule.over)
        reader.refuse(rule.pointer + "/presence", "there is nothing that it could show", "\"over\" in the same entry");
}

void LevelReader::finish(const LevelReader&, Level& level)
{
    inherit_styles(level);
}

void LevelReader::finish(const LevelReader& reader, MirrorRule& mirror)
{
    mirror.pointer = reader.pointer();
}

void LevelReader::finish(const LevelReader& reader, StartPlace& place)
{
    reader.require_look(place.position, place.look_at, reader.pointer());
}

void LevelReader::finish(const LevelReader& reader, Camera& camera)
{
    reader.require_look(camera.eye_world, camera.target_world, reader.pointer());
}

void LevelReader::finish(const LevelReader& reader, CameraPath& path)
{
    const std::string pointer = reader.pointer() + "/keys";
    if (path.keys.empty()) reader.refuse(pointer, "the path has no place", "at least one");
    for (std::size_t i = 0; i < path.keys.size(); ++i) {
        reader.require_look(path.keys[i].position, path.keys[i].look_at, pointer_to(pointer, i));
        if (i > 0 && path.keys[i].t_s <= path.keys[i - 1].t_s)
            reader.refuse(pointer_to(pointer, i) + "/t_s", fmt::format("stands the number {}", path.keys[i].t_s),
                          fmt::format("a time after {}", path.keys[i - 1].t_s));
    }
}

void LevelReader::finish(const LevelReader& reader, Light& light)
{
    struct Use {
        std::string_view name;
        bool is_used;
        bool is_required;
    };
    const bool is_sun = light.type == LightType::sun;
    const bool is_spot = light.type == LightType::spot;
    const Use uses[] = {
        {"direction", is_sun || is_spot, true}, {"position", !is_sun, true}, {"illuminance_lux", is_sun, true},
        {"intensity_cd", !is_sun, true},        {"range_m", !is_sun, false}, {"inner_cone_deg", is_spot, false},
        {"outer_cone_deg", is_spot, false}};
    const std::string_view type = kLightTypes[static_cast<std::size_t>(light.type)];
    for (const Use& use : uses) {
        if (reader.has(use.name) && !use.is_used)
            reader.refuse(pointer_to(reader.pointer(), use.name), fmt::format("a light of type {} has none", type),
                          "no such key");
        if (!reader.has(use.name) && use.is_used && use.is_required)
            reader.refuse(reader.pointer(), fmt::format("the key \"{}\" is missing", use.name),
                          fmt::format("it in a light of type {}", type));
    }
    const double length = glm::length(light.direction_world);
    if (!(length > 0.0))
        reader.refuse(reader.pointer() + "/direction", "the direction is zero", "a vector with a length");
    light.direction_world /= length;
    if (light.inner_cone_rad >= light.outer_cone_rad)
        reader.refuse(reader.pointer() + "/inner_cone_deg", "the inner cone is not inside of the outer one",
                      "less than outer_cone_deg");
}

}  // namespace hw
