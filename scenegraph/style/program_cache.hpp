#pragma once

#include <cstdint>
#include <string_view>

namespace hw {

/// A compiled program, owned by the host.
struct Program {
    std::uint32_t id = 0;
    bool is_valid() const { return id != 0; }
};

/// Compiles shaders, each text once. File names are looked for in the style's own folder, in the kit, then among the
/// engine's shaders; "#include" works the same way. Throws hw::Error with file and line when a shader does not compile.
class ProgramCache {
 public:
    virtual ~ProgramCache() = default;

    /// Draws objects' faces: the engine's vertex stage (surface.vert) and this fragment stage. `defines` is put before
    /// the text, such as "#define TONE_SHADED 1\n".
    virtual Program surface(std::string_view fragment_file, std::string_view defines = {}) = 0;

    /// A full-screen pass: the engine's vertex stage (full_screen.vert) and this fragment stage.
    virtual Program full_screen(std::string_view fragment_file, std::string_view defines = {}) = 0;
};

}  // namespace hw
