#include "measure/light/light_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "hatchway/core/error.hpp"
#include "measure/light/light_reference.hpp"
#include "measure/no_value.hpp"

namespace hw {
namespace {

constexpr double kWallM = 0.05;
constexpr float kOutsideLux = 100000.0f;

ObjectId add_object(Scene& scene, int material, MeshData mesh, const glm::dmat4& world_from_object)
{
    Box bounds_world;
    for (const glm::vec3& p : mesh.positions) {
        mesh.normals.emplace_back(0.0f);
        bounds_world.add(glm::dvec3(world_from_object * glm::dvec4(glm::dvec3(p), 1.0)));
    }
    scene.meshes.push_back(std::move(mesh));
    scene.nodes.push_back({.world_from_node = world_from_object});
    scene.objects.push_back({.node = static_cast<int>(scene.nodes.size()) - 1,
                             .mesh = static_cast<int>(scene.meshes.size()) - 1,
                             .material = material,
                             .bounds_world = bounds_world});
    return static_cast<ObjectId>(scene.objects.size() - 1);
}

void append_quad(MeshData& mesh, const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::dvec3& p : {corner, corner + u, corner + u + v, corner + v}) mesh.positions.emplace_back(p);
    for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + k);
}

/// A black floor of 4 m, its middle at the origin.
LightCase over_floor(const std::string& name)
{
    LightCase result;
    result.name = name;
    result.measured = add_quad(result.scene, add_material(result.scene, 0.0f), {-2, 0, -2}, {0, 0, 4}, {4, 0, 0});
    return result;
}

LightCase point_case()
{
    LightCase result = over_floor("point");
    const glm::dvec3 lamp(0.3, 1.5, -0.2);
    result.sources.lights.push_back({.type = LightType::point, .intensity = 1000.0f, .position_world = lamp});
    result.reference = [lamp](const glm::dvec3& place, const glm::dvec3& normal) {
        return point_illuminance(1000.0, lamp, place, normal);
    };
    return result;
}

LightCase sun_case()
{
    LightCase result = over_floor("sun");
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.4, -0.8, 0.3));
    result.sources.lights.push_back({.type = LightType::sun, .intensity = 50000.0f, .direction_world = direction});
    result.reference = [direction](const glm::dvec3&, const glm::dvec3& normal) {
        return 50000.0 * glm::dot(-direction, normal);
    };
    return result;
}

const std::array<glm::dvec3, 4> kPlate{{{-0.6, 1.2, -0.5}, {0.6, 1.2, -0.5}, {0.6, 1.2, 0.5}, {-0.6, 1.2, 0.5}}};

LightCase rectangle_case()
{
    LightCase result = over_floor("rectangle");
    add_quad(result.scene, add_material(result.scene, 0.0f, 1.0f), kPlate[0], kPlate[1] - kPlate[0],
             kPlate[3] - kPlate[0]);
    result.sources.emission_luminance = 5000.0f;
    result.reference = [](const glm::dvec3& place, const glm::dvec3& normal) {
        return polygon_illuminance(5000.0, kPlate, place, normal);
    };
    return result;
}

LightCase covered_sky_case()
{
    LightCase result = over_floor("covered sky");
    add_quad(result.scene, add_material(result.scene, 0.0f), kPlate[0], kPlate[1] - kPlate[0], kPlate[3] - kPlate[0]);
    result.sources.sky_luminance = glm::vec3(3000.0f);
    result.reference = [](const glm::dvec3& place, const glm::dvec3& normal) {
        return glm::pi<double>() * 3000.0 - polygon_illuminance(3000.0, kPlate, place, normal);
    };
    return result;
}

/// A black wall across the floor of over_floor(), a sun so low that all of the floor behind it is in shadow, and the
/// sky. `reach_m`: how far from the wall the floor is judged, on the sunny side alone unless it is all of it.
LightCase wall_case(const std::string& name, double reach_m)
{
    constexpr double kHalf_m = 0.1, kHigh_m = 2.0, kSky = 3000.0, kSun = 20000.0;
    LightCase result = over_floor(name);
    add_box(result.scene, add_material(result.scene, 0.0f), {{-kHalf_m, 0, -2}, {kHalf_m, kHigh_m, 2}});
    const glm::dvec3 direction = glm::normalize(glm::dvec3(-2.0, -1.0, 0.0));
    result.sources.lights.push_back({.type = LightType::sun, .intensity = kSun, .direction_world = direction});
    result.sources.sky_luminance = glm::vec3(kSky);
    const bool is_all = reach_m >= 2.0;
    result.reference = [=](const glm::dvec3& place, const glm::dvec3& normal) {
        const double away_m = std::abs(place.x) - kHalf_m;
        if (away_m <= 0.0 || away_m > reach_m || (!is_all && place.x < 0.0)) return measure::kNoValue;
        const double x = std::copysign(kHalf_m, place.x), z = place.x > 0.0 ? 2.0 : -2.0;
        const std::array<glm::dvec3, 4> face{{{x, 0, -z}, {x, kHigh_m, -z}, {x, kHigh_m, z}, {x, 0, z}}};
        const double sun = place.x > 0.0 ? kSun * glm::dot(-direction, normal) : 0.0;
        return glm::pi<double>() * kSky - polygon_illuminance(kSky, face, place, normal) + sun;
    };
    return result;
}

LightCase closed_room_case()
{
    LightCase result;
    result.name = "bright closed room";
    result.measured = add_box(result.scene, add_material(result.scene, 0.5f, 1.0f), {{-1, 0, -1.5}, {1, 2, 1.5}},
                              glm::dmat4(1.0), true);
    result.sources.emission_luminance = 1000.0f;
    result.luxels_per_m = 4.0;
    result.reference = [](const glm::dvec3&, const glm::dvec3&) { return closed_room_illuminance(1000.0, 0.5); };
    return result;
}

/// A gray room with a window to the sun and a lamp, compared with itself: the light that bounces has no closed form.
LightCase lit_room_case()
{
    LightCase result;
    result.name = "lit room";
    Scene& scene = result.scene;
    const int gray = add_material(scene, 0.6f);
    result.measured = add_quad(scene, gray, {-2, 0, -2}, {0, 0, 4}, {4, 0, 0});
    add_quad(scene, gray, {-2, 3, -2}, {4, 0, 0}, {0, 0, 4});
    add_quad(scene, gray, {-2, 0, -2}, {4, 0, 0}, {0, 3, 0});
    add_quad(scene, gray, {2, 0, 2}, {-4, 0, 0}, {0, 3, 0});
    add_quad(scene, gray, {-2, 0, 2}, {0, 0, -4}, {0, 3, 0});
    add_quad(scene, gray, {2, 0, -2}, {0, 0, 4}, {0, 1, 0});
    add_box(scene, gray, {{-0.5, 0, -0.5}, {0.3, 0.8, 0.4}});
    const glm::dvec3 direction = glm::normalize(glm::dvec3(-1.0, -0.7, 0.2));
    result.sources.lights.push_back({.type = LightType::sun, .intensity = 50000.0f, .direction_world = direction});
    result.sources.lights.push_back(
        {.type = LightType::point, .intensity = 5000.0f, .position_world = {-1.0, 2.5, -1.0}});
    result.sources.sky_luminance = glm::vec3(3000.0f);
    result.sources.ground_luminance = glm::vec3(1000.0f);
    result.luxels_per_m = 4.0;
    return result;
}

DarkRoom bright_surroundings(const std::string& name, const glm::dmat4& world_from_room)
{
    DarkRoom room;
    room.name = name;
    room.inside = {{-1.5, 0.0, -1.0}, {1.5, 2.4, 1.0}};
    room.room_from_world = glm::inverse(world_from_room);
    for (const glm::dvec3& direction :
         {glm::dvec3(0.5, -0.7, 0.3), glm::dvec3(-0.6, -0.4, -0.5), glm::dvec3(0.1, 0.9, 0.2)})
        room.sources.lights.push_back(
            {.type = LightType::sun, .intensity = kOutsideLux, .direction_world = glm::normalize(direction)});
    room.sources.sky_luminance = glm::vec3(kOutsideLux / 3.0f);
    room.sources.ground_luminance = glm::vec3(kOutsideLux / 3.0f);
    return room;
}

/// The four walls around a room, upright slabs that overlap at the corners.
void add_walls(DarkRoom& room, int material, const glm::dmat4& world_from_room)
{
    const Box& in = room.inside;
    const glm::dvec3 out(kWallM);
    const Box around{in.min - out, in.max + out};
    add_box(room.scene, material, {{around.min.x, in.min.y, around.min.z}, {in.min.x, in.max.y, around.max.z}},
            world_from_room);
    add_box(room.scene, material, {{in.max.x, in.min.y, around.min.z}, {around.max.x, in.max.y, around.max.z}},
            world_from_room);
    add_box(room.scene, material, {{around.min.x, in.min.y, around.min.z}, {around.max.x, in.max.y, in.min.z}},
            world_from_room);
    add_box(room.scene, material, {{around.min.x, in.min.y, in.max.z}, {around.max.x, in.max.y, around.max.z}},
            world_from_room);
}

DarkRoom room_of_slabs(const std::string& name, const glm::dmat4& world_from_room, double floor_overhang_m)
{
    DarkRoom room = bright_surroundings(name, world_from_room);
    const int white = add_material(room.scene, 0.8f);
    add_walls(room, white, world_from_room);
    const Box& in = room.inside;
    const glm::dvec3 far(kWallM + floor_overhang_m, 0.0, kWallM + floor_overhang_m);
    const glm::dvec3 near(kWallM, 0.0, kWallM);
    const glm::dvec3 thick(0.0, kWallM, 0.0);
    add_box(room.scene, white, {in.min - far - thick, {in.max.x + far.x, in.min.y, in.max.z + far.z}}, world_from_room);
    add_box(room.scene, white, {{in.min.x - near.x, in.max.y, in.min.z - near.z}, in.max + near + thick},
            world_from_room);
    return room;
}

DarkRoom shell_room(const std::string& name, const glm::dmat4& world_from_room)
{
    DarkRoom room = bright_surroundings(name, world_from_room);
    const int white = add_material(room.scene, 0.8f);
    add_box(room.scene, white, room.inside, world_from_room, true);
    add_box(room.scene, white, {room.inside.min - kWallM, room.inside.max + kWallM}, world_from_room);
    return room;
}

}  // namespace

int add_material(Scene& scene, float albedo, float emission)
{
    scene.materials.push_back({.base_colour = glm::vec4(glm::vec3(albedo), 1.0f), .emissive = glm::vec3(emission)});
    return static_cast<int>(scene.materials.size()) - 1;
}

ObjectId add_quad(Scene& scene, int material, const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v)
{
    MeshData mesh;
    append_quad(mesh, corner, u, v);
    return add_object(scene, material, std::move(mesh), glm::dmat4(1.0));
}

ObjectId add_box(Scene& scene, int material, const Box& box, const glm::dmat4& world_from_box, bool is_inward)
{
    MeshData mesh;
    const glm::dvec3 size = box.size();
    for (int axis = 0; axis < 3; ++axis)
        for (const bool is_far : {false, true}) {
            glm::dvec3 corner = box.min;
            glm::dvec3 u(0.0), v(0.0);
            u[(axis + 1) % 3] = size[(axis + 1) % 3];
            v[(axis + 2) % 3] = size[(axis + 2) % 3];
            if (is_far) corner[axis] = box.max[axis];
            if (is_far != is_inward)
                append_quad(mesh, corner, u, v);
            else
                append_quad(mesh, corner, v, u);
        }
    return add_object(scene, material, std::move(mesh), world_from_box);
}

std::vector<LightCase> light_cases()
{
    std::vector<LightCase> cases;
    cases.push_back(point_case());
    cases.push_back(sun_case());
    cases.push_back(rectangle_case());
    cases.push_back(covered_sky_case());
    cases.push_back(wall_case("wall on the floor", 2.0));
    cases.push_back(wall_case("foot of the wall", 0.25));
    cases.push_back(closed_room_case());
    cases.push_back(lit_room_case());
    return cases;
}

const LightCase& light_case_named(const std::string& name)
{
    static const std::vector<LightCase> cases = light_cases();
    const auto found = std::find_if(cases.begin(), cases.end(), [&](const LightCase& c) { return c.name == name; });
    HW_ASSERT(found != cases.end());
    return *found;
}

std::vector<DarkRoom> dark_rooms()
{
    const glm::dmat4 straight(1.0);
    const glm::dmat4 turned = glm::rotate(glm::translate(straight, {3.7, 0.21, -8.3}), 0.47, {0.1, 0.98, 0.17});
    std::vector<DarkRoom> rooms;
    for (const auto& [suffix, matrix] : {std::pair{"", straight}, std::pair{", turned", turned}}) {
        rooms.push_back(room_of_slabs(std::string("slabs") + suffix, matrix, 0.0));
        rooms.push_back(shell_room(std::string("shell") + suffix, matrix));
        rooms.push_back(room_of_slabs(std::string("walls on a wide floor") + suffix, matrix, 2.0));
    }
    return rooms;
}

}  // namespace hw
