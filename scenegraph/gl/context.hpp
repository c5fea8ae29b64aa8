#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <vector>

namespace hw {

/// What a device is taken for: see DeviceInfo::is_software.
enum class DeviceKind : unsigned char { as_found, software, hardware };

/// What contexts that are made from now on, in the whole process, take their devices for.
void take_devices_for(DeviceKind kind);

/// What the device can do, as far as the engine asks.
struct DeviceInfo {
    std::string vendor;
    std::string renderer;
    std::string version;
    bool is_software = false;        ///< Taken for a software renderer: what a GPU does for nothing costs time there.
    bool is_es = false;              ///< OpenGL ES 3; else desktop OpenGL 3.3 core or later.
    float max_line_width_px = 1.0f;  ///< Widest aliased line that may be drawn.
    float max_point_size_px = 1.0f;
    int max_samples = 1;
    int max_texture_side = 2048;
    bool has_float_targets = false;  ///< Can draw into float formats: always on the desktop, an extension on ES.
};

/// A current OpenGL context. Every GL object must go before its context goes. One thread.
class Context {
 public:
    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    virtual void make_current() = 0;
    /// Size of the window's own framebuffer; zero for a headless context, which has none.
    virtual glm::ivec2 framebuffer_size_px() const = 0;

    const DeviceInfo& device() const { return device_; }
    /// GL errors since the last call: messages of KHR_debug where the driver has it, else of glGetError. Tests fail on
    /// any.
    std::vector<std::string> take_errors();

 protected:
    Context() = default;
    /// Call once with the context current.
    void start();

 private:
    DeviceInfo device_;
    std::unique_ptr<std::vector<std::string>> messages_ = std::make_unique<std::vector<std::string>>();
    bool has_debug_messages_ = false;
};

}  // namespace hw
