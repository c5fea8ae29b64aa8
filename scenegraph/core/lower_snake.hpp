#pragma once

#include <algorithm>
#include <string_view>

namespace hw {

/// Whether a name is of a-z, 0-9 and _ alone, and not empty: those of plugins and of built-in maps, which become file
/// names.
inline bool is_lower_snake(std::string_view name)
{
    const auto is_allowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
    return !name.empty() && std::all_of(name.begin(), name.end(), is_allowed);
}

}  // namespace hw
