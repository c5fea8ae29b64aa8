#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "hatchway/core/pixels.hpp"
#include "hatchway/render/device/program_store.hpp"
#include "hatchway/render/device/texture_store.hpp"
#include "hatchway/render/view/frame_options.hpp"
#include "hatchway/render/view/frame_stats.hpp"
#include "hatchway/render/view/scene_input.hpp"

namespace hw {

class Context;

/// Draws frames of one scene into a picture of its own. Needs its context to be current in every call.
class Renderer {
 public:
    /// `read_image` decodes textures that styles bring along; without one, they are refused.
    explicit Renderer(Context& context, ImageReader read_image = {});
    ~Renderer();

    /// The cache to prepare styles with. `style_folder` holds the style's own shaders.
    ProgramCache& program_cache(const std::filesystem::path& style_folder);
    /// Compiles all programs anew from their files. Throws hw::Error for the first that fails; each keeps its last good
    /// text.
    void reload_shaders();

    /// Takes a scene: uploads what its styles need. Throws hw::Error when the device cannot hold it.
    void load(SceneInput input);
    /// Of the scene that was loaded; null for none. Changes no pixel. Must outlive its use.
    void set_visibility(const Visibility* visibility);
    /// Changes the looks alone (a style swapped, an object's style cycled); meshes, textures and shadows stay.
    void set_looks(std::vector<NamedStyle> styles, std::vector<StyledObject> objects);

    /// Draws a frame. Deterministic: depends on the scene and these arguments alone. Never throws for a style's fault;
    /// throws hw::Error when FrameOptions::shown_image names an image that nobody makes.
    FrameStats draw(const View& camera, const FrameOptions& options);

    /// What has gone wrong in frames without ending them, and in rehearsals what styles say in vain (an image without a
    /// need, a uniform that no shader has): each text once.
    std::vector<std::string> remarks() const;
    /// The shaders of styles and image passes as they have been compiled by now, with each combination of features.
    std::vector<ProgramText> style_shaders() const;

    /// The last picture, RGB, sRGB, top row first.
    Pixels read_picture();
    /// What the last frame made of an image of floats or whole numbers: the bits of four a pixel, rows from the bottom.
    /// Empty when it made none of that key.
    std::vector<glm::uvec4> read_image(const ImageKey& key, std::size_t output = 0);
    /// Shows the last picture, or white paper where there is none, in the context's window, scaled to fit, and over it
    /// words in the window's own pixels: they stay sharp where the picture is drawn smaller, and are no part of it.
    /// `px_scale`: device pixels for a logical one.
    void present(const Overlay& overlay = {}, float px_scale = 1.0f);

 private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace hw
