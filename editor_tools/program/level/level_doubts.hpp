#pragma once

#include <string>
#include <vector>

#include "hatchway/world/level.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// What is no error in a level, but surely not meant: rules that name nothing in the model, or say nothing.
std::vector<std::string> level_doubts(const Level& level, const Scene& scene);

/// Warns of those of the command line's `style_count` --style rules, which are a level's last, that name nothing.
void warn_of_idle_styles(const Level& level, const Scene& scene, std::size_t style_count);

}  // namespace hw
