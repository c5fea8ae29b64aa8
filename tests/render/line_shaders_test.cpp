// The widths and strokes of lines exist twice, in GLSL for pictures and in C++ for vectors: both compute the same from
// the same numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "hatchway/core/files/files.hpp"
#include "hatchway/drawing/line_width.hpp"
#include "hatchway/drawing/stroke_shape.hpp"
#include "hatchway/geometry/lines/line_crowding.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/gl/gpu_state.hpp"
#include "hatchway/gl/gpu_target.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/render/device/program_store.hpp"

namespace hw::test {
namespace {

constexpr int kSide = 32;  // numbers a call: kSide * kSide
constexpr int kCalls = 12;
constexpr float kWholeFold = 1.5707963f;
constexpr const char* kShaderFolder = HATCHWAY_SOURCE_DIR "/tests/render/shaders";

/// The numbers of test_inputs.glsl.
struct ShaderInputs {
    std::uint32_t pixel;
    std::uint32_t seed;

    float pick(int number) const
    {
        std::uint32_t h = (pixel * 64u + static_cast<std::uint32_t>(number)) * 747796405u + seed * 2891336453u;
        h ^= h >> 16;
        h *= 2246822519u;
        h ^= h >> 13;
        h *= 3266489917u;
        h ^= h >> 16;
        return static_cast<float>(h >> 8) / 16777216.0f;
    }
    glm::vec3 direction(int number) const
    {
        return 2.0f * glm::vec3(pick(number), pick(number + 1), pick(number + 2)) - 1.0f;
    }
    /// Of the call, not of the pixel.
    float pick_for_all(int number) const { return ShaderInputs{4095u * 4096u, seed}.pick(number); }
};

/// Runs a full-screen program over random numbers and hands every result to `judge`.
class line_shaders : public testing::Test {
 protected:
    template <typename SetUniforms, typename Judge>
    void compare(const char* fragment_file, SetUniforms set_uniforms, Judge judge, const char* defines = "")
    {
        const Program program = programs_.cache(kShaderFolder).full_screen(fragment_file, defines);
        const LinkedProgram& linked = *programs_.full_screen(program);
        GpuTarget target({.size_px = glm::ivec2(kSide), .colours = {{.format = TextureFormat::rgba32f}}});
        for (std::uint32_t seed = 1; seed <= kCalls; ++seed) {
            target.bind();
            state_.forget();
            state_.use(linked.gpu);
            GpuProgram::set(linked.gpu.location("test_seed"), static_cast<int>(seed));
            set_uniforms(linked.gpu, ShaderInputs{0, seed});
            state_.apply({.depth_test = DepthTest::off, .writes_depth = false, .culling = Culling::off});
            state_.bind(no_vertices_);
            state_.draw(Primitive::triangles, 0, 3);
            for (int y = 0; y < kSide; ++y)
                for (int x = 0; x < kSide; ++x)
                    judge(target.read_pixel(x, kSide - 1 - y),
                          ShaderInputs{static_cast<std::uint32_t>(y * 4096 + x), seed});
        }
    }

    std::unique_ptr<Context> context_ = make_headless_context();
    ProgramStore programs_{installation_prefix() / "share/hatchway/shaders",
                           installation_prefix() / "share/hatchway/kit",
                           context_->device().is_es,
                           {}};
    GpuState state_;
    GpuVertexArray no_vertices_{{}, nullptr};
};

LineLook random_look(const ShaderInputs& inputs)
{
    LineLook look;
    for (int i = 0; i < kLineClassCount; ++i) look.pens[i].width_px = 0.2f + 4.0f * inputs.pick_for_all(i);
    look.depth_taper = inputs.pick_for_all(20) < 0.3f ? 0.0f : inputs.pick_for_all(21);
    look.taper_from_m = 0.5f + 40.0f * inputs.pick_for_all(22);
    look.fold_weight = inputs.pick_for_all(23);
    look.far.is_on = inputs.pick_for_all(24) < 0.8f;
    look.far.full_spacing_px = 1.0f + 12.0f * inputs.pick_for_all(25);
    return look;
}

/// A place on a stroke, as test_line_stroke.frag makes it.
struct StrokePlace {
    explicit StrokePlace(const ShaderInputs& inputs)
        : px_per_unit(2.0f + 400.0f * inputs.pick(0) * inputs.pick(1)),
          whole(0.05f + 8.0f * inputs.pick(2)),
          arc(whole * inputs.pick(3)),
          seed(std::floor(65536.0f * inputs.pick(4)) / 65536.0f)
    {
    }
    float px_per_unit, whole, arc, seed;
};

}  // namespace

TEST_F(line_shaders, draw_lines_as_wide_as_vectors_are)
{
    int count = 0, thinned = 0;
    double worst = 0.0;
    const auto crease_of = [](const ShaderInputs& inputs) { return 0.02f + 2.0f * inputs.pick_for_all(26); };
    const auto window_of = [](const ShaderInputs& inputs) { return 0.001f + 0.05f * inputs.pick_for_all(27); };
    compare(
        "test_line_width.frag",
        [&](const GpuProgram& gpu, const ShaderInputs& inputs) {
            const LineLook look = random_look(inputs);
            const float window_px = look.far.is_on ? look.far.full_spacing_px / kFullSpacingInWindows : 0.0f;
            std::array<float, kLineClassCount> widths_px;
            for (int i = 0; i < kLineClassCount; ++i) widths_px[i] = look.pens[i].width_px;
            GpuProgram::set(gpu.location("hw_line_width_px[0]"), std::span<const float>(widths_px));
            GpuProgram::set(gpu.location("hw_line_taper"), glm::vec2(look.depth_taper, look.taper_from_m));
            GpuProgram::set(gpu.location("hw_line_fold"), glm::vec3(look.fold_weight, crease_of(inputs), kWholeFold));
            GpuProgram::set(gpu.location("hw_line_fade"),
                            glm::vec3(window_px, window_of(inputs), FarPolicy::kInnerGone));
        },
        [&](const glm::vec4& drawn, const ShaderInputs& inputs) {
            const auto pick = [&](int number) { return inputs.pick(number); };
            PenPlace place{.line_class = static_cast<LineClass>(static_cast<int>(pick(0) * 6.0f)),
                           .fold_rad = 3.2f * pick(1),
                           .distance_m = 0.05f + 300.0f * pick(2) * pick(3),
                           .window_m = window_of(inputs)};
            place.px_per_m = 700.0f / place.distance_m;
            const float first = 3.0f * pick(4), second = first + 2.5f * pick(5), third = second + 2.5f * pick(6);
            place.crowding = {first, second, third, third + 2.5f * pick(7)};
            place.inside = insideness(inputs.direction(8), inputs.direction(11), 40.0f * inputs.direction(14));
            const LineLook look = random_look(inputs);
            const double width = line_width_px(look, crease_of(inputs), place);
            ++count;
            thinned += width < 0.5 * look[place.line_class].width_px ? 1 : 0;
            worst = std::max(worst, std::abs(drawn.r - width) / std::max(width, 1e-3));
        });
    EXPECT_EQ(count, kCalls * kSide * kSide);
    EXPECT_GE(count, 10'000);
    EXPECT_GT(thinned, count / 10) << "the numbers try what thins lines";
    EXPECT_LE(worst, 1e-4);
}

TEST_F(line_shaders, draw_strokes_as_vectors_do)
{
    const auto character_of = [](const ShaderInputs& inputs) {
        return StrokeCharacter{.wobble_px = 0.5f + 3.0f * inputs.pick_for_all(0),
                               .bend_px = 4.0f + 90.0f * inputs.pick_for_all(1),
                               .taper_px = inputs.pick_for_all(2) < 0.2f ? 0.0f : 40.0f * inputs.pick_for_all(3)};
    };
    glm::dvec4 worst(0.0), largest(0.0);
    compare(
        "test_line_stroke.frag",
        [&](const GpuProgram& gpu, const ShaderInputs& inputs) {
            const StrokeCharacter stroke = character_of(inputs);
            GpuProgram::set(gpu.location("hw_stroke_px"),
                            glm::vec4(stroke.wobble_px, stroke.bend_px, 0.0f, stroke.taper_px));
        },
        [&](const glm::vec4& drawn, const ShaderInputs& inputs) {
            const auto pick = [&](int number) { return inputs.pick(number); };
            const StrokeShape shape(character_of(inputs));
            const StrokePlace at(inputs);
            const glm::vec3 place = 20.0f * glm::vec3(pick(5), pick(6), pick(7)) - 10.0f;
            const LineStroke stroke{.length = pick(8) < 0.2f ? -at.whole : at.whole, .seed = at.seed};
            const glm::dvec2 aside = shape.silhouette_stray(place, at.px_per_unit);
            const glm::dvec4 wanted(shape.stray(at.arc, at.seed, at.px_per_unit), aside,
                                    shape.taper(stroke, at.arc, at.px_per_unit));
            worst = glm::max(worst, glm::abs(glm::dvec4(drawn) - wanted));
            largest = glm::max(largest, glm::abs(wanted));
        });
    EXPECT_GT(largest.x, 1.0) << "pixels to the side";
    for (int i = 0; i < 4; ++i) EXPECT_LE(worst[i], 0.01) << i;
}

TEST_F(line_shaders, break_lines_where_vectors_do)
{
    const auto character_of = [](const ShaderInputs& inputs) {
        return StrokeCharacter{.dash_px = 2.0f + 80.0f * inputs.pick_for_all(0),
                               .dash_share = 0.1f + 0.9f * inputs.pick_for_all(1)};
    };
    int count = 0, inked = 0, other_octave = 0;
    double worst_phase = 0.0, worst_coverage = 0.0;
    compare(
        "test_line_stroke.frag",
        [&](const GpuProgram& gpu, const ShaderInputs& inputs) {
            const StrokeCharacter stroke = character_of(inputs);
            GpuProgram::set(gpu.location("hw_stroke_dash"), glm::vec2(stroke.dash_px, stroke.dash_share));
        },
        [&](const glm::vec4& drawn, const ShaderInputs& inputs) {
            const StrokeShape shape(character_of(inputs));
            const StrokePlace at(inputs);
            const float period = shape.dash_period(at.px_per_unit);
            ++count;
            // Halfway between two powers of two either is right.
            const double octave = std::log2(character_of(inputs).dash_px / at.px_per_unit) + 0.5;
            if (drawn.x != period && std::abs(octave - std::round(octave)) < 1e-4) {
                ++other_octave;
                return;
            }
            EXPECT_EQ(drawn.x, period);
            const double phase = shape.dash_phase(at.arc, at.seed, period);
            const double apart = std::abs(drawn.y - phase);
            worst_phase = std::max(worst_phase, std::min(apart, 1.0 - apart));  // the end of a dash is its beginning
            const double inside_px = std::min(phase, shape.dash_share() - phase) * period * at.px_per_unit;
            const double coverage = std::clamp(inside_px + 0.5, 0.0, 1.0);
            inked += coverage > 0.5 ? 1 : 0;
            if (apart < 0.5) worst_coverage = std::max(worst_coverage, std::abs(drawn.z - coverage));
        },
        "#define SHOWS_DASHES 1\n");
    EXPECT_EQ(count, kCalls * kSide * kSide);
    EXPECT_GT(inked, count / 4);
    EXPECT_LT(inked, count - count / 8);
    EXPECT_LT(other_octave, count / 100);
    EXPECT_LE(worst_phase, 1e-4);
    EXPECT_LE(worst_coverage, 0.02) << "pixels of a dash of up to 120";
}

}  // namespace hw::test
