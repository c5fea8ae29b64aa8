#include <gmock/gmock.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "hatchway/core/error.hpp"
#include "tests/render/test_scenes.hpp"

namespace hw::test {
namespace {

constexpr glm::dmat4 kHere(1.0);

glm::dmat4 at(double x, double y, double z)
{
    return glm::translate(kHere, glm::dvec3(x, y, z));
}

class frame : public RendererTest {
 protected:
    TestStyle style_{glm::vec3(1.0f)};
};

TEST_F(frame, a_box_on_a_floor_shows_where_it_should)
{
    add_object(scene_, floor_mesh(10.0f), kHere, painted({0.2f, 0.4f, 0.8f}));
    add_object(scene_, box_mesh(glm::vec3(1.0f)), at(0, 0.5, 0), painted({1.0f, 0.0f, 0.0f}));
    TestStyle style(glm::vec3(1.0f));
    load(style);
    const Pixels pixels = draw(view_from({0, 1.5, 4}, {0, 0.5, 0}));
    keep_picture(pixels, "frame_box");
    EXPECT_EQ(pixels.at(160, 120)[0], 255);
    EXPECT_EQ(pixels.at(160, 120)[1], 0);
    EXPECT_NEAR(pixels.at(160, 230)[2], 230, 2) << "0.8 of linear light is sRGB 230";
    EXPECT_EQ(pixels.at(160, 2)[1], 255) << "the background is paper";
    EXPECT_EQ(stats_.objects_visible, 2);
    draw(view_from({0, 1.5, 4}, {0, 0.5, 0}), {.samples = 1});
    EXPECT_EQ(stats_.triangles, 28u) << "depth, then faces";
    EXPECT_EQ(stats_.faces_drawn, 14u) << "each once";
    draw(view_from({0, 1.5, 2}, {0, 0, 5}), {.samples = 1});
    EXPECT_EQ(stats_.faces_drawn, 2u) << "the box is behind the eye";
}

TEST_F(frame, objects_that_others_hide_are_left_out_and_no_pixel_changes)
{
    add_object(scene_, floor_mesh(10.0f), kHere, painted({0.2f, 0.4f, 0.8f}));
    add_object(scene_, sphere_mesh(0.4f, 40), at(0, 0.5, -1), painted({0.0f, 1.0f, 0.0f}));
    add_object(scene_, box_mesh(glm::vec3(1.4f)), at(0, 0.6, 0.5), painted({1.0f, 0.0f, 0.0f}));
    // At equal depth the last one is seen.
    add_object(scene_, box_mesh(glm::vec3(1.4f)), at(0, 0.6, 0.5), painted({1.0f, 1.0f, 0.0f}));
    TestStyle style(glm::vec3(1.0f));
    style.look = LineLook{};
    load(style);
    for (const glm::dvec3& eye : {glm::dvec3(0, 0.8, 4), glm::dvec3(1.1, 0.9, 4), glm::dvec3(3, 2, -2)}) {
        const View view = view_from(eye, {0, 0.5, 0});
        const Pixels whole = draw(view, {.skips_hidden = false});
        const std::uint64_t whole_triangles = stats_.triangles;
        EXPECT_EQ(whole.bytes, draw(view, {}).bytes);
        if (eye.x == 0.0) {
            EXPECT_LT(stats_.triangles, whole_triangles + 100) << "the sphere is asked about, and not drawn";
        }
    }
}

TEST_F(frame, faces_at_one_place_are_shaded_once)
{
    constexpr int kBoxes = 80;
    for (int i = 0; i < kBoxes; ++i)
        add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, painted({i * 0.01f, 1.0f - i * 0.01f, 0.5f}));
    load(style_);
    const View view = view_from({0, 0, 0.9}, {0, 0, 0});  // one face fills the picture
    const Pixels whole = draw(view, {.skips_hidden = false});
    EXPECT_EQ(whole.bytes, draw(view, {}).bytes) << "the last one is seen";
    EXPECT_EQ(stats_.triangles, 12u * (2 * kBoxes + 1)) << "depth and question of all, faces of the last";
    draw(view, {.samples = 1});
    EXPECT_EQ(stats_.triangles, 12u * (2 * kBoxes + 1)) << "so deep a pile is asked about with one sample, too";
}

TEST_F(frame, an_object_that_repeats_another_is_drawn_once)
{
    const ObjectId last = add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, painted({0.2f, 0.4f, 0.8f}));
    const Object object = scene_.objects[last];
    for (int i = 0; i < 50; ++i) scene_.objects.push_back(object);
    scene_.materials.push_back(painted({1.0f, 0.0f, 0.0f}));
    for (int i = 0; i < 2; ++i) {
        scene_.objects.push_back(object);
        scene_.objects.back().material = 1;
    }
    TestStyle style(glm::vec3(1.0f));
    style.look = LineLook{};
    load(style);
    const View view = view_from({1, 1.5, 4}, {0, 0, 0});
    const Pixels pile = draw(view);
    EXPECT_EQ(stats_.objects_visible, 2) << "one of each material";
    scene_.objects = {scene_.objects.front(), scene_.objects.back()};
    load(style);
    EXPECT_EQ(pile.bytes, draw(view).bytes);
    scene_.materials[0].alpha_mode = AlphaMode::blend;
    scene_.objects = {object, object, object};
    load(style);
    draw(view);
    EXPECT_EQ(stats_.objects_visible, 3) << "what is blended is seen through itself";
}

TEST_F(frame, a_pile_that_takes_for_ever_is_refused_by_a_software_renderer_and_one_less_deep_has_one_sample)
{
    MeshData pile;
    const auto pile_of = [&](int boxes) {
        pile = box_mesh(glm::vec3(1.0f));
        const std::vector<std::uint32_t> one = pile.indices;
        for (int i = 1; i < boxes; ++i) pile.indices.insert(pile.indices.end(), one.begin(), one.end());
        scene_ = {};
        add_object(scene_, pile, kHere, painted({0.2f, 0.4f, 0.8f}));
        load(style_);
    };
    const View view = view_from({0, 0, 0.9}, {0, 0, 0}, {64, 48});  // one face fills the picture
    pile_of(1);
    const Pixels one = draw(view, {.samples = 1});
    pile_of(2000);
    testing::internal::CaptureStderr();
    EXPECT_EQ(one.bytes, draw(view, {.samples = 1}).bytes);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "it has what was asked for";
    testing::internal::CaptureStderr();
    for (int times = 0; times < 2; ++times) EXPECT_EQ(one.bytes, draw(view, {.samples = 4}).bytes);
    const std::string told = testing::internal::GetCapturedStderr();
    if (context_->device().is_software) {
        EXPECT_THAT(told, testing::HasSubstr("warning: faces lie over each other so often")) << "it is said";
        EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 1) << "once: " << told;
    }
    pile_of(6000);
    if (!context_->device().is_software) GTEST_SKIP() << "a graphics card draws it";
    try {
        draw(view);
        ADD_FAILURE() << "it was drawn";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("too many layers of faces and lines"));
        EXPECT_THAT(error.what(), testing::HasSubstr("--budget-factor"));
    }
}

TEST_F(frame, a_style_that_draws_its_objects_twice_shows_both)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, painted({0.2f, 0.4f, 0.8f}));
    class Twice final : public Style {
     public:
        Needs needs() const override { return {}; }
        void prepare(ProgramCache& programs) override { program_ = programs.surface("test_flat.frag"); }
        void surfaces(Pass& pass, Items items) override
        {
            for (const glm::vec3& colour : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)}) {
                Uniforms uniforms;
                uniforms.set("flat_colour", colour);
                pass.surfaces(program_, uniforms, items);
            }
        }

     private:
        Program program_;
    } style;
    load(style);
    const Pixels pixels = draw(view_from({0, 0, 4}, {0, 0, 0}));
    EXPECT_EQ(pixels.at(160, 120)[0], 0) << "the second call lies over the first";
    EXPECT_GT(pixels.at(160, 120)[1], 100);
}

TEST_F(frame, flat_styles_build_no_product)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, painted(glm::vec3(1.0f)));
    TestStyle style(glm::vec3(0.5f));
    load(style);
    draw(view_from({0, 0, 4}, {0, 0, 0}));
    EXPECT_EQ(stats_.adjacencies_built, 0);
    EXPECT_EQ(stats_.edge_tables_built, 0);
    EXPECT_EQ(stats_.silhouette_extractions, 0);
    EXPECT_EQ(stats_.shadow_maps_drawn, 0);
    EXPECT_EQ(stats_.images_made, 0);
    EXPECT_EQ(stats_.lines, 0u);
}

TEST_F(frame, the_same_view_gives_the_same_bytes_whatever_was_drawn_before)
{
    add_object(scene_, sphere_mesh(1.0f, 16), kHere, painted({0.5f, 0.7f, 0.2f}));
    add_object(scene_, floor_mesh(8.0f), at(0, -1, 0), painted(glm::vec3(0.9f)));
    TestStyle style(glm::vec3(1.0f));
    style.look = LineLook{};
    load(style);
    const View view = view_from({1, 2, 4}, {0, 0, 0});
    for (const int samples : {1, 4}) {
        const Pixels first = draw(view, {.samples = samples});
        draw(view_from({-3, 1, 1}, {0, 0, 0}, {200, 100}), {.samples = 5 - samples});
        draw(view_from({0, 5, 0.1}, {0, 0, 0}), {.samples = samples});
        EXPECT_EQ(first.bytes, draw(view, {.samples = samples}).bytes);
    }
}

TEST_F(frame, culling_by_chunks_does_not_change_a_pixel)
{
    MeshData sphere = sphere_mesh(2.0f, 40);
    const MeshChunks chunks = split_into_chunks(sphere);
    ASSERT_GT(chunks.size(), 4u);
    add_object(scene_, sphere, kHere, painted({0.3f, 0.5f, 0.9f}));
    TestStyle style(glm::vec3(1.0f));
    load(style);
    const View view = view_from({1.0, 0.5, 2.6}, {2.0, 0.0, 0.0});
    const Pixels whole = draw(view);
    const std::uint64_t whole_triangles = stats_.triangles;
    const std::vector<MeshChunks> all{chunks};
    input_.chunks = all;
    load(style);
    const Pixels culled = draw(view);
    EXPECT_LT(stats_.triangles, whole_triangles);
    EXPECT_EQ(whole.bytes, culled.bytes);
}

TEST_F(frame, two_styles_with_complementary_presence_make_their_mixture)
{
    add_object(scene_, box_mesh(glm::vec3(2.0f)), kHere, painted(glm::vec3(1.0f)));
    TestStyle red({1.0f, 0.0f, 0.0f});
    TestStyle blue({0.0f, 0.0f, 1.0f});
    StyledObject look{.style = 0, .over = 1, .presence = {.constant = 0.25f}};
    load({{"red", &red}, {"blue", &blue}}, {look});
    const Pixels pixels = draw(view_from({0, 0, 4}, {0, 0, 0}));
    EXPECT_NEAR(pixels.at(160, 120)[0], 225, 1) << "0.75 of linear light";
    EXPECT_NEAR(pixels.at(160, 120)[2], 137, 1) << "0.25 of linear light";
}

TEST_F(frame, presence_rises_with_height)
{
    add_object(scene_, box_mesh({2.0f, 2.0f, 2.0f}), kHere, painted(glm::vec3(1.0f)));
    TestStyle black(glm::vec3(0.0f));
    TestStyle white(glm::vec3(1.0f));
    StyledObject look{.style = 0, .over = 1, .presence = {.height = Ramp{-0.8f, 0.8f}}};
    load({{"black", &black}, {"white", &white}}, {look});
    const Pixels pixels = draw(view_from({0, 0, 4}, {0, 0, 0}));
    keep_picture(pixels, "frame_presence");
    EXPECT_EQ(pixels.at(160, 182)[0], 0);
    EXPECT_EQ(pixels.at(160, 58)[0], 255);
    EXPECT_GT(pixels.at(160, 100)[0], pixels.at(160, 130)[0]);
}

TEST_F(frame, blended_faces_lie_over_opaque_ones_from_back_to_front)
{
    add_object(scene_, box_mesh({4.0f, 4.0f, 0.1f}), at(0, 0, -2), painted(glm::vec3(0.0f)));
    Material glass = painted(glm::vec3(1.0f));
    glass.alpha_mode = AlphaMode::blend;
    glass.base_colour = {1.0f, 0.0f, 0.0f, 0.5f};
    add_object(scene_, box_mesh({1.0f, 1.0f, 0.1f}), at(0, 0, 1), glass);
    glass.base_colour = {0.0f, 1.0f, 0.0f, 0.5f};
    add_object(scene_, box_mesh({1.0f, 1.0f, 0.1f}), at(0, 0, 0), glass);
    TestStyle style(glm::vec3(1.0f));
    load(style);
    const Pixels pixels = draw(view_from({0, 0, 4}, {0, 0, 0}));
    EXPECT_NEAR(pixels.at(160, 120)[0], 188, 1) << "red in front: half";
    EXPECT_NEAR(pixels.at(160, 120)[1], 137, 1) << "green behind: a quarter";
}

TEST_F(frame, an_alpha_mask_cuts_faces_out)
{
    Material cut = painted(glm::vec3(0.0f));
    cut.alpha_mode = AlphaMode::mask;
    cut.base_colour.a = 0.4f;
    add_object(scene_, box_mesh(glm::vec3(2.0f)), kHere, cut);
    TestStyle style(glm::vec3(1.0f));
    load(style);
    EXPECT_EQ(count_dark(draw(view_from({0, 0, 4}, {0, 0, 0}))), 0);
}

TEST_F(frame, a_mirrored_object_shows_its_outside)
{
    const glm::dmat4 mirrored = glm::scale(kHere, glm::dvec3(-1.0, 1.0, 1.0));
    add_object(scene_, box_mesh(glm::vec3(1.0f)), mirrored, painted({1.0f, 0.0f, 0.0f}));
    TestStyle style(glm::vec3(1.0f));
    style.shows_images = true;
    load(style);
    const Pixels pixels = draw(view_from({0, 0, 4}, {0, 0, 0}));
    EXPECT_EQ(pixels.at(160, 120)[2], 255) << "the normal looks at the eye";
    EXPECT_NEAR(pixels.at(160, 120)[0], 188, 2);
}

TEST_F(frame, a_scene_far_from_the_origin_looks_as_one_at_it)
{
    // Places that no float holds, and not off by the same where they are rounded.
    const glm::dvec3 eye(1.03, 1.02, 4.01), offset(1e6 + 0.37, -2e6 + 0.81, 5e5 + 0.013);
    TestStyle style(glm::vec3(1.0f));
    style.look = LineLook{};
    add_object(scene_, sphere_mesh(1.0f, 12), kHere, painted({0.2f, 0.6f, 0.4f}));
    load(style);
    const Pixels near_origin = draw(view_from(eye, {0, 0, 0}));
    scene_ = {};
    add_object(scene_, sphere_mesh(1.0f, 12), glm::translate(kHere, offset), painted({0.2f, 0.6f, 0.4f}));
    load(style);
    const Pixels far_away = draw(view_from(offset + eye, offset));
    EXPECT_LT(share_unlike(near_origin, far_away, 3), 0.005);
}

TEST_F(frame, the_shadow_map_is_drawn_once_and_shades_what_the_light_does_not_reach)
{
    add_object(scene_, floor_mesh(10.0f), kHere, painted(glm::vec3(1.0f)));
    add_object(scene_, box_mesh({1.0f, 0.2f, 1.0f}), at(0, 2, 0), painted(glm::vec3(1.0f)));
    Light sun;
    sun.type = LightType::sun;
    sun.direction_world = {0, -1, 0};
    input_.lights = {sun};
    TestStyle style(glm::vec3(1.0f));
    style.shadow = ShadowNeed::main_light;
    style.fragment_file = "test_shadow.frag";
    load(style);
    const View view = view_from({0, 1.2, 5}, {0, 0, 0});
    const Pixels pixels = draw(view);
    keep_picture(pixels, "frame_shadow");
    EXPECT_EQ(pixels.at(160, 120)[0], 0) << "below the box";
    EXPECT_EQ(pixels.at(40, 160)[0], 255) << "beside it";
    draw(view_from({0, 3, 5}, {0, 0, 0}));
    EXPECT_EQ(stats_.shadow_maps_drawn, 1);
    load(style);
    draw(view, {.is_rehearsal = true});
    EXPECT_EQ(count_unlike(draw(view), pixels), 0) << "what a rehearsal draws in the small is drawn anew";
}

TEST_F(frame, a_tilted_sun_leaves_lit_faces_without_acne)
{
    add_object(scene_, floor_mesh(10.0f), kHere, painted(glm::vec3(1.0f)));
    add_object(scene_, sphere_mesh(0.8f, 24), at(0, 0.8, 0), painted(glm::vec3(1.0f)));
    Light sun;
    sun.type = LightType::sun;
    sun.direction_world = glm::normalize(glm::dvec3(-0.9, -0.5, -0.2));
    input_.lights = {sun};
    TestStyle style(glm::vec3(1.0f));
    style.shadow = ShadowNeed::main_light;
    style.fragment_file = "test_shadow.frag";
    load(style);
    const Pixels pixels = draw(view_from({3, 2.5, 5}, {0, 0, 0}));
    keep_picture(pixels, "frame_tilted_sun");
    int gray = 0;
    for (int y = 150; y < 235; ++y)
        for (int x = 180; x < 300; ++x) gray += pixels.at(x, y)[0] < 250 ? 1 : 0;
    EXPECT_EQ(gray, 0) << "the open floor on the light's side";
}

TEST_F(frame, an_image_is_made_once_for_all_styles_that_ask)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, painted(glm::vec3(1.0f)));
    add_object(scene_, box_mesh(glm::vec3(1.0f)), at(2, 0, 0), painted(glm::vec3(1.0f)));
    TestStyle first(glm::vec3(1.0f));
    TestStyle second(glm::vec3(1.0f));
    first.shows_images = second.shows_images = true;
    StyledObject a{.style = 0};
    StyledObject b{.style = 1};
    load({{"first", &first}, {"second", &second}}, {a, b});
    draw(view_from({0, 0, 6}, {0, 0, 0}));
    EXPECT_EQ(stats_.images_made, 1);
    draw(view_from({0, 0, 6}, {0, 0, 12}));
    EXPECT_EQ(stats_.images_made, 0) << "nobody who asks is visible";
}

TEST_F(frame, an_image_pass_that_nobody_makes_is_an_error_of_the_input)
{
    class Asking final : public Style {
        Needs needs() const override { return {.images = {{"unheard_of", {}}}}; }
        void prepare(ProgramCache&) override {}
    } style;
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, painted(glm::vec3(1.0f)));
    EXPECT_THROW(load(style), Error);
}

TEST_F(frame, words_and_a_cross_hair_lie_over_the_picture)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, painted(glm::vec3(1.0f)));
    TestStyle style(glm::vec3(0.2f, 0.5f, 0.7f));
    load(style);
    const View view = view_from({0, 0, 4}, {0, 0, 0});
    FrameOptions options;
    const Pixels bare = draw(view, options);
    options.overlay.has_cross_hair = true;
    options.overlay.texts.push_back({.text = "Esc releases the mouse\n12.5 ms, {x} [y] 100%"});
    options.overlay.texts.push_back({.position_px = {-8, -8}, .text = "gjpqy @ QWERTY"});
    const Pixels pixels = draw(view, options);
    keep_picture(pixels, "frame_overlay");
    EXPECT_GT(count_unlike(bare, pixels), 3000);
    EXPECT_EQ(pixels.at(300, 20)[0], bare.at(300, 20)[0]);
}

TEST_F(frame, a_view_without_objects_is_paper)
{
    TestStyle style(glm::vec3(1.0f));
    load(style);
    EXPECT_EQ(count_dark(draw(view_from({0, 0, 4}, {0, 0, 0})), 255), 0);
}

}  // namespace
}  // namespace hw::test
