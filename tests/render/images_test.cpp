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
    void prepare(ProgramCache& programs) override
    {
        const bool has_ids = key_.pass.ends_with("_ids");
        program_ = programs.surface("test_show.frag", has_ids ? "#define SHOWS_IDS 1\n" : "");
    }
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
        const Images drawn = pass.render({}, flat_, Uniforms().set("flat_colour", glm::vec3(1.0f, 0.0f, 0.0f)), items);
        inverted_ = pass.filter({}, invert_, Uniforms().set("source", drawn[0]))[0];
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
    Images make(Pass& pass, Items) override
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

/// An image that is white where object 1 is seen; writes down its items.
class SeenPass final : public ImagePass {
 public:
    SeenPass(ProgramCache& programs, TargetDepth depth, std::vector<std::uint32_t>& objects)
        : depth_(depth), objects_(objects)
    {
        prepare(programs);
    }
    Needs needs() const override { return {}; }
    void prepare(ProgramCache& programs) override { program_ = programs.surface("test_flat.frag"); }
    Images make(Pass& pass, Items items) override
    {
        objects_.clear();
        std::vector<DrawItem> drawn;
        for (const DrawItem& item : items) {
            objects_.push_back(item.object());
            if (item.object() == 1) drawn.push_back(item);
        }
        return pass.render({.depth = depth_}, program_, Uniforms().set("flat_colour", glm::vec3(1.0f)), drawn);
    }

 private:
    TargetDepth depth_;
    std::vector<std::uint32_t>& objects_;
    Program program_;
};

TEST_F(images, an_image_pass_gets_the_items_whose_style_needs_it_and_what_hides_them_when_it_wants)
{
    // The first box is before the right half of the second.
    add_object(scene_, box_mesh(glm::vec3(2.0f, 2.0f, 0.1f)), at(1, 0, 1), Material{});
    add_object(scene_, box_mesh(glm::vec3(2.0f, 2.0f, 0.1f)), at(0, 0, 0), Material{});
    std::vector<std::uint32_t> objects;
    TargetDepth depth = TargetDepth::own;
    input_.image_passes = [&](const ImageKey& key) -> std::unique_ptr<ImagePass> {
        if (key.pass != "seen") return nullptr;
        return std::make_unique<SeenPass>(renderer_->program_cache(kShaders), depth, objects);
    };
    TestStyle plain(glm::vec3(0.5f));
    ShowingStyle masked({"seen", {}});
    for (const bool is_scene : {false, true}) {
        depth = is_scene ? TargetDepth::scene : TargetDepth::own;
        load({{"plain", &plain}, {"masked", &masked}}, {{.style = 0}, {.style = 1}});
        FrameOptions options{.samples = 1};
        options.shown_image = {"seen", {}};
        draw(view_from({0, 0, 6}, {0, 0, 0}), {.samples = 1});
        EXPECT_THAT(objects, testing::ElementsAre(1)) << "of the style that needs it alone";
        const Pixels shown = draw(view_from({0, 0, 6}, {0, 0, 0}), options);
        EXPECT_THAT(objects, testing::ElementsAre(0, 1)) << "all, when somebody looks at it";
        EXPECT_EQ(shown.at(130, 120)[0], 255);
        EXPECT_EQ(shown.at(175, 120)[0], is_scene ? 0 : 255) << "there the other object hides it";
    }
}

/// Draws numbers and colours at once into targets of half the size, and compares them on the device.
class OutputsStyle final : public Style {
 public:
    explicit OutputsStyle(TargetDesc target) : target_(std::move(target)) {}
    Needs needs() const override
    {
        Needs needs;
        needs.streams.triangle_id = true;
        return needs;
    }
    void prepare(ProgramCache& programs) override
    {
        outputs_ = programs.surface("test_outputs.frag");
        compare_ = programs.full_screen("test_compare.frag");
        show_ = programs.surface("test_show.frag");
    }
    void images(Pass& pass, Items items) override
    {
        made = pass.render(target_, outputs_, {}, items);
        of_no_program = pass.render(target_, Program{}, {}, items);
        of_wrong_program = pass.render(target_, compare_, {}, items);
        unnamed = pass.image({"normal_depth", {}});
        compared_ = pass.filter({}, compare_, Uniforms().set("ids", made[0]).set("colours", made[1]))[0];
    }
    void surfaces(Pass& pass, Items items) override { pass.surfaces(show_, Uniforms().set("shown", compared_), items); }

    Images made, of_no_program, of_wrong_program;
    Image unnamed;

 private:
    TargetDesc target_;
    Program outputs_, compare_, show_;
    Image compared_;
};

TEST_F(images, a_pass_fills_several_targets_of_several_formats)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, Material{});
    OutputsStyle style({.outputs = {{.format = PixelFormat::rg32ui}, {.filter = PixelFilter::nearest}}, .scale = 0.5f});
    load(style);
    const Pixels pixels = draw(view_from({0, 0, 4}, {0, 0, 0}, {321, 241}), {.samples = 1});
    EXPECT_EQ(pixels.at(160, 120)[0], 255) << "numbers and colours arrive as they were written";
    ASSERT_EQ(style.made.size(), 2u);
    EXPECT_EQ(style.made[0].size_px, glm::ivec2(161, 121)) << "sizes are rounded up";
    EXPECT_TRUE(is_whole_number(style.made[0].format));
    EXPECT_FALSE(style.made[2].is_valid()) << "there is no third";
    EXPECT_EQ(style.of_no_program.size(), 0u);
    EXPECT_EQ(style.of_wrong_program.size(), 0u) << "a full-screen program draws no faces";
    FrameOptions options{.samples = 1};
    options.shown_image = {"normal_depth", {}};
    draw(view_from({0, 0, 4}, {0, 0, 0}), options);
    EXPECT_FALSE(style.unnamed.is_valid()) << "it is there, but the style's needs do not name it";
}

TEST_F(images, a_pass_without_outputs_or_with_too_many_draws_nothing)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, Material{});
    for (const std::size_t count : {std::size_t(0), kMaxTargetOutputs + 1}) {
        OutputsStyle style({.outputs = std::vector<TargetOutput>(count), .scale = 1e9f});
        load(style);
        draw(view_from({0, 0, 4}, {0, 0, 0}), {.samples = 1});
        EXPECT_EQ(style.made.size(), 0u);
    }
}

TEST_F(images, one_is_shown_in_place_of_the_picture)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, Material{});
    TestStyle style(glm::vec3(0.5f));
    load(style);
    FrameOptions options;
    options.shown_image = {"normal_depth", {}};
    const View view = view_from({0, 0, 4}, {0, 0, 0});
    const Pixels normals = draw(view, options);
    EXPECT_EQ(normals.at(160, 120)[0], 0);
    EXPECT_EQ(normals.at(160, 120)[2], 255) << "its normal is +z";
    EXPECT_EQ(normals.at(2, 2)[2], 0);
    options.shown_image = {"object_ids", {}};
    EXPECT_NE(draw(view, options).at(160, 120)[0], 0);
    EXPECT_EQ(draw(view, options).at(2, 2)[0], 0);
    options.shown_image = {"nobody_makes_this", {}};
    EXPECT_THROW(draw(view, options), Error);
    options.shown_image = {"object_ids", {{"size", 2.0}}};
    EXPECT_THROW(draw(view, options), Error) << "it has no parameters";
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
