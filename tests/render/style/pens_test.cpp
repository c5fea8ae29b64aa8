// What docs/write_a_style.md promises of lines: a pen for each class, pens of a style's own and what these read.
#include <gmock/gmock.h>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/style/scripted_style.hpp"

namespace hw::test {
namespace {

const std::string kEngines =
    "#include \"line_pen.glsl\"\nvoid main() { HwLine l = hw_line(); hw_output(l.colour, l.coverage); }\n";

struct Colours {
    int red = 0, green = 0, blue = 0;
};

Colours colours_of(const Pixels& pixels)
{
    Colours found;
    for (std::size_t i = 0; i < pixels.bytes.size(); i += 3) {
        const std::uint8_t* at = &pixels.bytes[i];
        found.red += at[0] > at[1] + 64 && at[0] > at[2] + 64 ? 1 : 0;
        found.green += at[1] > at[0] + 64 && at[1] > at[2] + 64 ? 1 : 0;
        found.blue += at[2] > at[0] + 64 && at[2] > at[1] + 64 ? 1 : 0;
    }
    return found;
}

/// Two sheets that meet in an inner corner along x.
MeshData corner()
{
    MeshData mesh = floor_mesh(2.0f);
    const MeshData wall = floor_mesh(2.0f);
    for (const glm::vec3& p : wall.positions) mesh.positions.emplace_back(p.x, p.z + 1.0f, -1.0f);
    mesh.normals.insert(mesh.normals.end(), 4, glm::vec3(0, 0, 1));
    for (const std::uint32_t i : {4u, 6u, 5u, 4u, 7u, 6u}) mesh.indices.push_back(i);
    return mesh;
}

class pens : public RendererTest {
 protected:
    pens()
    {
        style_.needed.edges = EdgeNeed{.intersections = true};
        style_.draws_surfaces = [this](Pass& pass, Items items) { pass.surfaces(paper_, {}, items); };
        style_.draws_lines = [this](Pass& pass, Items items) {
            if (pen_.is_valid())
                pass.lines(pen_, uniforms_, look_, items);
            else
                pass.lines(look_, items);
        };
    }

    /// A scene that has lines of this class, among others.
    void stand(LineClass line_class)
    {
        scene_ = {};
        const glm::dmat4 here(1.0);
        const Material white = painted(glm::vec3(1.0f));
        if (line_class == LineClass::silhouette) add_object(scene_, sphere_mesh(1.0f, 24), here, white);
        if (line_class == LineClass::valley) add_object(scene_, corner(), here, white);
        if (line_class == LineClass::border || line_class == LineClass::artist) {
            MeshData sheet = floor_mesh(2.0f);
            if (line_class == LineClass::artist) sheet.artist_edges = {0, 2};
            add_object(scene_, sheet, here, white);
        }
        if (line_class == LineClass::ridge || line_class == LineClass::intersection)
            add_object(scene_, box_mesh(glm::vec3(1.0f)), here, white);
        if (line_class == LineClass::intersection) add_object(scene_, floor_mesh(3.0f), here, white);
    }
    Colours drawn()
    {
        load(style_);
        return colours_of(draw(view_from({0.3, 3, 3}, {0, 0, 0})));
    }

    ShaderFolder shaders_{*renderer_};
    Program paper_ =
        shaders_.surface("#include \"surface.glsl\"\nvoid main() { hw_surface(); hw_output(vec3(1.0), 1.0); }\n");
    Program pen_;
    Uniforms uniforms_;
    LineLook look_;
    ScriptedStyle style_;
};

TEST(line_look, has_a_pen_for_each_class)
{
    LineLook look;
    for (int i = 0; i < kLineClassCount; ++i) {
        const auto line_class = static_cast<LineClass>(i);
        const bool is_wide = line_class == LineClass::silhouette || line_class == LineClass::border;
        EXPECT_EQ(look[line_class].width_px, is_wide ? 1.5f : 1.2f);
        EXPECT_EQ(look[line_class].colour, glm::vec3(0.0f));
        EXPECT_TRUE(look[line_class].is_drawn);
    }
    EXPECT_EQ(look.depth_taper, 0.0f);
    EXPECT_TRUE(look.stroke.is_ruled());
    EXPECT_EQ(look.far.full_spacing_px, 4.0f);
    look.all({.width_px = 2.0f})[LineClass::border] = {.width_px = 3.0f, .is_drawn = false};
    EXPECT_EQ(look[LineClass::ridge].width_px, 2.0f);
    EXPECT_EQ(look.pens[3].width_px, 3.0f);
    EXPECT_FALSE(look[LineClass::border].is_drawn);
}

TEST_F(pens, draw_their_class_in_their_colour_and_no_other)
{
    for (int i = 0; i < kLineClassCount; ++i) {
        const auto line_class = static_cast<LineClass>(i);
        stand(line_class);
        look_.all({.is_drawn = false})[line_class] = {.width_px = 4.0f, .colour = {1.0f, 0.0f, 0.0f}};
        const Colours alone = drawn();
        EXPECT_GT(alone.red, 100) << i;
        EXPECT_EQ(alone.blue, 0) << i;
        look_.all({.width_px = 4.0f, .colour = {0.0f, 0.0f, 1.0f}})[line_class] = {.colour = {1.0f, 0.0f, 0.0f},
                                                                                   .is_drawn = false};
        EXPECT_EQ(drawn().red, 0) << i;
    }
}

TEST_F(pens, of_a_style_s_own_that_repeat_the_engine_s_draw_the_same_bytes)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), glm::dmat4(1.0), painted(glm::vec3(1.0f)));
    add_object(scene_, sphere_mesh(0.7f, 12), glm::translate(glm::dmat4(1.0), glm::dvec3(1.5, 0, 0)),
               painted(glm::vec3(1.0f)));
    look_.all({.width_px = 3.0f});
    look_.stroke = {.wobble_px = 1.0f, .overshoot_px = 5.0f, .taper_px = 8.0f, .dash_px = 20.0f};
    load(style_);
    const View view = view_from({1.0, 1.5, 4}, {0.5, 0, 0});
    const Pixels by_engine = draw(view);
    EXPECT_GT(count_dark(by_engine), 200);
    pen_ = shaders_.line(kEngines);
    EXPECT_EQ(draw(view).bytes, by_engine.bytes);
    EXPECT_EQ(draw(view, {.line_path = LinePath::native}).bytes, by_engine.bytes) << "GL_LINES know no pens";
}

TEST_F(pens, read_what_is_known_of_a_line)
{
    struct Condition {
        LineClass line_class;
        const char* glsl;
        glm::dvec3 eye{0, 4, 0.001};
    };
    constexpr Condition kConditions[]{
        {LineClass::border, "l.line_class == 3"},
        {LineClass::border, "l.coverage > 0.0 && l.coverage <= 1.0"},
        {LineClass::border, "l.colour == vec3(1.0, 0.0, 0.0)"},
        {LineClass::border, "abs(l.width_px - 9.0) < 0.01"},
        {LineClass::border, "abs(l.across) < 1.3"},
        {LineClass::border, "l.presence == 1.0"},
        {LineClass::border, "l.seed >= 0.0 && l.seed < 1.0"},
        {LineClass::border, "l.length_object_m >= 0.0 && l.length_object_m <= 8.01"},
        {LineClass::border, "abs(l.length_px - 51.96 * l.length_object_m) <= 1.0 + 0.05 * l.length_px"},
        {LineClass::border, "abs(max(abs(l.position_object.x), abs(l.position_object.z)) - 1.0) < 0.01"},
        {LineClass::artist, "l.line_class == 3 || l.line_class == 4 && l.position_object.y == 0.0"},
        {LineClass::silhouette, "l.line_class == 0"},
        {LineClass::silhouette, "l.length_px == 0.0 && l.length_object_m == 0.0 && l.seed == 0.0"},
        {LineClass::silhouette, "abs(length(l.position_object) - 1.0) < 0.03"},
        {LineClass::ridge, "l.line_class == 0 && l.length_object_m >= 0.0"},  // from above, all folds are the outline
        {LineClass::ridge, "l.line_class == 0 || l.line_class == 1", {3, 3, 2}}};
    look_.all({.width_px = 9.0f, .colour = {1.0f, 0.0f, 0.0f}});
    look_.far.is_on = false;
    const auto drawn_where = [&](const Condition& condition) {
        stand(condition.line_class);
        pen_ =
            shaders_.line(std::string("#include \"line_pen.glsl\"\nvoid main() { HwLine l = hw_line();\nhw_output(") +
                          condition.glsl + " ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), l.coverage); }\n");
        load(style_);
        return colours_of(draw(view_from(condition.eye, {0, 0, 0}), {.samples = 1}));
    };
    for (const Condition& condition : kConditions) {
        const Colours colours = drawn_where(condition);
        EXPECT_GT(colours.green, 100) << condition.glsl;
        EXPECT_EQ(colours.red, 0) << condition.glsl;
    }
    EXPECT_GT(drawn_where({LineClass::border, "l.position_object.x > 0.0"}).red, 100) << "the test can fail";
    const Colours corner = drawn_where({LineClass::ridge, "l.line_class == 1", {3, 3, 2}});
    EXPECT_GT(corner.green, 100) << "inside";
    EXPECT_GT(corner.red, 100) << "the outline";
}

TEST_F(pens, read_how_far_along_the_line_they_are)
{
    stand(LineClass::border);
    pen_ = shaders_.line(
        "#include \"line_pen.glsl\"\nuniform vec3 pen_colour;\nvoid main() { HwLine l = hw_line();\n"
        "hw_output(vec3(pen_colour.rg, fract(l.length_object_m)), l.coverage); }\n");
    uniforms_.set("pen_colour", glm::vec3(1.0f));
    look_.all({.width_px = 9.0f});
    load(style_);
    const Pixels pixels = draw(view_from({0, 4, 0.001}, {0, 0, 0}), {.samples = 1});
    std::set<int> blues;
    for (int x = 0; x < pixels.width; ++x) {
        const std::uint8_t* at = pixels.at(x, 68);  // along the far border
        if (at[0] == 255 && at[1] == 255 && at[2] < 250) blues.insert(at[2]);
    }
    EXPECT_GT(blues.size(), 40u) << "length grows along it";
}

}  // namespace
}  // namespace hw::test
