// What mirrors show is what would be there, were the room built once more behind them: in the styles of the things.
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>

#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/io/images/images.hpp"
#include "hatchway/plugin_host/style_set.hpp"
#include "hatchway/render/mirror_views.hpp"
#include "hatchway/render/renderer.hpp"
#include "hatchway/render/view/camera_view.hpp"
#include "hatchway/world/mirrors.hpp"
#include "hatchway/world/visibility/visibility.hpp"
#include "tests/plugin_host/plugin_tests.hpp"

using namespace hw;
using namespace hw::test;

namespace {

constexpr glm::ivec2 kSize{360, 270};
constexpr glm::dmat4 kHere(1.0);

MeshData quads_mesh(const std::vector<std::array<glm::vec3, 4>>& quads)
{
    MeshData mesh;
    for (const auto& corners : quads) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::vec3& corner : corners) {
            mesh.positions.push_back(corner);
            mesh.normals.push_back(glm::normalize(glm::cross(corners[1] - corners[0], corners[3] - corners[0])));
        }
        for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + i);
    }
    mesh.has_own_normals = true;
    return mesh;
}

MeshData box_between(const glm::vec3& a, const glm::vec3& b)
{
    return quads_mesh({{{{a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}}},
                       {{{b.x, a.y, a.z}, {a.x, a.y, a.z}, {a.x, b.y, a.z}, {b.x, b.y, a.z}}},
                       {{{b.x, a.y, b.z}, {b.x, a.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}}},
                       {{{a.x, a.y, a.z}, {a.x, a.y, b.z}, {a.x, b.y, b.z}, {a.x, b.y, a.z}}},
                       {{{a.x, b.y, b.z}, {b.x, b.y, b.z}, {b.x, b.y, a.z}, {a.x, b.y, a.z}}},
                       {{{a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, a.y, b.z}, {a.x, a.y, b.z}}}});
}

MeshData ball(float radius)
{
    constexpr int kRings = 24, kColumns = 48;
    MeshData mesh;
    for (int ring = 0; ring <= kRings; ++ring)
        for (int column = 0; column < kColumns; ++column) {
            const double polar = M_PI * ring / kRings, around = 2.0 * M_PI * column / kColumns;
            const glm::vec3 n(std::sin(polar) * std::cos(around), std::cos(polar), std::sin(polar) * std::sin(around));
            mesh.positions.push_back(radius * n);
            mesh.normals.push_back(n);
        }
    for (int ring = 0; ring < kRings; ++ring)
        for (int column = 0; column < kColumns; ++column) {
            const auto at = [&](int r, int c) { return static_cast<std::uint32_t>(r * kColumns + c % kColumns); };
            const std::uint32_t a = at(ring, column), b = at(ring, column + 1);
            const std::uint32_t c = at(ring + 1, column), d = at(ring + 1, column + 1);
            if (ring > 0) mesh.indices.insert(mesh.indices.end(), {a, b, c});
            if (ring < kRings - 1) mesh.indices.insert(mesh.indices.end(), {b, d, c});
        }
    mesh.has_own_normals = true;
    return mesh;
}

/// A wall across x, looking towards +x or, by `side` -1, the other way.
std::array<glm::vec3, 4> wall(float x, float side, glm::vec2 low_yz, glm::vec2 high_yz)
{
    const float a = side > 0 ? high_yz.y : low_yz.y, b = side > 0 ? low_yz.y : high_yz.y;
    return {glm::vec3(x, low_yz.x, a), glm::vec3(x, low_yz.x, b), glm::vec3(x, high_yz.x, b),
            glm::vec3(x, high_yz.x, a)};
}

struct Room {
    Scene scene;
    std::vector<ObjectId> panes;

    ObjectId add(const MeshData& mesh, const glm::dmat4& place, const glm::vec3& colour)
    {
        Box bounds;
        for (const glm::vec3& position : mesh.positions) bounds.add(glm::dvec3(position));
        Object object{.node = static_cast<int>(scene.nodes.size()),
                      .mesh = static_cast<int>(scene.meshes.size()),
                      .material = static_cast<int>(scene.materials.size()),
                      .bounds_world = transformed(bounds, place)};
        Material material;
        material.base_colour = glm::vec4(colour, 1.0f);
        material.metallic = 0.0f;
        scene.materials.push_back(material);
        scene.nodes.push_back({.name = "n", .path = fmt::format("n{}", object.node)});
        scene.nodes.back().local = scene.nodes.back().world_from_node = place;
        scene.bounds_world.add(object.bounds_world);
        scene.meshes.push_back(mesh);
        scene.objects.push_back(object);
        return static_cast<ObjectId>(scene.objects.size() - 1);
    }
};

constexpr ObjectId kBack = 0, kFloor = 1;
constexpr glm::vec2 kLow{0.4f, -1.6f}, kHigh{2.6f, 1.4f};  // of the hole in the wall x = 0, y and z

/// A room with a hole in the wall x = 0, whose front faces look towards +x, once or once more behind the hole.
Room room(bool has_twin)
{
    Room room;
    const auto rot = glm::rotate(glm::translate(kHere, glm::dvec3(1.1, 0.3, 0.9)), 0.5, glm::dvec3(0.3, 1.0, 0.1));
    // Through the wall, so that no border of two lies at it: the mirror's plane cuts them. Photoreal: no stroke that
    // would go on through the hole as it began, and not as in a mirror.
    room.add(quads_mesh({{{{-4, 0, -3}, {4, 0, -3}, {4, 3, -3}, {-4, 3, -3}}}}), kHere, {0.7f, 0.7f, 0.6f});
    room.add(quads_mesh({{{{-4, 0, 3}, {4, 0, 3}, {4, 0, -3}, {-4, 0, -3}}}}), kHere, {0.4f, 0.3f, 0.2f});
    std::vector<glm::dmat4> places{kHere};
    if (has_twin) places.push_back(glm::scale(kHere, glm::dvec3(-1.0, 1.0, 1.0)));
    for (const glm::dmat4& place : places) {
        room.add(quads_mesh({wall(0, 1, {0, -3}, {3, kLow.y}), wall(0, 1, {0, kHigh.y}, {3, 3}),
                             wall(0, 1, {0, kLow.y}, {kLow.x, kHigh.y}), wall(0, 1, {kHigh.x, kLow.y}, {3, kHigh.y})}),
                 place, {0.6f, 0.5f, 0.4f});
        room.add(quads_mesh({wall(4, -1, {0, -3}, {3, 3})}), place, {0.5f, 0.6f, 0.4f});
        room.add(box_between({-0.3f, 0.0f, -0.3f}, {0.3f, 0.7f, 0.3f}), place * rot, {0.2f, 0.3f, 0.7f});
        room.add(ball(0.45f), place * glm::translate(kHere, glm::dvec3(0.8, 1.2, -1.0)), {0.7f, 0.2f, 0.15f});
        room.add(box_between({2.4f, 0.0f, -2.4f}, {3.0f, 2.2f, -1.9f}), place, {0.3f, 0.5f, 0.3f});
    }
    return room;
}

Room room_with_mirror()
{
    Room mirrored = room(false);
    mirrored.panes.push_back(mirrored.add(quads_mesh({wall(0, 1, kLow, kHigh)}), kHere, {0.1f, 0.1f, 0.1f}));
    return mirrored;
}

/// Two rooms side by side that both open to a third, in whose far wall there is a mirror: from the one the other is
/// seen in it alone. In the other a ball, or none.
Room three_rooms(bool has_ball)
{
    Room rooms;
    const auto block = [&](const glm::vec3& low, const glm::vec3& high) {
        rooms.add(box_between(low, high), kHere, {0.6f, 0.5f, 0.4f});
    };
    block({-0.2f, -0.2f, -3.2f}, {4.2f, 0.0f, 7.2f});
    block({-0.2f, 3.0f, -3.2f}, {4.2f, 3.2f, 7.2f});
    block({-0.2f, 0.0f, -3.2f}, {0.0f, 3.0f, 7.2f});
    block({4.0f, 0.0f, -3.2f}, {4.2f, 3.0f, 7.2f});
    block({0.0f, 0.0f, -3.2f}, {4.0f, 3.0f, -3.0f});
    block({0.0f, 0.0f, 7.0f}, {4.0f, 3.0f, 7.2f});
    block({0.0f, 0.0f, 3.0f}, {0.5f, 3.0f, 3.2f});
    block({1.5f, 0.0f, 3.0f}, {2.5f, 3.0f, 3.2f});
    block({3.5f, 0.0f, 3.0f}, {4.0f, 3.0f, 3.2f});
    block({2.3f, 0.0f, 3.2f}, {2.5f, 3.0f, 7.0f});
    rooms.add(ball(0.4f), glm::translate(kHere, glm::dvec3(has_ball ? 0.9 : 3.7, 1.4, has_ball ? 4.6 : 2.5)),
              {0.7f, 0.2f, 0.15f});
    rooms.panes.push_back(rooms.add(
        quads_mesh({{{{0.4f, 0.3f, -2.95f}, {3.6f, 0.3f, -2.95f}, {3.6f, 2.7f, -2.95f}, {0.4f, 2.7f, -2.95f}}}}), kHere,
        {0.1f, 0.1f, 0.1f}));
    return rooms;
}

struct Drawn {
    Pixels picture;
    FrameStats stats;
};

struct HowDrawn {
    std::string style = "photoreal";
    int mirror_depth = 1;
    double reflectance = 1.0;
    glm::vec3 tint{1.0f};
    bool with_pvs = false;
    bool is_es = false;
    FrameOptions options = {};
};

Drawn drawn(const Room& room, const CameraPlace& camera, const HowDrawn& how = {})
{
    const auto context = make_headless_context({.is_es = how.is_es});
    Renderer renderer(*context);
    StyleSet set(test_registry(),
                 [&](const std::filesystem::path& folder) -> ProgramCache& { return renderer.program_cache(folder); });
    Level level;
    level.styles["things"] = {.plugin = how.style};
    level.styles["plain"] = {.plugin = "photoreal"};
    for (const ObjectId pane : room.panes)
        level.mirrors.push_back(
            {room.scene.nodes[room.scene.objects[pane].node].path, how.reflectance, how.tint, "/m"});
    set.set_level(level);
    std::vector<MeshChunks> chunks;
    Scene scene = room.scene;
    for (MeshData& mesh : scene.meshes) chunks.push_back(split_into_chunks(mesh));
    Visibility visibility;
    SceneInput input;
    input.scene = &scene;
    input.chunks = chunks;
    if (how.with_pvs) {
        visibility = build_visibility(scene, level, chunks, {.threads = 2});
        input.visibility = &visibility;
    }
    input.objects.resize(scene.objects.size());
    for (StyledObject& object : input.objects) object.style = set.use("things", "");
    for (const ObjectId plain : {kBack, kFloor}) input.objects[plain].style = set.use("plain", "");
    for (const ObjectId pane : room.panes) input.objects[pane].style = set.use("plain", "");
    input.styles = set.styles();
    input.image_passes = set.image_passes();
    Light light;  // in the mirror's plane, so that it lights both rooms alike
    light.type = LightType::point;
    light.position_world = {0.0, 2.9, 0.8};
    light.intensity = 900.0f;
    input.lights = {light};
    input.exposure_ev = 7.0f;
    input.mirrors = find_mirrors(level, scene);
    input.mirror_depth = how.mirror_depth;
    renderer.load(std::move(input));
    Drawn result;
    result.stats = renderer.draw(camera_view(camera, kSize, scene.bounds_world), how.options);
    result.picture = renderer.read_picture();
    EXPECT_TRUE(context->take_errors().empty());
    return result;
}

void keep(const Pixels& pixels, const std::string& name)
{
    if (const char* folder = std::getenv("HATCHWAY_TEST_PICTURES"))
        write_png(std::filesystem::path(folder) / (name + ".png"), pixels);
}

/// Where the pane's corners are in the picture, pixels from its lower left corner.
std::vector<glm::dvec2> corners_px(const CameraPlace& camera, const Scene& scene)
{
    const View view = camera_view(camera, kSize, scene.bounds_world);
    std::vector<glm::dvec2> corners;
    for (const glm::vec3& corner : wall(0, 1, kLow, kHigh)) {
        const glm::dvec4 clip =
            glm::dmat4(view.clip_from_view) * glm::dmat4(view.view_from_world) * glm::dvec4(glm::dvec3(corner), 1.0);
        corners.push_back((glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(kSize));
    }
    return corners;
}

double distance(const glm::dvec2& place, const glm::dvec2& a, const glm::dvec2& b)
{
    const double share = std::clamp(glm::dot(place - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::length(place - glm::mix(a, b, share));
}

/// Pixels in which some channel differs by more than `tolerance`, but for those near the pane's outline: an edge of the
/// wall where there is a hole, one of two things in a plane where there is a pane.
int unlike(const Pixels& a, const Pixels& b, const std::vector<glm::dvec2>& outline_px = {}, int tolerance = 12)
{
    constexpr double kNear_px = 5.0;
    int count = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const glm::dvec2 place(x + 0.5, a.height - y - 0.5);
            bool is_near = false;
            for (std::size_t i = 0; i < outline_px.size(); ++i)
                is_near |= distance(place, outline_px[i], outline_px[(i + 1) % outline_px.size()]) < kNear_px;
            if (is_near) continue;
            int most = 0;
            for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(a.at(x, y)[c] - b.at(x, y)[c]));
            count += most > tolerance ? 1 : 0;
        }
    return count;
}

const CameraPlace kBefore{{2.6, 1.6, 1.7}, {-0.6, 1.2, -0.6}, 60.0};
const CameraPlace kGrazing{{0.45, 1.5, 2.6}, {-0.35, 1.3, -1.4}, 60.0};
const CameraPlace kParallel{{3.0, 1.7, 2.0}, {0.0, 1.3, -0.1}, 60.0, 2.4};
const CameraPlace kAway{{1.0, 1.5, 0.0}, {4.0, 1.2, 0.0}, 60.0};

}  // namespace

TEST(mirrors, show_in_every_style_what_the_room_built_once_more_behind_the_wall_would)
{
    for (const auto& [name, camera] :
         {std::pair("before", kBefore), std::pair("grazing", kGrazing), std::pair("parallel", kParallel)}) {
        const std::vector<glm::dvec2> outline_px = corners_px(camera, room(true).scene);
        const Drawn blind = drawn(room_with_mirror(), camera, {.reflectance = 0.0});
        for (const char* style : {"photoreal", "pen_and_ink", "hybrid", "technical", "id_outline", "cartoon"}) {
            const Drawn built = drawn(room(true), camera, {.style = style});
            const Drawn mirrored = drawn(room_with_mirror(), camera, {.style = style});
            keep(built.picture, fmt::format("mirror_{}_{}_built", style, name));
            keep(mirrored.picture, fmt::format("mirror_{}_{}_mirrored", style, name));
            EXPECT_EQ(built.stats.mirror_views, 0);
            EXPECT_EQ(mirrored.stats.mirror_views, 1);
            EXPECT_GT(unlike(built.picture, blind.picture, outline_px), 8000) << "the mirror is seen";
            // Lines from images of what stands before the mirror know what is behind it: the pane, or something
            // farther.
            EXPECT_LT(unlike(built.picture, mirrored.picture, outline_px), 80) << style << ' ' << name;
        }
    }
}

TEST(mirrors, show_the_same_by_opengl_es)
{
    for (const char* style : {"photoreal", "pen_and_ink", "technical"}) {
        const Drawn es = drawn(room_with_mirror(), kBefore, {.style = style, .is_es = true});
        EXPECT_LT(unlike(es.picture, drawn(room_with_mirror(), kBefore, {.style = style}).picture), 80) << style;
    }
}

TEST(mirrors, that_are_out_of_view_or_seen_from_behind_are_not_drawn)
{
    const Room room = room_with_mirror();
    EXPECT_EQ(drawn(room, kBefore).stats.mirror_views, 1);
    EXPECT_EQ(drawn(room, kAway).stats.mirror_views, 0) << "it is behind the eye";
    EXPECT_EQ(drawn(room, {{-3.0, 1.5, 0.0}, {0.0, 1.5, 0.0}, 60.0}).stats.mirror_views, 0) << "its back is culled";
    EXPECT_EQ(drawn(room, {{0.0, 1.5, 2.0}, {0.0, 1.5, 0.0}, 60.0}).stats.mirror_views, 0) << "it is seen on edge";
    Room two_sided = room;
    two_sided.scene.materials[two_sided.scene.objects[two_sided.panes[0]].material].is_double_sided = true;
    EXPECT_EQ(drawn(two_sided, {{-3.0, 1.5, 0.0}, {0.0, 1.5, 0.0}, 60.0}).stats.mirror_views, 1);
}

TEST(mirrors, take_of_the_things_own_look_what_the_reflectance_says_and_are_tinted)
{
    const Drawn whole = drawn(room_with_mirror(), kBefore),
                none = drawn(room_with_mirror(), kBefore, {.reflectance = 0});
    const Drawn half = drawn(room_with_mirror(), kBefore, {.reflectance = 0.5});
    const Drawn red = drawn(room_with_mirror(), kBefore, {.tint = {1.0f, 0.0f, 0.0f}});
    int between = 0, seen = 0;
    for (int x = 60; x < 220; ++x) {
        const int a = none.picture.at(x, 120)[1], b = half.picture.at(x, 120)[1], c = whole.picture.at(x, 120)[1];
        seen += std::abs(c - a) > 10;
        between += std::abs(c - a) > 10 && b > std::min(a, c) && b < std::max(a, c);
    }
    EXPECT_GT(seen, 60);
    EXPECT_EQ(between, seen);
    EXPECT_EQ(red.picture.at(100, 80)[0], whole.picture.at(100, 80)[0]);
    EXPECT_EQ(red.picture.at(100, 80)[1], 0);
}

TEST(mirrors, that_face_each_other_show_each_other_as_often_as_the_level_says)
{
    Room hall = room_with_mirror();
    hall.panes.push_back(hall.add(quads_mesh({wall(3.9f, -1, kLow, kHigh)}), kHere, {0.1f, 0.1f, 0.1f}));
    Pixels last;
    for (int depth = 1; depth <= 4; ++depth) {
        const Drawn deep = drawn(hall, {{2.0, 1.6, 0.4}, {0.0, 1.5, -0.1}, 60.0}, {.mirror_depth = depth});
        keep(deep.picture, fmt::format("mirror_depth_{}", depth));
        EXPECT_EQ(deep.stats.mirror_views, depth);
        if (depth > 1) {
            EXPECT_GT(unlike(last, deep.picture), 100) << depth;
        }
        last = deep.picture;
    }
}

TEST(mirrors, that_see_each_other_without_end_stop_at_a_number_of_views)
{
    Room hall = room(false);
    for (int i = 0; i < 40; ++i) {
        const float low = -2.8f + 0.14f * static_cast<float>(i);
        for (const float side : {1.0f, -1.0f})
            hall.panes.push_back(
                hall.add(quads_mesh({wall(side > 0 ? 0.05f : 3.9f, side, {0.2f, low}, {2.8f, low + 0.1f})}), kHere,
                         {0.1f, 0.1f, 0.1f}));
    }
    const Drawn many = drawn(hall, kBefore, {.mirror_depth = 4});
    EXPECT_EQ(many.stats.mirror_views, kMostMirrorViews);
}

TEST(mirrors, show_the_same_with_and_without_a_pvs_and_draw_less_with_it)
{
    const Room rooms = three_rooms(true);
    const CameraPlace camera{{3.0, 1.5, 6.2}, {2.7, 1.4, -3.0}, 40.0};
    for (const char* style : {"photoreal", "pen_and_ink", "technical"}) {
        const Drawn all = drawn(rooms, camera, {.style = style, .with_pvs = true, .options = {.use_pvs = false}});
        const Drawn some = drawn(rooms, camera, {.style = style, .with_pvs = true});
        keep(some.picture, fmt::format("mirror_pvs_{}", style));
        EXPECT_EQ(all.stats.mirror_views, 1);
        EXPECT_EQ(some.stats.mirror_views, 1);
        EXPECT_LT(some.stats.faces_drawn, all.stats.faces_drawn) << "the PVS leaves something out";
        EXPECT_EQ(all.picture.bytes, some.picture.bytes) << style;
    }
    EXPECT_GT(unlike(drawn(rooms, camera).picture, drawn(three_rooms(false), camera).picture), 300)
        << "the ball in the room that the eye's own leaf does not see is seen in the mirror";
    EXPECT_EQ(drawn(rooms, {{3.0, 1.5, 6.2}, {1.0, 1.4, 6.2}, 60.0}, {.with_pvs = true}).stats.mirror_views, 0);
}
