#pragma once

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "hatchway/world/scene.hpp"

/// What a fuzzer of one kind of file is made of. fuzz_NAME.cpp defines try_bytes(); target.cpp calls it for libFuzzer
/// and for mutate.cpp alike; corpus/NAME holds files to begin with.
namespace hw::fuzz {

/// Takes any bytes, or refuses them by a hw::Error of wrong input. What is taken is used as the program uses it.
void try_bytes(std::string_view bytes);

/// How many inputs were taken so far, and why the last one was not.
inline std::uint64_t taken = 0;
inline std::string refusal;

/// What must hold for whatever was taken. Stops the fuzzer.
inline void require(bool holds)
{
    if (!holds) std::abort();
}

/// What opening does with every model: settles its meshes and finds their edges.
void use_model(Scene scene);

/// Reads the bytes as a file that has no name of a format, and uses it.
void use_gltf(std::string_view bytes);

/// The bytes of a good file, changed as `patches` say: for files that are signed or that each version writes in another
/// way, so that no corpus could hold them. A patch is what to do (0 replace, 1 insert, 2 erase, 3 cut), a place of two
/// bytes, low one first, and a count; to replace or insert, as many bytes follow.
std::string patched(std::string good, std::string_view patches);

}  // namespace hw::fuzz
