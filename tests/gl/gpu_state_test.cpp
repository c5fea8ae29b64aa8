#include "hatchway/gl/gpu_state.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hatchway/gl/context.hpp"
#include "hatchway/gl/gpu_target.hpp"
#include "hatchway/gl/headless_context.hpp"

namespace hw {
namespace {

using testing::IsEmpty;

constexpr glm::vec4 kBlack(0.0f, 0.0f, 0.0f, 1.0f);

ShaderText text(const std::string& source)
{
    return {source, {"defines", "test"}};
}

/// A triangle over the lower left half of the target, in one colour.
class Triangle : public testing::Test {
 protected:
    Triangle()
        : vertices_(std::vector<glm::vec3>{{-1.0f, -1.0f, 0.0f}, {1.0f, -1.0f, 0.0f}, {-1.0f, 1.0f, 0.0f}}),
          program_(text("in vec3 hw_in_position;\nvoid main() { gl_Position = vec4(hw_in_position, 1.0); }\n"),
                   text("out vec4 colour;\nuniform vec4 paint;\nvoid main() { colour = paint; }\n"), false)
    {
        const VertexStream stream{VertexInput::position, &vertices_, 3, sizeof(glm::vec3), 0};
        array_ = GpuVertexArray({&stream, 1}, nullptr);
        state_.forget();
    }
    ~Triangle() override { EXPECT_THAT(context_->take_errors(), IsEmpty()); }

    void draw(const GpuTarget& target, const glm::vec4& paint, const PipelineState& pipeline)
    {
        target.bind();
        state_.apply(pipeline);
        state_.use(program_);
        GpuProgram::set(program_.location("paint"), paint);
        state_.bind(array_);
        state_.draw(Primitive::triangles, 0, 3);
    }

    std::unique_ptr<Context> context_ = make_headless_context();
    GpuBuffer vertices_;
    GpuVertexArray array_;
    GpuProgram program_;
    GpuState state_;
};

TEST_F(Triangle, covers_its_half_of_the_picture)
{
    const GpuTarget target({.size_px = {8, 8}, .colours = {{TextureFormat::rgba8}}});
    target.bind();
    state_.apply({});
    target.clear(kBlack);
    draw(target, {1.0f, 0.0f, 0.0f, 1.0f}, {});
    const Pixels pixels = target.read_rgb();
    EXPECT_EQ(pixels.at(0, 7)[0], 255) << "rows run from the top";
    EXPECT_EQ(pixels.at(7, 0)[0], 0);
    EXPECT_EQ(state_.counters().triangles, 1u);
}

TEST_F(Triangle, the_same_state_twice_is_sent_once)
{
    const GpuTarget target({.size_px = {8, 8}, .colours = {{TextureFormat::rgba8}}});
    draw(target, kBlack, {});
    const GpuCounters first = state_.counters();
    draw(target, kBlack, {});
    EXPECT_EQ(state_.counters().state_changes, first.state_changes);
    EXPECT_EQ(state_.counters().program_switches, first.program_switches);
    EXPECT_EQ(state_.counters().draw_calls, first.draw_calls + 1);
}

TEST_F(Triangle, what_was_set_before_does_not_stay)
{
    const GpuTarget target({.size_px = {8, 8}, .colours = {{TextureFormat::rgba8}}});
    draw(target, kBlack, {.depth_test = DepthTest::off, .writes_colour = false, .blending = Blending::over});
    target.bind();
    state_.apply({});
    target.clear(kBlack);
    draw(target, {0.0f, 1.0f, 0.0f, 0.25f}, {});
    EXPECT_EQ(target.read_pixel(0, 7).g, 1.0f) << "no blending, colour written";
}

TEST_F(Triangle, blending_in_an_srgb_target_is_linear)
{
    const GpuTarget target({.size_px = {8, 8}, .colours = {{TextureFormat::srgb8_alpha8}}});
    target.bind();
    state_.apply({});
    target.clear(kBlack);
    draw(target, {1.0f, 1.0f, 1.0f, 0.5f}, {.blending = Blending::over});
    EXPECT_NEAR(target.read_rgb().at(0, 7)[0], 188, 1) << "half of the light is sRGB 188, not 128";
}

TEST_F(Triangle, the_resolve_of_an_srgb_target_is_linear)
{
    const GpuTarget sampled({.size_px = {8, 8}, .colours = {{TextureFormat::srgb8_alpha8}}, .samples = 4});
    const GpuTarget target({.size_px = {8, 8}, .colours = {{TextureFormat::srgb8_alpha8}}});
    sampled.bind();
    state_.apply({});
    sampled.clear(kBlack);
    draw(sampled, glm::vec4(1.0f), {});
    sampled.resolve_into(target);
    // On the diagonal half of a pixel's samples are covered: two of four.
    EXPECT_NEAR(target.read_rgb().at(3, 3)[0], 188, 1);
    EXPECT_EQ(target.read_rgb().at(0, 7)[0], 255);
}

TEST_F(Triangle, a_moved_buffer_owns_what_the_first_did)
{
    GpuBuffer first(std::vector<float>{1.0f, 2.0f});
    const std::uint32_t id = first.id();
    GpuBuffer second = std::move(first);
    EXPECT_EQ(second.id(), id);
    EXPECT_EQ(first.id(), 0u);
    EXPECT_EQ(second.size_bytes(), 8u);
}

TEST_F(Triangle, a_sampler_without_a_texture_named_is_ignored)
{
    EXPECT_EQ(program_.unit("nothing"), -1);
    EXPECT_EQ(program_.location("nothing"), -1);
    state_.bind_texture(-1, 7);
    GpuProgram::set(-1, 1.0f);
}

}  // namespace
}  // namespace hw
