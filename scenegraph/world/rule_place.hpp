#pragma once

#include <string>

#include "hatchway/world/level.hpp"

namespace hw {

/// Where a key of a rule stands, for messages: "/assign/0/style". A rule of the command line is named by its option.
inline std::string place_in(const AssignRule& rule, const std::string& key)
{
    return rule.pointer.starts_with('/') ? rule.pointer + '/' + key : rule.pointer;
}

}  // namespace hw
