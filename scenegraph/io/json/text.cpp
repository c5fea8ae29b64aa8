#include "hatchway/io/json/text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <unordered_set>

#include "hatchway/core/error.hpp"
#include "hatchway/core/limits.hpp"

namespace hw {
namespace {

constexpr std::size_t kShownTextLength = 60;

/// Reads JSON without building it, and remembers where it is: so it can stop in time at what a DOM parser would accept
/// (deep nesting, repeated keys) and name the place of what it would not.
class PlaceTracker final : public nlohmann::json_sax<nlohmann::json> {
 public:
    bool null() override { return enter_value(); }
    bool boolean(bool) override { return enter_value(); }
    bool number_integer(number_integer_t) override { return enter_value(); }
    bool number_unsigned(number_unsigned_t) override { return enter_value(); }
    bool number_float(number_float_t, const string_t&) override { return enter_value(); }
    bool string(string_t&) override { return enter_value(); }
    bool binary(binary_t&) override { return enter_value(); }

    bool start_object(std::size_t) override { return open(false); }
    bool start_array(std::size_t) override { return open(true); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override
    {
        Level& level = levels_.back();
        level.key = name;
        level.is_past_first = true;
        if (level.keys.insert(name).second) return true;
        what_ = "the key \"" + name + "\" stands here twice";
        return false;
    }

    bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception& error) override
    {
        // An element that cannot be read has not been counted yet.
        if (!levels_.empty() && levels_.back().is_array) enter_value();
        const std::string_view message = error.what();
        const std::size_t prefix_end = message.find("] ");
        what_ = "is no JSON: " + std::string(message.substr(prefix_end == message.npos ? 0 : prefix_end + 2));
        return false;
    }

    const std::string& what() const { return what_; }
    std::string pointer() const
    {
        std::string text;
        for (const Level& level : levels_) {
            if (!level.is_past_first) break;
            text = level.is_array ? pointer_to(text, level.index) : pointer_to(text, level.key);
        }
        return text;
    }

 private:
    struct Level {
        bool is_array = false;
        bool is_past_first = false;
        std::size_t index = 0;
        std::string key;
        std::unordered_set<std::string> keys;
    };

    bool enter_value()
    {
        if (levels_.empty() || !levels_.back().is_array) return true;
        if (levels_.back().is_past_first) ++levels_.back().index;
        levels_.back().is_past_first = true;
        return true;
    }
    bool open(bool is_array)
    {
        enter_value();
        if (levels_.size() >= static_cast<std::size_t>(limits::kMaxJsonDepth)) {
            what_ = fmt::format("is nested over {} deep", limits::kMaxJsonDepth);
            return false;
        }
        levels_.emplace_back();
        levels_.back().is_array = is_array;
        return true;
    }
    bool close()
    {
        levels_.pop_back();
        return true;
    }

    std::vector<Level> levels_;
    std::string what_;
};

std::string shown(const std::string& text)
{
    return text.size() <= kShownTextLength ? text : text.substr(0, kShownTextLength) + "...";
}

}  // namespace

nlohmann::json parse_json(std::string_view text, const std::string& file, JsonComments comments)
{
    const bool are_comments_allowed = comments == JsonComments::allowed;
    PlaceTracker tracker;
    if (!nlohmann::json::sax_parse(text, &tracker, nlohmann::json::input_format_t::json, true, are_comments_allowed))
        throw Error({.what = tracker.what(), .file = file, .pointer = tracker.pointer()});
    return nlohmann::json::parse(text, nullptr, true, are_comments_allowed);
}

std::string pointer_to(const std::string& pointer, std::string_view member)
{
    std::string text = pointer + '/';
    for (const char c : member) {
        if (c == '~')
            text += "~0";
        else if (c == '/')
            text += "~1";
        else
            text += c;
    }
    return text;
}

std::string pointer_to(const std::string& pointer, std::size_t element)
{
    return pointer + '/' + std::to_string(element);
}

std::string described(const nlohmann::json& value)
{
    using Type = nlohmann::json::value_t;
    switch (value.type()) {
        case Type::object:
            return "an object";
        case Type::array:
            return fmt::format("an array of {}", value.size());
        case Type::string:
            return "the text \"" + shown(value.get_ref<const std::string&>()) + '"';
        case Type::boolean:
            return value.get<bool>() ? "true" : "false";
        case Type::null:
            return "null";
        default:
            return "the number " + value.dump();
    }
}

}  // namespace hw
