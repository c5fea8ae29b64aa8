// Hatching as the engine's shaders draw it, on planes and solids that are hard for it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "hatchway/maps/hatch_map.hpp"
#include "hatchway/maps/ink_map.hpp"
#include "hatchway/maps/tonal_map.hpp"
#include "tests/render/test_scenes.hpp"

namespace hw::test {
namespace {

enum class Ink { strokes, hand, hatch_map, ink_map, tonal_map, halftone };
constexpr std::array kAllInks{Ink::strokes, Ink::hand, Ink::hatch_map, Ink::ink_map, Ink::tonal_map, Ink::halftone};
constexpr std::array kToned{Ink::strokes, Ink::hand, Ink::tonal_map, Ink::halftone};

const char* name_of(Ink ink)
{
    constexpr std::array kNames{"ruled strokes", "strokes by hand", "hatch map", "ink map", "tonal map", "halftone"};
    return kNames[static_cast<std::size_t>(ink)];
}

/// Shows the ink of one kind of hatching alone.
class InkStyle final : public Style {
 public:
    explicit InkStyle(Ink shown) : ink(shown) {}
    Needs needs() const override { return {.streams = {.hatch_uv = true, .hatch_source = source}}; }
    void prepare(ProgramCache& programs) override
    {
        std::string defines;
        if (ink == Ink::strokes || ink == Ink::hand) defines += "#define SHOWS_STROKES 1\n";
        if (ink == Ink::halftone) defines += "#define SHOWS_HALFTONE 1\n";
        if (checks_range) defines += "#define CHECKS_RANGE 1\n";
        program_ = programs.surface("test_hatching.frag", defines);
    }
    void surfaces(Pass& pass, Items items) override
    {
        const double first = glm::radians(angle_deg);
        const double second = first + glm::radians(70.0);
        Uniforms uniforms;
        uniforms.set("probe", glm::vec4(tone, spacing_px, width_px, ink == Ink::hand ? 90.0f : 0.0f))
            .set("directions", glm::vec4(std::cos(first), std::sin(first), std::cos(second), std::sin(second)));
        pass.surfaces(program_, uniforms, items);
    }

    Ink ink;
    HatchSource source = HatchSource::model;
    bool checks_range = false;
    float tone = 0.5f, spacing_px = 4.5f, width_px = 0.8f;
    double angle_deg = 52.0;

 private:
    Program program_;
};

std::vector<MapStroke> level_strokes()
{
    std::vector<MapStroke> strokes;
    for (int i = 0; i < 64; ++i) strokes.push_back({.points = {{0.0, (i + 0.37) / 64}, {1.0, (i + 0.37) / 64}}});
    rank_evenly(strokes);
    return strokes;
}

/// The map that a kind of ink is drawn by; null: none.
const MapLevels* map_of(Ink ink)
{
    static const MapLevels hatch = make_hatch_map({});
    static const MapLevels drawing = make_ink_map(level_strokes(), {.width_texels = 256, .height_texels = 256}).map;
    static const MapLevels tonal = make_tonal_map({.size_texels = 128, .size_m = 0.5});
    static const MapLevels priorities = make_priority_map({.size_texels = 128, .tones = 16, .size_m = 0.5});
    switch (ink) {
        case Ink::hatch_map:
            return &hatch;
        case Ink::ink_map:
            return &drawing;
        case Ink::tonal_map:
            return &tonal;
        case Ink::halftone:
            return &priorities;
        default:
            return nullptr;
    }
}

/// A wall in the plane z = 0 whose texture coordinates are metres.
MeshData wall_mesh(float side, float u_scale = 1.0f)
{
    const float h = 0.5f * side;
    MeshData mesh;
    for (const glm::vec2& corner : {glm::vec2(-h, -h), glm::vec2(h, -h), glm::vec2(h, h), glm::vec2(-h, h)}) {
        mesh.positions.emplace_back(corner, 0.0f);
        mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
        mesh.uv0.emplace_back(u_scale * corner.x, -corner.y);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

double ink_of_byte(std::uint8_t byte)
{
    const double c = byte / 255.0;
    return 1.0 - (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
}

/// Mean ink of a rectangle of the picture.
double mean_ink(const Pixels& picture, int x0 = 0, int y0 = 0, int x1 = -1, int y1 = -1)
{
    if (x1 < 0) x1 = picture.width;
    if (y1 < 0) y1 = picture.height;
    double sum = 0.0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) sum += ink_of_byte(*picture.at(x, y));
    return sum / ((x1 - x0) * (y1 - y0));
}

/// Deviation of the mean ink of boxes of `side` pixels: energy below the frequency of the lines.
double low_energy(const Pixels& picture, int side)
{
    std::vector<double> tones;
    for (int y = 0; y + side <= picture.height; y += side)
        for (int x = 0; x + side <= picture.width; x += side)
            tones.push_back(mean_ink(picture, x, y, x + side, y + side));
    double mean = 0.0;
    for (const double tone : tones) mean += tone / static_cast<double>(tones.size());
    double squares = 0.0;
    for (const double tone : tones) squares += (tone - mean) * (tone - mean);
    return std::sqrt(squares / static_cast<double>(tones.size()));
}

Pixels flipped(const Pixels& picture)
{
    Pixels result = picture;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            std::copy_n(picture.at(picture.width - 1 - x, y), picture.channels, result.at(x, y));
    return result;
}

class hatching : public RendererTest {
 protected:
    void stand(MeshData mesh)
    {
        scene_ = {};
        add_object(scene_, std::move(mesh), glm::dmat4(1.0), painted(glm::vec3(1.0f)));
    }

    void show(InkStyle& style)
    {
        StyledObject look{.style = 0};
        input_.maps.clear();
        if (const MapLevels* map = map_of(style.ink)) {
            input_.maps = {map};
            look.maps[map->kind] = 0;
        }
        load({{"ink", &style}}, std::vector<StyledObject>(scene_.objects.size(), look));
    }

    /// The wall seen straight on from `distance_m`, or at an angle off that.
    Pixels picture(double distance_m, double angle_deg = 0.0, double fov_deg = 20.0)
    {
        const double angle = glm::radians(angle_deg);
        const glm::dvec3 eye = distance_m * glm::dvec3(0.0, std::sin(angle), std::cos(angle));
        return draw(camera_view({eye, {0.0, 0.0, 0.0}, fov_deg}, {320, 240}, scene_.bounds_world), {.samples = 1});
    }

    double shown_tone(InkStyle& style, float tone, double distance_m, double angle_deg = 0.0)
    {
        style.tone = tone;
        return mean_ink(picture(distance_m, angle_deg));
    }

    void expect_in_range(Ink ink, double distance_m, double angle_deg)
    {
        InkStyle style(ink);
        style.checks_range = true;
        show(style);
        for (const float tone : {0.0f, 0.3f, 1.0f}) {
            style.tone = tone;
            EXPECT_EQ(mean_ink(picture(distance_m, angle_deg)), 0.0)
                << name_of(ink) << " at " << distance_m << " m, " << angle_deg << " degrees, tone " << tone;
        }
    }
};

}  // namespace

TEST_F(hatching, shows_a_ramp_of_tones_within_four_hundredths_and_never_turns_back)
{
    stand(wall_mesh(200.0f));
    for (const Ink ink : kToned) {
        InkStyle style(ink);
        show(style);
        for (const double distance : {3.0, 3.7, 4.4, 5.3, 60.0}) {
            SCOPED_TRACE(testing::Message() << name_of(ink) << " at " << distance << " m");
            double squares = 0.0;
            double last = 0.0;
            for (int step = 0; step <= 40; ++step) {
                const double tone = step / 40.0;
                const double shown = shown_tone(style, static_cast<float>(tone), distance);
                EXPECT_GE(shown, last - 1e-3) << "tone " << tone;
                EXPECT_NEAR(shown, tone, 0.08);
                last = shown;
                squares += (shown - tone) * (shown - tone);
            }
            RecordProperty("rms", std::to_string(std::sqrt(squares / 41.0)));
            EXPECT_LE(std::sqrt(squares / 41.0), 0.04);
        }
    }
}

TEST_F(hatching, of_a_darker_tone_keeps_all_strokes_of_a_lighter_one)
{
    stand(wall_mesh(200.0f));
    for (const Ink ink : {Ink::strokes, Ink::tonal_map, Ink::halftone}) {
        InkStyle style(ink);
        show(style);
        for (const double distance : {3.0, 4.4}) {
            std::vector<Pixels> tones;
            for (int step = 0; step <= 10; ++step) {
                style.tone = static_cast<float>(step) / 10.0f;
                tones.push_back(picture(distance));
            }
            for (std::size_t light = 0; light < tones.size(); ++light)
                for (std::size_t dark = light + 1; dark < tones.size(); ++dark)
                    for (std::size_t i = 0; i < tones[light].bytes.size(); i += 3)
                        ASSERT_GE(ink_of_byte(tones[dark].bytes[i]), ink_of_byte(tones[light].bytes[i]) - 0.02)
                            << name_of(ink) << ", tones " << light << " and " << dark << " at " << distance << " m";
        }
    }
}

TEST_F(hatching, of_tone_0_leaves_white_paper_and_of_tone_1_none)
{
    stand(wall_mesh(200.0f));
    for (const Ink ink : kToned) {
        InkStyle style(ink);
        show(style);
        for (const double distance : {2.6, 3.0, 3.7, 4.4, 30.0}) {
            EXPECT_EQ(shown_tone(style, 0.0f, distance), 0.0) << name_of(ink) << " at " << distance;
            EXPECT_GE(shown_tone(style, 1.0f, distance), 0.98) << name_of(ink) << " at " << distance;
        }
    }
}

TEST_F(hatching, keeps_its_tone_across_the_border_between_two_levels)
{
    // Everything repeats with every octave of distance, so some border lies between each of these and the next.
    stand(wall_mesh(400.0f));
    for (const Ink ink : kAllInks) {
        InkStyle style(ink);
        show(style);
        double least = 1.0;
        double most = 0.0;
        for (int step = 0; step <= 24; ++step) {
            const double shown = shown_tone(style, 0.4f, 8.0 * std::exp2(step / 12.0));
            least = std::min(least, shown);
            most = std::max(most, shown);
        }
        EXPECT_LE(most - least, ink == Ink::ink_map ? 0.06 : 0.04) << name_of(ink);
    }
}

TEST_F(hatching, of_a_far_object_has_the_tone_of_a_near_one)
{
    stand(wall_mesh(2000.0f));
    for (const Ink ink : kAllInks) {
        InkStyle style(ink);
        show(style);
        const double near = shown_tone(style, 0.4f, 5.0);
        EXPECT_GT(near, 0.03) << name_of(ink);
        for (const double times : {8.0, 64.0})
            EXPECT_NEAR(shown_tone(style, 0.4f, 5.0 * times), near, 0.05) << name_of(ink) << ", " << times << " times";
    }
}

TEST_F(hatching, at_grazing_angles_keeps_its_tone)
{
    stand(wall_mesh(400.0f));
    for (const Ink ink : kToned) {
        InkStyle style(ink);
        show(style);
        style.tone = 0.4f;
        for (const double angle : {60.0, 80.0, 85.0})
            EXPECT_NEAR(mean_ink(picture(16.0, angle, 8.0)), 0.4, 0.05) << name_of(ink) << " at " << angle;
    }
}

TEST_F(hatching, goes_on_across_a_seam_where_texture_coordinates_jump_by_whole_maps)
{
    MeshData seamed;
    for (const float side : {-1.0f, 1.0f})
        for (const glm::vec2& corner : {glm::vec2(0, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(0, 1)}) {
            const glm::vec2 at = 20.0f * glm::vec2(side < 0.0f ? corner.x - 1.0f : corner.x, corner.y);
            seamed.positions.emplace_back(at, 0.0f);
            seamed.normals.emplace_back(0.0f, 0.0f, 1.0f);
            seamed.uv0.emplace_back(at.x + (side > 0.0f ? 64.0f : 0.0f), -at.y);
        }
    seamed.indices = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    for (const Ink ink : kAllInks) {
        if (ink == Ink::hand) continue;  // a stroke's length and wobble are those of its own line
        InkStyle style(ink);
        style.angle_deg = 90.0;  // the jump is a whole number of lines of every octave
        style.tone = 0.3f;       // of the first direction alone
        stand(wall_mesh(40.0f));
        show(style);
        const Pixels whole = picture(5.0);
        stand(seamed);
        show(style);
        // Coordinates far from 0 are a little coarser.
        EXPECT_LE(share_unlike(whole, picture(5.0), 24), 0.02) << name_of(ink);
    }
}

TEST_F(hatching, along_mirrored_texture_coordinates_is_mirrored_and_no_more)
{
    for (const Ink ink : kAllInks) {
        InkStyle style(ink);
        stand(wall_mesh(40.0f));
        show(style);
        const Pixels plain = picture(5.0);
        stand(wall_mesh(40.0f, -1.0f));
        show(style);
        EXPECT_LE(share_unlike(plain, flipped(picture(5.0)), 24), 0.02) << name_of(ink);
    }
}

TEST_F(hatching, of_a_model_without_texture_coordinates_lies_on_all_its_sides)
{
    MeshData box = box_mesh(glm::vec3(2.0f));
    box.uv0.clear();
    stand(std::move(box));
    for (const Ink ink : kToned) {
        InkStyle style(ink);
        show(style);
        style.tone = 0.5f;
        for (const glm::dvec3& eye : {glm::dvec3(0, 0, 3), glm::dvec3(3, 0, 0), glm::dvec3(0, 3, 0.01)}) {
            const Pixels seen =
                draw(camera_view({eye, {0, 0, 0}, 20.0}, {160, 120}, scene_.bounds_world), {.samples = 1});
            EXPECT_NEAR(mean_ink(seen), 0.5, 0.05) << name_of(ink);
        }
    }
}

TEST_F(hatching, is_a_number_from_0_to_1_at_every_scale_and_angle)
{
    stand(wall_mesh(4000.0f));
    for (const Ink ink : kAllInks)
        for (const double distance : {1e-3, 0.1, 7.0, 900.0})
            for (const double angle : {0.0, 60.0, 89.9}) expect_in_range(ink, distance, angle);
}

TEST_F(hatching, where_texture_coordinates_stand_still_is_a_number_from_0_to_1)
{
    for (const float everywhere : {0.0f, 0.37f, 1e7f}) {
        MeshData still = wall_mesh(40.0f);
        std::ranges::fill(still.uv0, glm::vec2(everywhere));
        stand(std::move(still));
        for (const Ink ink : kAllInks) expect_in_range(ink, 5.0, 0.0);
    }
    // Standing still one way: a line's worth of texture drawn out over the wall.
    MeshData line = wall_mesh(40.0f);
    for (glm::vec2& uv : line.uv0) uv.x = 0.25f;
    stand(std::move(line));
    for (const Ink ink : kAllInks) expect_in_range(ink, 5.0, 0.0);
}

TEST_F(hatching, by_a_map_smaller_than_a_pixel_is_its_even_tone)
{
    stand(wall_mesh(40000.0f));
    for (const Ink ink : {Ink::tonal_map, Ink::ink_map}) {
        InkStyle style(ink);
        show(style);
        style.tone = 0.5f;
        const Pixels far = picture(4000.0);
        const Pixels farther = picture(12000.0);
        EXPECT_NEAR(mean_ink(far), mean_ink(farther), 0.02) << name_of(ink);
        EXPECT_LE(low_energy(farther, 1), 0.01) << name_of(ink);
    }
}

TEST_F(hatching, turned_by_half_a_turn_is_the_same)
{
    stand(wall_mesh(40.0f));
    InkStyle style(Ink::strokes);
    show(style);
    for (const double angle : {0.0, 90.0, 37.0}) {
        style.angle_deg = angle;
        const Pixels once = picture(5.0);
        style.angle_deg = angle - 180.0;
        EXPECT_LE(share_unlike(once, picture(5.0), 3), 0.002) << angle;
    }
}

TEST_F(hatching, of_a_sphere_that_has_no_direction_of_strongest_curvature_keeps_its_tone)
{
    stand(sphere_mesh(1.0f, 48));
    InkStyle style(Ink::strokes);
    style.source = HatchSource::principal;
    show(style);
    style.tone = 0.3f;
    const View view = camera_view({{0.0, 0.6, 6.0}, {0.0, 0.0, 0.0}, 12.0}, {240, 240}, scene_.bounds_world);
    EXPECT_NEAR(mean_ink(draw(view, {.samples = 1}), 60, 60, 180, 180), 0.3, 0.03);
    style.checks_range = true;
    show(style);
    EXPECT_EQ(mean_ink(draw(view, {.samples = 1})), 0.0);
}

TEST_F(hatching, has_no_energy_below_the_frequency_of_its_lines)
{
    stand(wall_mesh(400.0f));
    for (const Ink ink : {Ink::strokes, Ink::hatch_map}) {
        InkStyle style(ink);
        style.angle_deg = 7.0;
        show(style);
        style.tone = 0.17f;
        for (const double angle : {0.0, 60.0, 75.0}) {
            const Pixels seen = picture(9.0, angle);
            EXPECT_LE(low_energy(seen, 20), 0.02) << name_of(ink) << " at " << angle;
        }
    }
}

}  // namespace hw::test
