#include "hatchway/core/unique_names.hpp"

#include <fmt/format.h>

namespace hw {

std::string UniqueNames::take(const std::string& wanted)
{
    if (taken_.insert(wanted).second) return wanted;
    int& next = next_.try_emplace(wanted, 2).first->second;
    while (true) {
        std::string name = fmt::format("{}_{}", wanted, next++);
        if (taken_.insert(name).second) return name;
    }
}

}  // namespace hw
