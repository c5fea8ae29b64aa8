#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "hatchway/io/json/fwd.hpp"

namespace hw {

/// What glTF allows for one property of an object. Private to io.
enum class RuleKind : unsigned char {
    flag,
    text,
    real,                   ///< A finite number in [min, max].
    whole,                  ///< The same, whole.
    reals,                  ///< An array of numbers, each in [min, max], of min_size to max_size elements.
    reference,              ///< An index into the array `target`.
    references,             ///< An array of them.
    named_references,       ///< An object of them.
    named_references_list,  ///< An array of such objects.
    object,                 ///< An object that obeys `members`.
    objects,                ///< An array of at most max_size of them.
};

struct PropertyRule {
    std::string_view name;
    RuleKind kind = RuleKind::flag;
    bool is_required = false;
    double min = -1e300;
    double max = 1e300;
    std::size_t min_size = 0;
    std::size_t max_size = 1'000'000;
    std::string_view target = {};                  ///< JSON pointer of the array that a reference points into.
    std::span<const PropertyRule> members = {};    ///< Of object and objects.
    std::span<const std::string_view> texts = {};  ///< The allowed texts; empty: any.
    std::span<const int> wholes = {};              ///< The allowed whole numbers; empty: any.
};

/// Checks a document against rules: types, ranges, required properties and references. Unknown properties pass. Whole
/// numbers that are written as 1.0 become whole. Throws hw::Error with the JSON pointer.
void check_rules(nlohmann::json& document, std::span<const PropertyRule> rules, const std::string& file);

}  // namespace hw
