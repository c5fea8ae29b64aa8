// What a picture shows of a lightmap, pixel by pixel, against the luxels that are blended there.
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/packing.hpp>
#include <random>

#include "hatchway/world/light/layout.hpp"
#include "tests/render/test_scenes.hpp"

namespace hw::test {
namespace {

constexpr glm::dmat4 kHere(1.0);
constexpr int kBlend = 3;  // of 255: weights of a filter have 8 bits, the picture too

/// The nearest point of the scene that a ray meets from a drawn side.
std::optional<SurfacePoint> met(const Scene& scene, const glm::dvec3& eye, const glm::dvec3& direction)
{
    std::optional<SurfacePoint> nearest;
    double distance = 1e9;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const MeshData& mesh = scene.meshes[id];
        for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
            glm::dvec3 p[3];
            for (int k = 0; k < 3; ++k)
                p[k] = glm::dvec3(scene.world_from_object(id) *
                                  glm::dvec4(glm::dvec3(mesh.positions[mesh.indices[t * 3 + k]]), 1.0));
            const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
            const double facing = glm::dot(direction, normal);
            const double along = glm::dot(p[0] - eye, normal) / facing;
            if (facing == 0.0 || along <= 0.0 || along >= distance) continue;
            const glm::dvec3 at = eye + along * direction;
            glm::dvec3 share;
            for (int k = 0; k < 3; ++k)
                share[k] = glm::dot(glm::cross(p[(k + 2) % 3] - p[(k + 1) % 3], at - p[(k + 1) % 3]), normal) /
                           glm::dot(normal, normal);
            if (std::min({share.x, share.y, share.z}) < 0.0) continue;
            if (facing > 0.0 && !scene.materials[id].is_double_sided) continue;
            distance = along;
            nearest = SurfacePoint{id, t, glm::vec3(share), facing > 0.0};
        }
    }
    return nearest;
}

class baked_light : public RendererTest {
 protected:
    baked_light() : style_(glm::vec3(1.0f))
    {
        style_.fragment_file = "test_baked.frag";
        style_.lightmap = true;
    }

    /// Every luxel has a colour of its own.
    void fill_at_random(double luxels_per_m)
    {
        lightmap_ = plan_lightmap(scene_, luxels_per_m, 1 << 20);
        std::mt19937 random(5);
        for (auto& halves : lightmap_.luxels)
            for (int k = 0; k < 3; ++k) halves[k] = glm::packHalf1x16(static_cast<float>(random() % 1000) * 1e-3f);
    }
    void show()
    {
        for (std::size_t i = 0; i < scene_.meshes.size(); ++i)
            add_lightmap_stream(scene_.meshes[i], lightmap_.layouts[i]);
        input_.lightmap = &lightmap_;
        load(style_);
    }
    void expect_luxels_at(const glm::dvec3& eye)
    {
        constexpr glm::ivec2 kSize(160, 120);
        const Pixels pixels = draw(view_from(eye, {0, 0, 0}, kSize), {.samples = 1});
        keep_picture(pixels, "baked_light");
        const glm::dvec3 forward = glm::normalize(-eye);
        const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
        const glm::dvec3 up = glm::cross(right, forward);
        const double half = std::tan(glm::radians(30.0));
        int compared = 0;
        for (int y = 4; y < kSize.y; y += 7)
            for (int x = 3; x < kSize.x; x += 7) {
                const glm::dvec2 ndc((x + 0.5) / kSize.x * 2.0 - 1.0, 1.0 - (y + 0.5) / kSize.y * 2.0);
                const auto point = met(scene_, eye, forward + half * (ndc.y * up + ndc.x * kSize.x / kSize.y * right));
                if (!point) continue;
                const glm::vec3 kilolux = 1e-3f * baked_illuminance(lightmap_, scene_, *point);
                for (int k = 0; k < 3; ++k)
                    ASSERT_NEAR(linear(pixels.at(x, y)[static_cast<std::size_t>(k)]), kilolux[k], kBlend / 255.0)
                        << x << ' ' << y;
                ++compared;
            }
        EXPECT_GT(compared, 60);
    }
    static double linear(int byte)
    {
        const double v = byte / 255.0;
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    }

    TestStyle style_;
    Lightmap lightmap_;
};

Material sheet()
{
    Material material = painted(glm::vec3(1.0f));
    material.is_double_sided = true;
    return material;
}

}  // namespace

TEST_F(baked_light, charts_show_the_luxels_of_their_place)
{
    add_object(scene_, floor_mesh(4.0f), kHere, painted(glm::vec3(1.0f)));
    add_object(scene_, box_mesh(glm::vec3(1.0f)), glm::translate(kHere, {0.7, 0.5, 0.2}), painted(glm::vec3(1.0f)));
    fill_at_random(2.0);
    ASSERT_FALSE(lightmap_.layouts[0].is_per_vertex);
    show();
    expect_luxels_at({1.0, 3.0, 2.5});
    EXPECT_EQ(stats_.lightmaps_uploaded, 1);
}

TEST_F(baked_light, the_back_of_a_sheet_shows_its_own_luxels)
{
    add_object(scene_, floor_mesh(4.0f), kHere, sheet());
    fill_at_random(2.0);
    ASSERT_FALSE(lightmap_.layouts[0].is_per_vertex);
    show();
    expect_luxels_at({1.0, 3.0, 2.5});
    expect_luxels_at({1.0, -3.0, 2.5});
}

TEST_F(baked_light, a_fine_mesh_shows_the_luxels_of_its_vertices)
{
    add_object(scene_, sphere_mesh(1.0f, 12), kHere, painted(glm::vec3(1.0f)));
    fill_at_random(1.0);
    ASSERT_TRUE(lightmap_.layouts[0].is_per_vertex);
    show();
    expect_luxels_at({1.0, 1.0, 2.0});
}

TEST_F(baked_light, within_a_fine_double_sided_mesh_its_back_shows_its_own)
{
    MeshData open = sphere_mesh(2.0f, 12);
    open.indices.resize(open.indices.size() - 3);  // a closed one would be a solid
    add_object(scene_, std::move(open), kHere, sheet());
    fill_at_random(0.2);
    ASSERT_TRUE(lightmap_.layouts[0].is_per_vertex);
    ASSERT_EQ(lightmap_.places[0].sides, 2);
    show();
    expect_luxels_at({0.3, 0.4, 0.9});
}

TEST_F(baked_light, within_a_closed_double_sided_mesh_both_sides_show_the_light_outside)
{
    add_object(scene_, sphere_mesh(2.0f, 12), kHere, sheet());
    fill_at_random(0.2);
    ASSERT_TRUE(lightmap_.layouts[0].is_per_vertex);
    ASSERT_EQ(lightmap_.places[0].sides, 1);
    show();
    expect_luxels_at({0.3, 0.4, 0.9});
}

TEST_F(baked_light, two_objects_of_one_lightmap_do_not_mix_up_their_places)
{
    add_object(scene_, sphere_mesh(0.6f, 12), glm::translate(kHere, {-0.8, 0, 0}), painted(glm::vec3(1.0f)));
    add_object(scene_, sphere_mesh(0.6f, 12), glm::translate(kHere, {0.8, 0, 0}), painted(glm::vec3(1.0f)));
    add_object(scene_, floor_mesh(4.0f), glm::translate(kHere, {0, -0.7, 0}), painted(glm::vec3(1.0f)));
    fill_at_random(1.0);
    show();
    expect_luxels_at({0.4, 1.4, 2.2});
}

TEST_F(baked_light, tone_goes_by_it_and_not_by_the_lamps)
{
    add_object(scene_, floor_mesh(4.0f), kHere, painted(glm::vec3(1.0f)));
    Light lamp{.type = LightType::point, .intensity = 1000.0f, .position_world = {0, 2, 0}};
    input_.lights = {lamp};
    input_.exposure_ev = 9.0f;
    TestStyle tone(glm::vec3(0.0f));
    tone.fragment_file = "test_baked.frag";
    tone.lightmap = true;
    lightmap_ = plan_lightmap(scene_, 2.0, 1 << 20);  // dark
    for (std::size_t i = 0; i < scene_.meshes.size(); ++i) add_lightmap_stream(scene_.meshes[i], lightmap_.layouts[i]);
    input_.lightmap = &lightmap_;
    load(tone);
    const View view = view_from({0.0, 3.0, 2.5}, {0, 0, 0}, {64, 48});
    EXPECT_EQ(draw(view, {.samples = 1}).at(32, 24)[0], 0) << "the lamp shines, but what was baked is dark";
    int before = 0;
    for (const float kilolux : {0.2f, 0.6f, 2.0f}) {
        for (auto& halves : lightmap_.luxels) halves[0] = halves[1] = halves[2] = glm::packHalf1x16(kilolux);
        load(tone);
        const int now = draw(view, {.samples = 1}).at(32, 24)[0];
        EXPECT_GT(now, before + 10) << kilolux;
        before = now;
    }
    input_.lightmap = nullptr;
    load(tone);
    EXPECT_GT(draw(view, {.samples = 1}).at(32, 24)[0], 20) << "without a lightmap the lamp counts";
}

}  // namespace hw::test
