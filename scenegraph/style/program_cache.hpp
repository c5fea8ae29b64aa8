#pragma once

#include <cstdint>
#include <string_view>

#include "hatchway/style/target.hpp"

namespace hw {

/// A compiled program, owned by the host. It does what it was made for (faces, full-screen passes or lines), nothing
/// else.
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

    /// A pen for Pass::lines(): the engine's vertex stage (lines/line_quad.vert) and this fragment stage, which
    /// includes line_pen.glsl.
    virtual Program line(std::string_view fragment_file, std::string_view defines = {}) = 0;

    /// A texture of the style's own, PNG or JPEG: a file of the style's folder or else of the shared maps, or an
    /// absolute path as a parameter of the kind image holds it. Gray files are linear, of one channel; others are sRGB.
    /// Repeats, has all levels of detail, is read once and lives as long as the host. Throws hw::Error when it is
    /// missing, leads out of the folder, is damaged or too large.
    virtual Image texture(std::string_view file) = 0;
};

}  // namespace hw
