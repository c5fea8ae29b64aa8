// One line policy: the picture of the renderer and the vector drawing of the same camera have the same ink. The picture
// decides visibility by depth, the drawing exactly, and the drawing is rasterised here by code that draws nothing else.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include "hatchway/drawing/level_lines.hpp"
#include "hatchway/io/gltf/import.hpp"
#include "hatchway/render/view/line_camera.hpp"
#include "measure/lines/line_error.hpp"
#include "tests/render/test_scenes.hpp"
#include "tests/shared_data.hpp"

namespace hw::test {
namespace {

constexpr glm::ivec2 kSize{640, 420};

constexpr double kFound = 0.995;  // share of the ink of each that the other has within a pixel
// How far the ink of all lines together may be apart. Where lines meet, the picture adds their edges up.
constexpr double kApart = 0.02;
constexpr double kCrowdedApart = 0.12;

/// Inks pieces of lines with round ends. What is inked before lay_down() goes on into each other; after it, more ink
/// lies on it.
class InkPen {
 public:
    explicit InkPen(InkImage& image) : image_(image), own_(image.ink.size(), 0.0f) {}

    void add(const glm::dvec2& a, const glm::dvec2& b, double width_px)
    {
        const double drawn = std::max(0.5 * width_px, 0.5), reach = drawn + 1.0;
        const glm::ivec2 low = glm::max(glm::ivec2(glm::floor(glm::min(a, b) - reach)), glm::ivec2(0));
        const glm::ivec2 high =
            glm::min(glm::ivec2(glm::ceil(glm::max(a, b) + reach)), glm::ivec2(image_.width - 1, image_.height - 1));
        const glm::dvec2 way = b - a;
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) {
                const glm::dvec2 p = glm::dvec2(x + 0.5, y + 0.5) - a;
                const double t = std::clamp(glm::dot(p, way) / std::max(glm::dot(way, way), 1e-12), 0.0, 1.0);
                const double cover =
                    std::clamp(0.5 + drawn - glm::distance(p, t * way), 0.0, 1.0) * std::min(width_px, 1.0);
                const std::size_t pixel = static_cast<std::size_t>(y) * image_.width + x;
                if (own_[pixel] == 0.0f && cover > 0.0) inked_.push_back(pixel);
                own_[pixel] = std::max(own_[pixel], static_cast<float>(cover));
            }
    }
    void lay_down()
    {
        for (const std::size_t pixel : inked_)
            image_.ink[pixel] = 1.0f - (1.0f - image_.ink[pixel]) * (1.0f - std::exchange(own_[pixel], 0.0f));
        inked_.clear();
    }

 private:
    InkImage& image_;
    std::vector<float> own_;
    std::vector<std::size_t> inked_;
};

/// The looks of one object lie on each other: there its classes of lines begin again.
InkImage rasterised(const VectorDrawing& drawing)
{
    const glm::ivec2 size = drawing.size_px;
    InkImage image{size.x, size.y, std::vector<float>(static_cast<std::size_t>(size.x) * size.y, 0.0f)};
    InkPen pen(image);
    for (const VectorObject& object : drawing.objects) {
        std::set<std::string> inked_types;
        for (const VectorGroup& group : object.groups) {
            if (!inked_types.insert(group.line_type).second) {
                pen.lay_down();
                inked_types = {group.line_type};
            }
            for (const VectorLine& line : group.lines) {
                const std::size_t count = line.points_px.size();
                for (std::size_t i = 0; i + (line.is_closed ? 0 : 1) < count; ++i)
                    pen.add(line.points_px[i], line.points_px[(i + 1) % count], line.width_px);
            }
        }
    }
    pen.lay_down();
    return image;
}

/// Share of the ink of one image within a pixel of which the other has half as much at least.
double found_share(const InkImage& ink, const InkImage& other)
{
    double sum = 0.0, found = 0.0;
    for (int y = 0; y < ink.height; ++y)
        for (int x = 0; x < ink.width; ++x) {
            float most = 0.0f;
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, ink.height - 1); ++v)
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, ink.width - 1); ++u)
                    most = std::max(most, other.at(u, v));
            sum += ink.at(x, y);
            if (most >= 0.5f * ink.at(x, y)) found += ink.at(x, y);
        }
    return sum > 0.0 ? found / sum : 1.0;
}

/// Ink red where the drawing lacks it, blue where the picture does.
Pixels compared(const InkImage& picture, const InkImage& drawing)
{
    Pixels pixels{picture.width, picture.height, 3, {}};
    for (std::size_t i = 0; i < picture.ink.size(); ++i) {
        const auto grey = [](float ink) {
            return static_cast<std::uint8_t>(255.0f * (1.0f - std::clamp(ink, 0.0f, 1.0f)));
        };
        const std::uint8_t a = grey(picture.ink[i]), b = grey(drawing.ink[i]);
        pixels.bytes.insert(pixels.bytes.end(), {b, static_cast<std::uint8_t>((a + b) / 2), a});
    }
    return pixels;
}

class picture_and_drawing : public RendererTest {
 protected:
    picture_and_drawing()
    {
        style_.look.emplace();
        style_.intersections = true;
    }

    void expect_alike(const std::string& name, const CameraPlace& camera, double least = kFound,
                      double apart = kCrowdedApart)
    {
        load(style_);
        expect_alike_as_loaded(name, camera, least, apart);
    }
    void expect_alike_as_loaded(const std::string& name, const CameraPlace& camera, double least = kFound,
                                double apart = kCrowdedApart)
    {
        const View view = camera_view(camera, kSize, scene_.bounds_world);
        const InkImage picture = ink_of(draw(view, {.samples = 4}));
        const LineCamera place = line_camera(camera, view);
        LevelLines lines(scene_, object_pens(scene_, input_.styles, input_.objects, view));
        const auto found = find_visible_lines(lines.objects(), place, {.intersections = lines.intersections()});
        const InkImage drawing = rasterised(lines.drawing(found, place));
        keep_picture(compared(picture, drawing), "compared_" + name);
        const double in_drawing = found_share(picture, drawing), in_picture = found_share(drawing, picture);
        RecordProperty(name, std::to_string(in_drawing) + " " + std::to_string(in_picture));
        EXPECT_GT(ink_share(picture), 0.002) << name;
        EXPECT_NEAR(ink_share(picture) / ink_share(drawing), 1.0, apart)
            << name << ": ink of the picture over the drawing's";
        EXPECT_GE(in_drawing, least) << name << ": ink of the picture that the drawing lacks";
        EXPECT_GE(in_picture, least) << name << ": ink of the drawing that the picture lacks";
    }
    /// A model with all its materials white.
    void open(const std::filesystem::path& file)
    {
        scene_ = import_gltf(file, file.parent_path());
        for (Material& material : scene_.materials) {
            Material white = painted(glm::vec3(1.0f));
            white.alpha_mode = material.alpha_mode;
            white.is_double_sided = material.is_double_sided;
            material = white;
        }
    }
    void add(MeshData mesh, const glm::dvec3& place)
    {
        add_object(scene_, std::move(mesh), glm::translate(glm::dmat4(1.0), place), painted(glm::vec3(1.0f)));
    }

    TestStyle style_{glm::vec3(1.0f)};
};

/// A vase: a profile turned around the y axis.
MeshData lathe_mesh(int columns)
{
    const std::vector<glm::vec2> profile{{0.02f, 0.0f}, {0.7f, 0.05f}, {0.9f, 0.5f},  {0.6f, 1.0f},
                                         {0.3f, 1.3f},  {0.35f, 1.5f}, {0.55f, 1.7f}, {0.02f, 1.72f}};
    MeshData mesh;
    for (const glm::vec2& p : profile)
        for (int column = 0; column < columns; ++column) {
            const double around = 2.0 * M_PI * column / columns;
            mesh.positions.emplace_back(p.x * std::cos(around), p.y, p.x * std::sin(around));
        }
    const auto at = [&](std::size_t ring, int column) {
        return static_cast<std::uint32_t>(ring) * static_cast<std::uint32_t>(columns) +
               static_cast<std::uint32_t>(column % columns);
    };
    for (std::size_t ring = 0; ring + 1 < profile.size(); ++ring)
        for (int column = 0; column < columns; ++column) {
            const std::uint32_t a = at(ring, column), b = at(ring, column + 1);
            const std::uint32_t c = at(ring + 1, column), d = at(ring + 1, column + 1);
            mesh.indices.insert(mesh.indices.end(), {a, c, b, b, c, d});
        }
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0, 1, 0));
    return mesh;
}

}  // namespace

TEST_F(picture_and_drawing, of_the_prism_have_the_same_ink)
{
    open(HATCHWAY_SOURCE_DIR "/content/models/prism.glb");
    expect_alike("prism_a", overview_camera(scene_.bounds_world, 640.0 / 420.0), kFound, kApart);
    expect_alike("prism_b", {{3, 1, 7}, {0, 0, 0}, 60.0}, kFound, kApart);
}

TEST_F(picture_and_drawing, of_the_hall_have_the_same_ink)
{
    open(HATCHWAY_SOURCE_DIR "/content/models/hall.glb");
    load(style_);
    expect_alike_as_loaded("hall_a", {{0, 1.7, 9.6}, {0, 3, -9}, 60.0});
    expect_alike_as_loaded("hall_b", {{20.6, 1.55, 7.2}, {10.5, 4, -4.5}, 60.0});
}

TEST_F(picture_and_drawing, of_round_things_have_the_same_ink)
{
    add(sphere_mesh(1.0f, 24), {-1.3, 1.0, 0.0});
    add(lathe_mesh(32), {1.2, 0.0, 0.0});
    expect_alike("round", {{0.4, 2.2, 4.5}, {0, 0.8, 0}, 50.0}, kFound, kApart);
}

TEST_F(picture_and_drawing, of_boxes_that_go_through_each_other_have_the_same_ink)
{
    add(floor_mesh(8.0f), {0, 0, 0});
    add(box_mesh({2.0f, 2.0f, 1.0f}), {0, 0.6, 0});
    add(box_mesh({1.0f, 3.0f, 2.4f}), {0.4, 0.9, 0.3});
    add(sphere_mesh(0.9f, 12), {-1.2, 0.5, 0.6});
    expect_alike("boxes", {{2.6, 2.4, 5.0}, {0, 0.7, 0}, 50.0}, kFound, kApart);
    expect_alike("boxes_turned", {{2.6, 2.4, 5.0}, {0, 0.7, 0}, 50.0, {}, 33.0}, kFound, kApart);
    expect_alike("boxes_from_above", {{0.1, 7.0, 0.1}, {0.1, 0, 0.1}, 50.0, {}, -70.0}, kFound, kApart);
}

TEST_F(picture_and_drawing, of_kit_pieces_side_by_side_have_the_same_ink)
{
    for (int x = 0; x < 4; ++x)
        for (int z = 0; z < 4; ++z) add(floor_mesh(1.0f), {x, 0, z});
    for (int x = 0; x < 4; ++x) add(box_mesh({1.0f, 2.0f, 0.25f}), {x, 1.0, -0.625});
    for (int z = 0; z < 3; ++z) add(box_mesh({0.25f, 1.0f + z % 2, 1.0f}), {-0.625, 0.5 * (1 + z % 2), z});
    expect_alike("kit", {{3.6, 2.6, 6.5}, {1.2, 0.6, 0.6}, 50.0});
}

TEST_F(picture_and_drawing, of_the_dungeon_have_the_same_ink)
{
    const std::filesystem::path file = HATCHWAY_SOURCE_DIR "/../shared/data/scenes/dungeon_kaykit_9x7.glb";
    HATCHWAY_NEEDS_DATA(std::filesystem::exists(file), file);
    open(file);
    expect_alike("dungeon", {{2, 1.7, 2}, {8, 1.7, 6}, 60.0});
}

TEST_F(picture_and_drawing, of_two_styles_on_one_object_each_have_their_own_creases)
{
    // Folds of 15 degrees: one style draws them, the other does not.
    add(sphere_mesh(1.0f, 12), {0, 0, 0});
    TestStyle fine{glm::vec3(1.0f)}, coarse{glm::vec3(1.0f)};
    fine.look.emplace();
    fine.crease_rad = 0.1f;
    fine.look->far.is_on = false;
    coarse.look = fine.look;
    StyledObject look{.style = 0, .over = 1, .presence = {.constant = 0.5f}};
    load({{"fine", &fine}, {"coarse", &coarse}}, {look});
    expect_alike_as_loaded("two_styles", {{0.3, 1.2, 3.2}, {0, 0, 0}, 50.0});
    const View view = view_from({0.3, 1.2, 3.2}, {0, 0, 0});
    const std::vector<ObjectPens> pens = object_pens(scene_, input_.styles, input_.objects, view);
    EXPECT_EQ(pens[0].edges.crease_rad, (std::vector<float>{0.1f, 0.7f}));
}

TEST_F(picture_and_drawing, by_hand_have_the_same_strokes)
{
    add(box_mesh({2.03f, 1.37f, 1.11f}), {0.07, 0.7, 0});
    add(sphere_mesh(0.6f, 24), {1.7, 0.6, 0.8});
    const CameraPlace camera{{1.6, 2.4, 4.4}, {0.3, 0.6, 0}, 50.0};
    style_.look->stroke = {.wobble_px = 3.0f, .bend_px = 30.0f, .taper_px = 20.0f};
    expect_alike("bent", camera);
    style_.look->stroke = {.overshoot_px = 30.0f};
    expect_alike("overshot", camera);
    style_.look->stroke = {.dash_px = 16.0f, .dash_share = 0.5f};
    expect_alike("dashed", camera);
}

TEST_F(picture_and_drawing, in_parallel_projection_have_the_same_ink)
{
    add(floor_mesh(8.0f), {0, 0, 0});
    add(box_mesh({2.0f, 2.0f, 1.0f}), {0, 0.6, 0});
    add(box_mesh({1.0f, 3.0f, 2.4f}), {0.4, 0.9, 0.3});
    add(sphere_mesh(0.9f, 12), {-1.2, 0.5, 0.6});
    add(lathe_mesh(32), {2.4, 0.0, 1.2});
    load(style_);
    expect_alike_as_loaded("oblique", {{2.6, 2.4, 5.0}, {0, 0.7, 0}, 60.0, 7.0});
    expect_alike_as_loaded("elevation", {{0.0, 1.0, 9.0}, {0, 1.0, 0}, 60.0, 5.0});
    expect_alike_as_loaded("plan", {{0.2, 9.0, 0.1}, {0.2, 0.0, 0.1}, 60.0, 9.0});
    expect_alike_as_loaded("from_afar", {{260, 240, 500.0}, {0, 0.7, 0}, 60.0, 7.0});
}

TEST_F(picture_and_drawing, of_the_hall_in_parallel_projection_have_the_same_ink)
{
    open(HATCHWAY_SOURCE_DIR "/content/models/hall.glb");
    load(style_);
    expect_alike_as_loaded("hall_parallel", {{0, 1.7, 9.6}, {0, 3, -9}, 60.0, 8.0});
    expect_alike_as_loaded("hall_outside", {{60, 40, 50}, {8, 2, 0}, 60.0, 14.0});
    // Here a pixel is 7 cm, and the foot of each gable stands 2 cm behind the front of its wall: nearer than the
    // polygon offset, which is the picture's limit. It leaks along 200 px, as wide as an outline.
    expect_alike_as_loaded("hall_afar", {{60, 40, 50}, {8, 2, 0}, 60.0, 30.0}, 0.991);
}

}  // namespace hw::test
