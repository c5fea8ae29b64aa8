#include "measure/edges/edge_drawing.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include "measure/lines/line_style.hpp"

namespace hw {

namespace {

/// The least of three, since other work of the machine only adds.
template <typename Time>
double least_of_three(Time time)
{
    double least = time();
    for (int i = 0; i < 2; ++i) least = std::min(least, time());
    return least;
}

}  // namespace

EdgeDrawing::EdgeDrawing(Context& context, const PluginRegistry& plugins, const Scene& scene,
                         std::span<const MeshChunks> chunks)
    : renderer_(context),
      set_(plugins,
           [this](const std::filesystem::path& folder) -> ProgramCache& { return renderer_.program_cache(folder); }),
      objects_(scene.objects.size())
{
    line_style_.needed.edges =
        EdgeNeed{.crease_rad = static_cast<float>(glm::radians(kMeasuredCreaseDeg)), .intersections = true};
    line_style_.is_drawn = true;
    for (PlainStyle* style : {&style_, &line_style_}) style->prepare(renderer_.program_cache({}));
    SceneInput input;
    input.scene = &scene;
    input.styles = {{"plain", &style_}};
    input.objects.assign(objects_, StyledObject{.style = 0});
    input.chunks = chunks;
    input.image_passes = set_.image_passes();
    renderer_.load(std::move(input));
}

void EdgeDrawing::wear(bool has_lines)
{
    renderer_.set_looks({{"only", has_lines ? &line_style_ : &style_}},
                        std::vector<StyledObject>(objects_, StyledObject{.style = 0}));
}

Pixels EdgeDrawing::draw(const View& view, const ImageKey& key, double* images_s)
{
    FrameOptions options{.samples = 1, .is_timed = true};
    options.shown_image = key;
    const auto once = [&] { return renderer_.draw(view, options).images_ms / 1000.0; };
    if (images_s != nullptr)
        *images_s = least_of_three(once);
    else
        once();
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
    const double least_s =
        least_of_three([&] { return renderer_.draw(view, {.samples = 1, .is_timed = true}).surfaces_ms / 1000.0; });
    style_.is_drawn = false;
    return least_s;
}

Pixels EdgeDrawing::object_lines(const View& view, double* lines_s)
{
    const auto frame_s = [&] { return renderer_.draw(view, {.samples = 1, .is_timed = true}).total_ms / 1000.0; };
    const auto least_s = [&] { return lines_s != nullptr ? least_of_three(frame_s) : frame_s(); };
    style_.is_drawn = true;
    const double plain_s = least_s();
    style_.is_drawn = false;
    const Pixels plain = renderer_.read_picture();
    wear(true);
    // Faces are drawn, since they hide lines; what is darker than they are is a line.
    Pixels map = plain;
    const auto draw_into = [&](std::size_t channel) {
        renderer_.draw(view, {.samples = 1});
        const Pixels picture = renderer_.read_picture();
        for (std::size_t i = channel; i < map.bytes.size(); i += 3)
            map.bytes[i] = static_cast<std::uint8_t>(255 * picture.bytes[i] / std::max<int>(plain.bytes[i], 1));
    };
    // One after the other: where lines cross, none hides the other.
    LineLook all;
    all.all({.width_px = 1.0f}).far.is_on = false;
    LineLook inner = all, profiles = all;
    for (int i = 0; i < kLineClassCount; ++i) {
        const auto line_class = static_cast<LineClass>(i);
        (is_contour(line_class) ? inner : profiles)[line_class].is_drawn = false;
    }
    line_style_.look = inner;
    draw_into(0);
    line_style_.look = profiles;
    draw_into(1);
    line_style_.look = all;
    if (lines_s != nullptr) *lines_s = least_s() - plain_s;
    wear(false);
    return map;
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
