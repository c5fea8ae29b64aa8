#include "hatchway/param/param_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"

namespace hw {
namespace {

std::string printed(const ParamValue& value)
{
    if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (const double* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
    return '"' + std::get<std::string>(value) + '"';
}

}  // namespace

ParamReader::ParamReader(const ParamSettings& settings, std::string file, std::filesystem::path root)
    : settings_(settings), file_(std::move(file)), root_(std::move(root))
{
}

const ParamSetting* ParamReader::find(const ParamInfo& info)
{
    visited_.emplace_back(info.name);
    const auto found = settings_.find(visited_.back());
    return found == settings_.end() ? nullptr : &found->second;
}

const double* ParamReader::number(const ParamInfo& info, double min, double max, bool whole)
{
    const ParamSetting* setting = find(info);
    if (!setting) return nullptr;
    const double* value = std::get_if<double>(&setting->value);
    const bool is_allowed = value && *value >= min && *value <= max && (!whole || *value == static_cast<int>(*value));
    if (is_allowed) return value;
    throw Error({.what = fmt::format("{} is {}", info.name, printed(setting->value)),
                 .file = file_,
                 .pointer = setting->pointer,
                 .expected = fmt::format("a {}number from {} to {}", whole ? "whole " : "", min, max)});
}

const std::string* ParamReader::text(const ParamInfo& info, const std::string& expected)
{
    const ParamSetting* setting = find(info);
    if (!setting) return nullptr;
    if (const std::string* value = std::get_if<std::string>(&setting->value)) return value;
    throw Error({.what = fmt::format("{} is {}", info.name, printed(setting->value)),
                 .file = file_,
                 .pointer = setting->pointer,
                 .expected = expected});
}

void ParamReader::real(const ParamInfo& info, float& value, float min, float max)
{
    if (const double* stated = number(info, min, max, false)) value = static_cast<float>(*stated);
}

void ParamReader::whole(const ParamInfo& info, int& value, int min, int max)
{
    if (const double* stated = number(info, min, max, true)) value = static_cast<int>(*stated);
}

void ParamReader::flag(const ParamInfo& info, bool& value)
{
    const ParamSetting* setting = find(info);
    if (!setting) return;
    const bool* stated = std::get_if<bool>(&setting->value);
    if (!stated)
        throw Error({.what = fmt::format("{} is {}", info.name, printed(setting->value)),
                     .file = file_,
                     .pointer = setting->pointer,
                     .expected = "true or false"});
    value = *stated;
}

void ParamReader::colour(const ParamInfo& info, glm::vec3& value)
{
    const std::string expected = "a colour such as \"#1a2b3c\"";
    const std::string* stated = text(info, expected);
    if (!stated || parse_colour(*stated, value)) return;
    throw Error({.what = fmt::format("{} is \"{}\"", info.name, *stated),
                 .file = file_,
                 .pointer = settings_.at(std::string(info.name)).pointer,
                 .expected = expected});
}

void ParamReader::choice_of(const ParamInfo& info, int& index, std::span<const std::string_view> names)
{
    const std::string expected = fmt::format("one of: {}", fmt::join(names, ", "));
    const std::string* stated = text(info, expected);
    if (!stated) return;
    const auto found = std::find(names.begin(), names.end(), *stated);
    if (found == names.end())
        throw Error({.what = fmt::format("{} is \"{}\"", info.name, *stated),
                     .file = file_,
                     .pointer = settings_.at(std::string(info.name)).pointer,
                     .expected = expected});
    index = static_cast<int>(found - names.begin());
}

void ParamReader::map(const ParamInfo& info, MapName& value, MapKind)
{
    if (const std::string* stated = text(info, "the name of a map, or a path relative to the level file"))
        value.value = *stated;
}

void ParamReader::image(const ParamInfo& info, ImageFile& value)
{
    const std::string expected = "an image file (.png, .jpg), relative to the level file";
    const std::string* stated = text(info, expected);
    if (!stated) return;
    if (root_.empty() || stated->empty()) {
        value.value = *stated;
        return;
    }
    const std::string& pointer = settings_.at(std::string(info.name)).pointer;
    const auto folder = std::filesystem::path(file_).parent_path();
    const std::filesystem::path found = resolve_inside(root_, folder, *stated, file_, pointer);
    std::error_code failed;
    if (!std::filesystem::is_regular_file(found, failed))
        throw Error({.what = fmt::format("there is no file \"{}\"", *stated),
                     .file = file_,
                     .pointer = pointer,
                     .expected = expected});
    value.value = std::filesystem::absolute(found).string();
}

void ParamReader::refuse_unknown() const
{
    for (const auto& [name, setting] : settings_) {
        if (std::find(visited_.begin(), visited_.end(), name) != visited_.end()) continue;
        throw Error({.what = "there is no parameter \"" + name + '"',
                     .file = file_,
                     .pointer = setting.pointer,
                     .expected = fmt::format("one of: {}", fmt::join(visited_, ", "))});
    }
}

bool parse_colour(const std::string& text, glm::vec3& colour)
{
    if (text.size() != 7 || text[0] != '#') return false;
    std::uint32_t rgb = 0;
    const auto [end, status] = std::from_chars(text.data() + 1, text.data() + 7, rgb, 16);
    if (status != std::errc() || end != text.data() + 7) return false;
    colour = glm::vec3((rgb >> 16) & 0xff, (rgb >> 8) & 0xff, rgb & 0xff) / 255.0f;
    return true;
}

}  // namespace hw
