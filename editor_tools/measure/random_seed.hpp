#pragma once

#include <cstdint>

#include "program/command_line.hpp"
#include "program/option_rules.hpp"

namespace hw {

/// --seed for a measurement that draws by lot: `drawn` says what. The same seed draws the same.
inline void add_seed(CommandLine command, std::uint32_t& seed, const std::string& drawn)
{
    command.add_option("--seed", seed, "Another one draws other " + drawn + "; " + std::to_string(seed))
        .option_text("N")
        .check(whole_number_in(1, 1'000'000));
}

}  // namespace hw
