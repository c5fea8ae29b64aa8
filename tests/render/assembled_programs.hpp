#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "hatchway/gl/shader_text.hpp"

namespace hw::test {

/// The stages of a program as a renderer assembles them, without a device.
struct AssembledProgram {
    std::string name;  ///< Its fragment shader, and what was switched on.
    ShaderText vertex;
    ShaderText fragment;
};

/// The programs of the engine, the plugins, the examples of the manual and the tests: those of surfaces with each named
/// combination of features and others at random, those of lines with and without presence and strokes. Each also with
/// the define lines that the C++ beside it gives to it, alone and in pairs.
void for_each_program(const std::function<void(const AssembledProgram&)>& take);

}  // namespace hw::test
