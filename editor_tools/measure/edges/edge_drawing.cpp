#include "measure/edges/edge_drawing.hpp"

#include <algorithm>

namespace hw {

EdgeDrawing::EdgeDrawing(Context& context, const PluginRegistry& plugins, const Scene& scene,
                         std::span<const MeshChunks> chunks)
    : renderer_(context), set_(plugins, [this](const std::filesystem::path& folder) -> ProgramCache& {
          return renderer_.program_cache(folder);
      })
{
    SceneInput input;
    input.scene = &scene;
    input.styles = {{"none", &style_}};
    input.objects.assign(scene.objects.size(), StyledObject{.style = 0});
    input.chunks = chunks;
    input.image_passes = set_.image_passes();
    renderer_.load(std::move(input));
}

Pixels EdgeDrawing::draw(const View& view, const ImageKey& key, double* images_s)
{
    FrameOptions options{.samples = 1, .is_timed = true};
    options.shown_image = key;
    const double first_s = renderer_.draw(view, options).images_ms / 1000.0;
    if (images_s != nullptr) *images_s = std::min(first_s, renderer_.draw(view, options).images_ms / 1000.0);
    return renderer_.read_picture();
}

View turned(const View& view)
{
    // x right becomes y up: (x, y) to (-y, x).
    const glm::mat4 quarter({0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1});
    View result = view;
    result.view_from_world = quarter * view.view_from_world;
    std::swap(result.clip_from_view[0][0], result.clip_from_view[1][1]);
    std::swap(result.size_px.x, result.size_px.y);
    return result;
}

Pixels turned(const Pixels& picture)
{
    Pixels result{picture.height, picture.width, picture.channels, {}};
    result.bytes.resize(picture.bytes.size());
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            std::copy_n(picture.at(x, y), picture.channels, result.at(y, picture.width - 1 - x));
    return result;
}

}  // namespace hw
