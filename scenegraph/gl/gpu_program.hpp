#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

#include "hatchway/gl/shader_text.hpp"

namespace hw {

/// The binding point of the uniform block HwFrame in every program.
inline constexpr int kFrameBlockIndex = 0;

/// A linked program. Move-only. Samplers are numbered at link time in the order that the linker lists them.
class GpuProgram {
 public:
    GpuProgram() = default;
    /// Throws hw::Error with file and line when a stage does not compile or the stages do not fit.
    GpuProgram(const ShaderText& vertex, const ShaderText& fragment, bool is_es);
    ~GpuProgram();
    GpuProgram(GpuProgram&& other) noexcept;
    GpuProgram& operator=(GpuProgram&& other) noexcept;

    /// -1 where the program has no such uniform; setting -1 does nothing.
    int location(std::string_view name) const;
    /// The texture unit of a sampler; -1 where the program has none of that name.
    int unit(std::string_view sampler) const;

    // The program must be in use (GpuState::use).
    static void set(int location, float value);
    static void set(int location, int value);
    static void set(int location, const glm::vec2& value);
    static void set(int location, const glm::vec3& value);
    static void set(int location, const glm::vec4& value);
    static void set(int location, const glm::mat3& value);
    static void set(int location, const glm::mat4& value);
    static void set(int location, std::span<const float> values);
    static void set(int location, std::span<const glm::vec3> values);

    std::uint32_t id() const { return id_; }

 private:
    void link(const ShaderText& vertex, const ShaderText& fragment, bool is_es);
    void list_uniforms();

    std::uint32_t id_ = 0;
    std::unordered_map<std::string, int> locations_;
    std::unordered_map<std::string, int> units_;
};

}  // namespace hw
