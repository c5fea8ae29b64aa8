#include <gmock/gmock.h>

#include <fstream>
#include <glm/gtc/matrix_transform.hpp>

#include "hatchway/core/error.hpp"
#include "tests/render/test_scenes.hpp"
#include "tests/temporary_folder.hpp"

namespace hw::test {
namespace {

namespace fs = std::filesystem;
constexpr glm::dmat4 kHere(1.0);
const fs::path kShaders = fs::path(HATCHWAY_SOURCE_DIR) / "tests/render/shaders";

glm::dmat4 at(double x, double y, double z)
{
    return glm::translate(kHere, glm::dvec3(x, y, z));
}

/// sRGB bytes back to the value that a shader wrote, 0 to 255.
int linear_byte(std::uint8_t byte)
{
    const double c = byte / 255.0;
    return static_cast<int>(255.0 * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4)) + 0.5);
}

/// Shows an image of the host on its objects' faces.
class ShowingStyle final : public Style {
 public:
    explicit ShowingStyle(ImageKey key) : key_(std::move(key)) {}
    Needs needs() const override { return {.images = {key_}}; }
    void prepare(ProgramCache& programs) override { program_ = programs.surface("test_show.frag"); }
    void surfaces(Pass& pass, Items items) override
    {
        pass.surfaces(program_, Uniforms().set("shown", pass.image(key_)), items);
    }

 private:
    ImageKey key_;
    Program program_;
};

/// Draws its objects into an image of its own, inverts that, and shows the result.
class TransientStyle final : public Style {
 public:
    Needs needs() const override { return {}; }
    void prepare(ProgramCache& programs) override
    {
        flat_ = programs.surface("test_flat.frag");
        invert_ = programs.full_screen("test_invert.frag");
        show_ = programs.surface("test_show.frag");
    }
    void images(Pass& pass, Items items) override
    {
        const Image drawn = pass.render({.clear = glm::vec4(0.0f)}, flat_,
                                        Uniforms().set("flat_colour", glm::vec3(1.0f, 0.0f, 0.0f)), items);
        inverted_ = pass.filter({.has_depth = false}, invert_, Uniforms().set("source", drawn));
    }
    void surfaces(Pass& pass, Items items) override { pass.surfaces(show_, Uniforms().set("shown", inverted_), items); }

 private:
    Program flat_, invert_, show_;
    Image inverted_;
};

/// An image pass that inverts normal_depth.
class InvertingPass final : public ImagePass {
 public:
    explicit InvertingPass(ProgramCache& programs) { prepare(programs); }
    Needs needs() const override { return {.images = {{"normal_depth", {}}}}; }
    void prepare(ProgramCache& programs) override { program_ = programs.full_screen("test_invert.frag"); }
    Image make(Pass& pass) override
    {
        return pass.filter({}, program_, Uniforms().set("source", pass.image({"normal_depth", {}})));
    }

 private:
    Program program_;
};

class images : public RendererTest {};

TEST_F(images, object_ids_number_the_objects_whatever_hides_them)
{
    for (int i = 0; i < 3; ++i) add_object(scene_, box_mesh(glm::vec3(1.0f)), at(1.5 * (i - 1), 0, 0), Material{});
    ShowingStyle style({"object_ids", {}});
    load(style);
    for (const int samples : {1, 4}) {
        const Pixels pixels = draw(view_from({0, 0, 5}, {0, 0, 0}), {.samples = samples});
        EXPECT_EQ(linear_byte(pixels.at(94, 120)[0]), 1);
        EXPECT_EQ(linear_byte(pixels.at(160, 120)[0]), 2);
        EXPECT_EQ(linear_byte(pixels.at(226, 120)[0]), 3);
        EXPECT_EQ(pixels.at(160, 120)[1], 0);
    }
}

TEST_F(images, triangle_ids_number_triangles_through_all_objects)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), at(-1, 0, 0), Material{});
    add_object(scene_, box_mesh(glm::vec3(1.0f)), at(1, 0, 0), Material{});
    ShowingStyle style({"triangle_ids", {}});
    load(style);
    const Pixels pixels = draw(view_from({0, 0, 5}, {0, 0, 0}), {.samples = 1});
    // Twelve triangles a box; the last two look along +z. Numbers start at 1.
    const int first = linear_byte(pixels.at(116, 124)[0]);
    const int second = linear_byte(pixels.at(204, 124)[0]);
    EXPECT_THAT(first, testing::AnyOf(11, 12));
    EXPECT_EQ(second, first + 12);
}

TEST_F(images, a_style_draws_into_targets_of_its_own_and_filters_them)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, Material{});
    TransientStyle style;
    load(style);
    const View view = view_from({0, 0, 4}, {0, 0, 0});
    const Pixels pixels = draw(view);
    EXPECT_EQ(stats_.transient_targets, 2);
    EXPECT_EQ(pixels.at(160, 120)[0], 0);
    EXPECT_EQ(pixels.at(160, 120)[1], 255);
    EXPECT_EQ(draw(view).bytes, pixels.bytes) << "targets are used again, their content is not";
}

TEST_F(images, an_image_pass_is_fed_with_what_it_needs)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, Material{});
    input_.image_passes = [&](const ImageKey& key) -> std::unique_ptr<ImagePass> {
        if (key.pass != "inverted") return nullptr;
        return std::make_unique<InvertingPass>(renderer_->program_cache(kShaders));
    };
    ShowingStyle style({"inverted", {}});
    load(style);
    const Pixels pixels = draw(view_from({0, 0, 4}, {0, 0, 0}));
    EXPECT_EQ(stats_.images_made, 2);
    EXPECT_EQ(pixels.at(160, 120)[0], 255) << "1 - normal.x";
    EXPECT_EQ(pixels.at(160, 120)[2], 0) << "1 - normal.z";
}

TEST_F(images, a_new_look_is_what_a_fresh_load_shows)
{
    add_object(scene_, sphere_mesh(1.0f, 12), kHere, painted(glm::vec3(0.8f)));
    add_object(scene_, box_mesh(glm::vec3(1.0f)), at(2, 0, 0), painted(glm::vec3(0.8f)));
    TestStyle plain(glm::vec3(0.5f));
    TestStyle ink(glm::vec3(1.0f));
    ink.look = LineLook{};
    const std::vector<NamedStyle> styles{{"plain", &plain}, {"ink", &ink}};
    const StyledObject in_plain{.style = 0};
    const StyledObject in_ink{.style = 1};
    const View view = view_from({1, 1, 5}, {0.5, 0, 0});
    load(styles, {in_plain, in_plain});
    const Pixels before = draw(view);
    EXPECT_EQ(stats_.adjacencies_built, 0);
    renderer_->set_looks(styles, {in_ink, in_plain});
    const Pixels changed = draw(view);
    EXPECT_EQ(stats_.adjacencies_built, 1);
    renderer_->set_looks(styles, {in_plain, in_plain});
    EXPECT_EQ(draw(view).bytes, before.bytes);
    load(styles, {in_ink, in_plain});
    EXPECT_EQ(draw(view).bytes, changed.bytes);
}

TEST_F(images, looks_with_a_need_that_fails_change_nothing)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, Material{});
    add_object(scene_, box_mesh(glm::vec3(1.0f)), at(2, 0, 0), Material{});
    std::vector<std::string> made;
    input_.image_passes = [&](const ImageKey& key) -> std::unique_ptr<ImagePass> {
        made.push_back(key.pass);
        if (key.pass != "inverted") return nullptr;
        return std::make_unique<InvertingPass>(renderer_->program_cache(kShaders));
    };
    TestStyle ink(glm::vec3(1.0f));
    ink.look = LineLook{};
    ShowingStyle good({"inverted", {}});
    ShowingStyle bad({"nobody_makes_this", {}});
    const View view = view_from({1, 1, 5}, {1, 0, 0});
    load(ink);
    prepare(good);
    const Pixels before = draw(view);
    EXPECT_THROW(renderer_->set_looks({{"good", &good}, {"bad", &bad}}, {{.style = 0}, {.style = 1}}), Error);
    EXPECT_EQ(draw(view).bytes, before.bytes);
    EXPECT_EQ(stats_.images_made, 0);
    renderer_->set_looks({{"good", &good}}, {{.style = 0}, {.style = 0}});
    EXPECT_THAT(made, testing::ElementsAre("inverted", "nobody_makes_this", "inverted")) << "nothing was kept";
    EXPECT_NE(draw(view).bytes, before.bytes);
}

TEST_F(images, a_saved_shader_shows_and_a_broken_one_keeps_the_last_good)
{
    const TemporaryFolder temporary;
    const fs::path& folder = temporary.path();
    const auto write = [&](const std::string& colour) {
        std::ofstream(folder / "test_flat.frag")
            << "#include \"surface.glsl\"\nvoid main() { hw_output(" << colour << ", 1.0); }\n";
    };
    write("vec3(1.0, 0.0, 0.0)");
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, Material{});
    TestStyle style(glm::vec3(1.0f));
    load(style);
    style.prepare(renderer_->program_cache(folder));
    const View view = view_from({0, 0, 4}, {0, 0, 0});
    EXPECT_EQ(draw(view).at(160, 120)[1], 0);
    write("vec3(0.0, 1.0, 0.0)");
    renderer_->reload_shaders();
    EXPECT_EQ(draw(view).at(160, 120)[1], 255);
    write("vec3(0.0, 1.0, 0.0");
    try {
        renderer_->reload_shaders();
        FAIL() << "it compiled";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("test_flat.frag:2"));
    }
    EXPECT_EQ(draw(view).at(160, 120)[1], 255);
}

TEST_F(images, a_style_that_cuts_holes_shows_what_lies_behind)
{
    const TemporaryFolder temporary;
    const fs::path& folder = temporary.path();
    std::ofstream(folder / "test_flat.frag") << "#include \"surface.glsl\"\nvoid main() { HwSurface s = hw_surface();\n"
                                                "if (s.position_world.z > 0.4) discard;\n"
                                                "hw_output(vec3(s.position_world.z < -1.0 ? 1.0 : 0.0), 1.0); }\n";
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, Material{});
    add_object(scene_, box_mesh(glm::vec3(1.0f)), at(0, 0, -2), Material{});
    TestStyle style(glm::vec3(1.0f));
    load(style);
    style.prepare(renderer_->program_cache(folder));
    EXPECT_EQ(draw(view_from({0, 0, 4}, {0, 0, 0}), {.samples = 1}).at(160, 120)[0], 255);
}

}  // namespace
}  // namespace hw::test
