// The smooth threshold of halftone.glsl, and hatch coordinates as the renderer makes them.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/test_scenes.hpp"

namespace hw::test {
namespace {

double linear_mean(const Pixels& picture)
{
    double sum = 0.0;
    for (const std::uint8_t byte : picture.bytes) {
        const double c = byte / 255.0;
        sum += c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    }
    return sum / static_cast<double>(picture.bytes.size());
}

/// Shows where strokes would lie, from coordinates that it asks for.
class StreamStyle final : public Style {
 public:
    explicit StreamStyle(Streams streams) : streams_(streams) {}
    Needs needs() const override { return {.streams = streams_}; }
    void prepare(ProgramCache& programs) override { program_ = programs.surface("test_streams.frag"); }
    void surfaces(Pass& pass, Items items) override { pass.surfaces(program_, {}, items); }

 private:
    Streams streams_;
    Program program_;
};

class halftone : public RendererTest {};
class hatch_streams : public RendererTest {};

}  // namespace

TEST_F(halftone, the_mean_ink_over_evenly_spread_priorities_is_the_tone)
{
    add_object(scene_, floor_mesh(100.0f), glm::dmat4(1.0), painted(glm::vec3(1.0f)));
    double last = -1.0;
    for (const float tone : {0.0f, 0.02f, 0.2f, 0.5f, 0.8f, 0.98f, 1.0f}) {
        TestStyle style{glm::vec3(tone)};
        style.fragment_file = "test_halftone.frag";
        load(style);
        const double mean = linear_mean(draw(view_from({0.0, 5.0, 0.1}, {0.0, 0.0, 0.0})));
        EXPECT_NEAR(mean, tone, 0.01) << "tone " << tone;
        EXPECT_GT(mean, last) << "tone " << tone;
        last = mean;
        if (tone == 0.0f || tone == 1.0f) {
            EXPECT_EQ(mean, tone);
        }
    }
}

TEST_F(hatch_streams, are_made_once_for_a_mesh_and_only_where_a_style_asks)
{
    add_object(scene_, sphere_mesh(1.0f, 16), glm::dmat4(1.0), painted(glm::vec3(1.0f)));
    TestStyle plain{glm::vec3(1.0f)};
    load(plain);
    draw(view_from({0.0, 1.0, 4.0}, {0.0, 0.0, 0.0}));
    EXPECT_EQ(stats_.hatch_streams_built, 0);

    StreamStyle hatched({.hatch_uv = true, .direction = true, .hatch_source = HatchSource::principal});
    load(hatched);
    const View view = view_from({0.0, 1.0, 4.0}, {0.0, 0.0, 0.0});
    const Pixels once = draw(view);
    EXPECT_EQ(stats_.hatch_streams_built, 1);
    EXPECT_EQ(count_unlike(once, draw(view)), 0);
    EXPECT_EQ(stats_.hatch_streams_built, 1);
}

TEST_F(hatch_streams, directions_are_unit_and_lie_in_the_surface)
{
    // The shader shows red where a direction is not unit or not tangential, green where it is.
    const glm::dmat4 placed = glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(0.3, 1.0, 0.2));
    add_object(scene_, sphere_mesh(1.0f, 24), glm::scale(placed, glm::dvec3(2.0)), painted(glm::vec3(1.0f)));
    StreamStyle style({.hatch_uv = true, .direction = true, .hatch_source = HatchSource::principal});
    load(style);
    const Pixels picture = draw(view_from({0.0, 1.0, 6.0}, {0.0, 0.0, 0.0}), {.samples = 1});
    int good = 0;
    int bad = 0;
    for (std::size_t i = 0; i < picture.bytes.size(); i += 3) {
        good += picture.bytes[i] == 0 && picture.bytes[i + 1] == 255 ? 1 : 0;
        bad += picture.bytes[i] == 255 && picture.bytes[i + 1] == 0 ? 1 : 0;
    }
    EXPECT_GT(good, 5000);
    EXPECT_LT(bad, good / 100);
}

}  // namespace hw::test
