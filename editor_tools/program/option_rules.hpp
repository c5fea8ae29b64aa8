#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "program/command_line.hpp"

namespace hw {

// Text that is no number, or NaN, is in no range.
OptionRule number_in(double least, double most);
OptionRule whole_number_in(std::int64_t least, std::int64_t most);
OptionRule one_of(const std::vector<std::string>& words);

}  // namespace hw
