#include "hatchway/param/param_rules.hpp"

#include <fmt/format.h>

#include <cmath>

#include "hatchway/core/lower_snake.hpp"

namespace hw {
namespace {

bool is_parameter_name(std::string_view name)
{
    return is_lower_snake(name) && name.front() >= 'a' && name.front() <= 'z' && name.back() != '_' &&
           name.find("__") == std::string_view::npos;
}

}  // namespace

void ParamRules::object(const ParamInfo& info, const std::string& what)
{
    broken_.push_back(fmt::format("the parameter \"{}\" {}", info.name, what));
}

void ParamRules::check(const ParamInfo& info)
{
    if (!is_parameter_name(info.name)) object(info, "is not named in lower_snake_case");
    if (info.name == "plugin" || info.name == "like") object(info, "has a name that level files use themselves");
    if (!names_.insert(std::string(info.name)).second) object(info, "is visited twice");
    if (info.help.empty()) object(info, "has no sentence of help");
}

void ParamRules::check_range(const ParamInfo& info, double value, double min, double max)
{
    check(info);
    if (!std::isfinite(min) || !std::isfinite(max) || !(min < max))
        return object(info, fmt::format("has the range {:g} to {:g}", min, max));
    if (!(value >= min && value <= max))
        object(info, fmt::format("has the default {:g}, outside of its range {:g} to {:g}", value, min, max));
}

void ParamRules::real(const ParamInfo& info, float& value, float min, float max)
{
    check_range(info, value, min, max);
}

void ParamRules::whole(const ParamInfo& info, int& value, int min, int max)
{
    check_range(info, value, min, max);
}

void ParamRules::flag(const ParamInfo& info, bool&)
{
    check(info);
}

void ParamRules::colour(const ParamInfo& info, glm::vec3& value)
{
    check(info);
    for (int i = 0; i < 3; ++i)
        if (!(value[i] >= 0.0f && value[i] <= 1.0f))
            return object(info,
                          fmt::format("has the default {:g} in a channel, outside of its range 0 to 1", value[i]));
}

void ParamRules::map(const ParamInfo& info, MapName&, MapKind)
{
    check(info);
}

void ParamRules::image(const ParamInfo& info, ImageFile&)
{
    check(info);
}

void ParamRules::choice_of(const ParamInfo& info, int& index, std::span<const std::string_view> names)
{
    check(info);
    if (index < 0 || index >= static_cast<int>(names.size()))
        object(info, fmt::format("has the default {} of {} names", index, names.size()));
    if (std::set(names.begin(), names.end()).size() < names.size()) object(info, "has two choices of one name");
}

}  // namespace hw
