// Ramps and images as styles see them.
#include "tests/render/test_scenes.hpp"

namespace hw::test {
namespace {

/// Shows the ramp at three tones, one in each channel, or the image.
class MapStyle final : public Style {
 public:
    explicit MapStyle(glm::vec3 tones) : tones_(tones) {}
    Needs needs() const override
    {
        Needs needs;
        needs.maps[MapKind::ramp] = {"mine"};
        return needs;
    }
    void prepare(ProgramCache& programs) override { program_ = programs.surface("test_maps.frag"); }
    void surfaces(Pass& pass, Items items) override
    {
        Uniforms uniforms;
        uniforms.set("tones", tones_);
        pass.surfaces(program_, uniforms, items);
    }

 private:
    glm::vec3 tones_;
    Program program_;
};

/// Red, green, blue, from dark to light.
const MapLevels kRamp{.kind = MapKind::ramp, .levels = {Pixels{3, 1, 3, {255, 0, 0, 0, 255, 0, 0, 0, 255}}}};
/// Yellow over the left half, black over the right one.
const MapLevels kImage{.kind = MapKind::image, .levels = {Pixels{2, 1, 3, {255, 255, 0, 0, 0, 0}}}, .size_m = 4.0};

class maps : public RendererTest {
 protected:
    glm::ivec3 drawn(const glm::vec3& tones, std::map<MapKind, int> of_object, NamedMaps named = {},
                     glm::ivec2 at = {160, 120})
    {
        scene_ = {};
        MeshData mesh = box_mesh(glm::vec3(4.0f));
        mesh.uv0.clear();
        for (const glm::vec3& p : mesh.positions) mesh.uv0.push_back({0.25f * (p.x + 2.0f), 0.25f * (p.y + 2.0f)});
        add_object(scene_, mesh, glm::dmat4(1.0), painted(glm::vec3(1.0f)));
        MapStyle style(tones);
        input_.maps = {&kRamp, &kImage};
        input_.named_maps = std::move(named);
        load({{"maps", &style}}, {{.style = 0, .maps = std::move(of_object)}});
        const Pixels pixels = draw(view_from({0, 0, 8}, {0, 0, 0}));
        return {pixels.at(at.x, at.y)[0], pixels.at(at.x, at.y)[1], pixels.at(at.x, at.y)[2]};
    }
};

TEST_F(maps, a_ramp_gives_its_first_colour_to_tone_0_and_its_last_to_tone_1)
{
    const std::map<MapKind, int> ramp{{MapKind::ramp, 0}};
    EXPECT_EQ(drawn({0.0f, 0.5f, 1.0f}, ramp), glm::ivec3(255, 255, 255));
    EXPECT_EQ(drawn({1.0f, 1.0f, 0.0f}, ramp), glm::ivec3(0, 0, 0));
}

TEST_F(maps, a_ramp_of_the_style_goes_to_objects_without_one)
{
    EXPECT_EQ(drawn({0.0f, 0.0f, 0.0f}, {}, {{{MapKind::ramp, "mine"}, 0}}), glm::ivec3(255, 0, 0));
    EXPECT_EQ(drawn({0.0f, 0.0f, 0.0f}, {}, {{{MapKind::image, "mine"}, 1}}), glm::ivec3(0, 0, 0)) << "another kind";
}

TEST_F(maps, without_a_ramp_a_tone_is_itself)
{
    EXPECT_EQ(drawn({0.0f, 1.0f, 0.0f}, {}), glm::ivec3(0, 255, 0));
}

TEST_F(maps, an_image_lies_on_the_surface_once_in_its_size)
{
    const std::map<MapKind, int> image{{MapKind::image, 1}};
    const glm::ivec3 left = drawn(glm::vec3(-1.0f), image, {}, {125, 120});
    EXPECT_GT(left.r, 250);
    EXPECT_GT(left.g, 250);
    EXPECT_EQ(left.b, 0);
    EXPECT_LT(drawn(glm::vec3(-1.0f), image, {}, {195, 120}).r, 40);
    EXPECT_EQ(drawn(glm::vec3(-1.0f), {}), glm::ivec3(255, 255, 255)) << "without one it is white";
}

}  // namespace
}  // namespace hw::test
