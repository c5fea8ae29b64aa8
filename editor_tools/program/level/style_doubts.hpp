#pragma once

#include <string>
#include <vector>

#include "hatchway/stage/stage.hpp"

namespace hw {

/// What is silently wrong in the styles that a level uses, each once: parameters against the rules, uniforms that no
/// shader has, images that no need names, styles that throw, shaders that OpenGL ES refuses. Draws one small picture of
/// the whole scene, so that each style is asked for all it does. Leaves the stage's context current.
std::vector<std::string> style_doubts(Context& context, Stage& stage);

}  // namespace hw
