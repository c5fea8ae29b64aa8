#include "hatchway/io/gltf/check/property_rules.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "hatchway/core/error.hpp"
#include "hatchway/io/json/text.hpp"

namespace hw {
namespace {

using nlohmann::json;

class RuleChecker {
 public:
    RuleChecker(const json& document, const std::string& file) : document_(document), file_(file) {}

    void check_object(json& value, const std::string& pointer, std::span<const PropertyRule> rules)
    {
        if (!value.is_object()) refuse(value, pointer, "an object");
        for (const PropertyRule& rule : rules) {
            const auto found = value.find(rule.name);
            if (found != value.end())
                check(*found, pointer_to(pointer, rule.name), rule);
            else if (rule.is_required)
                throw Error({.what = fmt::format("\"{}\" is missing", rule.name), .file = file_, .pointer = pointer});
        }
    }

 private:
    [[noreturn]] void refuse(const json& value, const std::string& pointer, const std::string& expected) const
    {
        throw Error({.what = "stands " + described(value), .file = file_, .pointer = pointer, .expected = expected});
    }

    void check(json& value, const std::string& pointer, const PropertyRule& rule)
    {
        switch (rule.kind) {
            case RuleKind::flag:
                if (!value.is_boolean()) refuse(value, pointer, "true or false");
                break;
            case RuleKind::text:
                check_text(value, pointer, rule);
                break;
            case RuleKind::real:
                check_real(value, pointer, rule);
                break;
            case RuleKind::whole:
                check_whole(value, pointer, rule);
                break;
            case RuleKind::reference:
                check_reference(value, pointer, rule);
                break;
            case RuleKind::object:
                check_object(value, pointer, rule.members);
                break;
            case RuleKind::reals:
            case RuleKind::references:
            case RuleKind::named_references_list:
            case RuleKind::objects:
                check_array(value, pointer, rule);
                break;
            case RuleKind::named_references:
                check_named_references(value, pointer, rule);
                break;
        }
    }

    void check_text(const json& value, const std::string& pointer, const PropertyRule& rule) const
    {
        if (!value.is_string()) refuse(value, pointer, "a text");
        const std::string& text = value.get_ref<const std::string&>();
        if (rule.texts.empty() || std::ranges::find(rule.texts, text) != rule.texts.end()) return;
        refuse(value, pointer, fmt::format("one of: {}", fmt::join(rule.texts, ", ")));
    }

    void check_real(const json& value, const std::string& pointer, const PropertyRule& rule) const
    {
        const double number = value.is_number() ? value.get<double>() : std::nan("");
        if (!(number >= rule.min && number <= rule.max))
            refuse(value, pointer, fmt::format("a number from {} to {}", rule.min, rule.max));
    }

    void check_whole(json& value, const std::string& pointer, const PropertyRule& rule) const
    {
        const double number = value.is_number() ? value.get<double>() : std::nan("");
        if (!(number >= rule.min && number <= rule.max && number == std::floor(number)))
            refuse(value, pointer, fmt::format("a whole number from {:.0f} to {:.0f}", rule.min, rule.max));
        if (!rule.wholes.empty() && std::ranges::find(rule.wholes, number) == rule.wholes.end())
            refuse(value, pointer, fmt::format("one of: {}", fmt::join(rule.wholes, ", ")));
        if (value.is_number_float()) value = static_cast<std::int64_t>(number);
    }

    void check_reference(json& value, const std::string& pointer, const PropertyRule& rule) const
    {
        const json::json_pointer place{std::string(rule.target)};
        const std::size_t size = document_.contains(place) ? document_.at(place).size() : 0;
        const std::string expected = size == 0 ? fmt::format("no reference: {} holds nothing", rule.target)
                                               : fmt::format("an index into {}, 0 to {}", rule.target, size - 1);
        const double number = value.is_number() ? value.get<double>() : -1.0;
        if (!(number >= 0.0 && number < static_cast<double>(size) && number == std::floor(number)))
            refuse(value, pointer, expected);
        if (value.is_number_float()) value = static_cast<std::int64_t>(number);
    }

    void check_named_references(json& value, const std::string& pointer, const PropertyRule& rule) const
    {
        if (!value.is_object()) refuse(value, pointer, "an object");
        for (const auto& [name, element] : value.items()) check_reference(element, pointer_to(pointer, name), rule);
    }

    void check_array(json& value, const std::string& pointer, const PropertyRule& rule)
    {
        if (!value.is_array()) refuse(value, pointer, "an array");
        if (value.size() < rule.min_size || value.size() > rule.max_size)
            refuse(value, pointer, fmt::format("{} to {} elements", rule.min_size, rule.max_size));
        for (std::size_t i = 0; i < value.size(); ++i) {
            const std::string place = pointer_to(pointer, i);
            if (rule.kind == RuleKind::objects)
                check_object(value[i], place, rule.members);
            else if (rule.kind == RuleKind::references)
                check_reference(value[i], place, rule);
            else if (rule.kind == RuleKind::named_references_list)
                check_named_references(value[i], place, rule);
            else
                check_real(value[i], place, rule);
        }
    }

    const json& document_;
    const std::string& file_;
};

}  // namespace

void check_rules(json& document, std::span<const PropertyRule> rules, const std::string& file)
{
    RuleChecker(document, file).check_object(document, "", rules);
}

}  // namespace hw
