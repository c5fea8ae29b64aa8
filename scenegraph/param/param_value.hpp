#pragma once

#include <map>
#include <string>
#include <variant>

namespace hw {

/// A parameter's value as a file states it, before anyone knows its range. Colours and choices are strings.
using ParamValue = std::variant<bool, double, std::string>;

/// One stated parameter and where it stands, for messages.
struct ParamSetting {
    ParamValue value;
    std::string pointer;  ///< JSON pointer, such as "/styles/assumed/crease_deg".
};

/// Stated parameters by name.
using ParamSettings = std::map<std::string, ParamSetting>;

}  // namespace hw
