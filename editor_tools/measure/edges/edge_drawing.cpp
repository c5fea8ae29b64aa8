#include "measure/edges/edge_drawing.hpp"

#include <algorithm>
#include <glm/common.hpp>

namespace hw {

EdgeDrawing::EdgeDrawing(Context& context, const PluginRegistry& plugins, const Scene& scene,
                         std::span<const MeshChunks> chunks)
    : renderer_(context), set_(plugins, [this](const std::filesystem::path& folder) -> ProgramCache& {
          return renderer_.program_cache(folder);
      })
{
    style_.prepare(renderer_.program_cache({}));
    SceneInput input;
    input.scene = &scene;
    input.styles = {{"plain", &style_}};
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

IdImage EdgeDrawing::ids(const ImageKey& key, glm::ivec2 size_px)
{
    IdImage image{size_px, {}, {}};
    for (const glm::uvec4& texel : renderer_.read_image(key)) image.ids.push_back(texel.x);
    for (const glm::uvec4& texel : renderer_.read_image(key, 1)) image.planes.push_back(glm::uintBitsToFloat(texel));
    return image;
}

double EdgeDrawing::plain_s(const View& view)
{
    style_.is_drawn = true;
    const auto once = [&] { return renderer_.draw(view, {.samples = 1, .is_timed = true}).surfaces_ms / 1000.0; };
    const double first_s = once();
    const double least_s = std::min(first_s, once());
    style_.is_drawn = false;
    return least_s;
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
