#include "hatchway/render/overlay/overlay_drawer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "hatchway/render/overlay/font.hpp"
#include "hatchway/render/view/frame_block.hpp"

namespace hw {
namespace {

constexpr float kMargin = 4.0f;  // between text and the edge of its background, logical pixels

glm::ivec2 text_extent(const std::string& text)
{
    glm::ivec2 extent(0, 1);
    int column = 0;
    for (const char c : text) {
        column = c == '\n' ? 0 : column + 1;
        extent.y += c == '\n' ? 1 : 0;
        extent.x = std::max(extent.x, column);
    }
    return extent;
}

}  // namespace

OverlayDrawer::OverlayDrawer(ProgramStore& programs, GpuState& state) : programs_(programs), state_(state)
{
    const Pixels atlas = font_atlas();
    atlas_ = GpuTexture(
        {.format = TextureFormat::r8, .size_px = {atlas.width, atlas.height}, .filter = FilterMode::nearest});
    atlas_.upload(0, std::as_bytes(std::span(atlas.bytes)));
    buffer_.stream({});
    const auto stream = [&](VertexInput input, int components, std::size_t offset) {
        return VertexStream{input, &buffer_, components, static_cast<int>(sizeof(Vertex)), offset};
    };
    const std::array streams = {stream(VertexInput::position, 3, offsetof(Vertex, position)),
                                stream(VertexInput::uv0, 2, offsetof(Vertex, texel)),
                                stream(VertexInput::colour, 4, offsetof(Vertex, colour))};
    array_ = GpuVertexArray(streams, nullptr);
}

void OverlayDrawer::draw(const Overlay& overlay, glm::ivec2 size_px, float px_scale, TargetColours colours)
{
    colours_ = colours;
    vertices_.clear();
    for (const OverlayLine& line : overlay.lines) add_line(line, px_scale);
    for (const OverlayText& text : overlay.texts) add_text(text, size_px, px_scale);
    if (overlay.has_cross_hair) add_cross_hair(size_px, px_scale);
    if (vertices_.empty()) return;
    buffer_.stream(std::as_bytes(std::span(vertices_)));
    const LinkedProgram& program = programs_.engine("overlay/overlay.vert", "overlay/overlay.frag");
    state_.use(program.gpu);
    state_.apply(
        {.depth_test = DepthTest::off, .writes_depth = false, .blending = Blending::over, .culling = Culling::off});
    GpuProgram::set(program.gpu.location("hw_target_size_px"), glm::vec2(size_px));
    GpuProgram::set(program.gpu.location("hw_atlas_size"), glm::vec2(atlas_.desc().size_px));
    state_.bind_texture(program.gpu.unit("hw_atlas"), atlas_.id());
    state_.bind(array_);
    state_.draw(Primitive::triangles, 0, static_cast<std::uint32_t>(vertices_.size()));
}

glm::vec4 OverlayDrawer::target_colour(const glm::vec4& srgb) const
{
    if (colours_ == TargetColours::as_stored) return srgb;
    // Blended in linear light a dark background would look thin: cover as much as it would in sRGB.
    return glm::vec4(linear_from_srgb(glm::vec3(srgb)), 1.0f - std::pow(1.0f - srgb.a, 2.2f));
}

void OverlayDrawer::add_rectangle(const Rectangle& r, const glm::vec4& colour)
{
    const auto corner = [&](bool right, bool down) {
        return Vertex{glm::vec3(right ? r.max_px.x : r.min_px.x, down ? r.max_px.y : r.min_px.y, 0.0f),
                      {right ? r.max_texel.x : r.min_texel.x, down ? r.max_texel.y : r.min_texel.y},
                      colour};
    };
    for (const auto& [right, down] :
         {std::pair(false, false), {true, false}, {true, true}, {false, false}, {true, true}, {false, true}})
        vertices_.push_back(corner(right, down));
}

void OverlayDrawer::add_filled(glm::vec2 min_px, glm::vec2 max_px, const glm::vec4& colour)
{
    const glm::vec2 texel = glm::vec2(filled_cell() * kGlyphTexels) + 0.5f * glm::vec2(kGlyphTexels);
    add_rectangle({min_px, max_px, texel, texel}, colour);
}

void OverlayDrawer::add_line(const OverlayLine& line, float px_scale)
{
    const glm::vec2 from = line.from_px * px_scale;
    const glm::vec2 to = line.to_px * px_scale;
    const float length = glm::length(to - from);
    if (!(length > 0.0f)) return;
    const glm::vec2 along = (to - from) / length;
    const glm::vec2 side = 0.5f * std::max(line.width_px * px_scale, 1.0f) * glm::vec2(-along.y, along.x);
    const glm::vec2 texel = glm::vec2(filled_cell() * kGlyphTexels) + 0.5f * glm::vec2(kGlyphTexels);
    const glm::vec4 colour = target_colour(line.colour);
    for (const glm::vec2& corner : {from - side, to - side, to + side, from - side, to + side, from + side})
        vertices_.push_back({glm::vec3(corner, 0.0f), texel, colour});
}

void OverlayDrawer::add_text(const OverlayText& text, glm::ivec2 size_px, float px_scale)
{
    const glm::vec2 cell_px = glm::round(glm::vec2(kGlyphSize) * px_scale);
    const glm::vec2 extent_px = glm::vec2(text_extent(text.text)) * cell_px;
    glm::vec2 start = text.position_px * px_scale;
    if (text.position_px.x < 0.0f) start.x += static_cast<float>(size_px.x) - extent_px.x;
    if (text.position_px.y < 0.0f) start.y += static_cast<float>(size_px.y) - extent_px.y;
    start = glm::round(start);
    if (text.background.a > 0.0f)
        add_filled(start - kMargin * px_scale, start + extent_px + kMargin * px_scale, target_colour(text.background));
    const glm::vec4 colour = target_colour(text.colour);
    glm::vec2 pen = start;
    for (const char c : text.text) {
        if (c == '\n') {
            pen = {start.x, pen.y + cell_px.y};
            continue;
        }
        const glm::vec2 texel(glyph_cell(c) * kGlyphTexels);
        if (c != ' ') add_rectangle({pen, pen + cell_px, texel, texel + glm::vec2(kGlyphTexels)}, colour);
        pen.x += cell_px.x;
    }
}

void OverlayDrawer::add_cross_hair(glm::ivec2 size_px, float px_scale)
{
    const glm::vec2 middle = glm::floor(0.5f * glm::vec2(size_px));
    const float arm = 9.0f * px_scale;
    const float width = std::max(1.0f, px_scale);
    const glm::vec4 dark(0.0f, 0.0f, 0.0f, 0.6f);
    const glm::vec4 light(1.0f, 1.0f, 1.0f, 0.9f);
    for (const float border : {width, 0.0f}) {
        const glm::vec4& colour = border > 0.0f ? dark : light;
        add_filled(middle - glm::vec2(arm, 0.0f) - border, middle + glm::vec2(arm, width) + border, colour);
        add_filled(middle - glm::vec2(0.0f, arm) - border, middle + glm::vec2(width, arm) + border, colour);
    }
}

}  // namespace hw
