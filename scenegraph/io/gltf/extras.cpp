#include "hatchway/io/gltf/extras.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "hatchway/core/error.hpp"
#include "hatchway/io/json/text.hpp"

namespace hw {
namespace {

using nlohmann::json;

constexpr std::string_view kPrefix = "hatchway.";
constexpr std::size_t kMostKinds = 20;  // a stranger's model may be wrong in any number of ways

std::optional<double> number_in(const json& value)
{
    if (value.is_number()) return value.get<double>();
    if (!value.is_string()) return std::nullopt;
    std::string_view text = value.get_ref<const std::string&>();
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    double number = 0.0;
    const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_read = status == std::errc() && stop == text.data() + text.size() && std::isfinite(number);
    return is_read ? std::optional(number) : std::nullopt;
}

}  // namespace

void ExtrasReader::doubt(const std::string& what, const std::string& pointer)
{
    if (places_.size() >= kMostKinds && !places_.contains(what)) {
        ++untold_;
        return;
    }
    Place& place = places_[what];
    if (place.count++ == 0) place.pointer = pointer;
}

void ExtrasReader::read_property(const json& value, const std::string& name, const std::string& pointer, Node& node)
{
    if (name == "style") {
        if (!value.is_string())
            doubt(described(value) + " is no style; expected a name", pointer);
        else if (!value.get_ref<const std::string&>().empty())
            node.style = value.get<std::string>();
    } else if (name == "certainty") {
        const std::optional<double> number = number_in(value);
        if (!number || !(*number >= 0.0 && *number <= 1.0))
            doubt(described(value) + " is no certainty; expected a number from 0 to 1", pointer);
        if (number) node.certainty = static_cast<float>(std::clamp(*number, 0.0, 1.0));
    } else {
        doubt(fmt::format("there is no property \"{}\"; expected style or certainty", name), pointer);
    }
}

void ExtrasReader::read(const json& stated, const std::string& pointer, Node& node)
{
    const auto extras = stated.find("extras");
    if (extras == stated.end() || !extras->is_object()) return;
    const std::string place = pointer + "/extras";
    // From what wins least to what wins most.
    if (const auto plain = extras->find("certainty"); plain != extras->end())
        read_property(*plain, "certainty", place + "/certainty", node);
    for (const auto& [name, value] : extras->items())
        if (name.starts_with(kPrefix)) read_property(value, name.substr(kPrefix.size()), pointer_to(place, name), node);
    const auto nested = extras->find("hatchway");
    if (nested == extras->end()) return;
    if (!nested->is_object())
        return doubt(described(*nested) + " stands for style and certainty; expected an object", place + "/hatchway");
    for (const auto& [name, value] : nested->items())
        read_property(value, name, pointer_to(place + "/hatchway", name), node);
}

std::vector<std::string> ExtrasReader::doubts() const
{
    std::vector<std::string> texts;
    for (const auto& [what, place] : places_) {
        const std::string more = place.count == 1 ? "" : fmt::format(" (and {} more such nodes)", place.count - 1);
        texts.emplace_back(Error({.what = what + more, .file = file_, .pointer = place.pointer}).what());
    }
    if (untold_ > 0) texts.push_back(fmt::format("{}: {} more properties of nodes are not understood", file_, untold_));
    return texts;
}

}  // namespace hw
