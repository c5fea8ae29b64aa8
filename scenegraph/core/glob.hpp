#pragma once

#include <string>
#include <string_view>

namespace hw {

/// Whether `text` matches a shell pattern: `*` any run of characters without '/', `**` any run with it, `?` one
/// character, `[a-c]` and `[!a-c]` a class; neither is '/'. The pattern "*" alone matches everything, so that "*" means
/// all objects. Linear memory, no recursion over input; at worst |pattern| x |text| steps.
bool glob_matches(std::string_view pattern, std::string_view text);

/// What is wrong with a pattern that a person wrote: a class that is never closed. Empty when nothing is.
std::string glob_fault(std::string_view pattern);

}  // namespace hw
