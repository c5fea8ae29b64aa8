#include "measure/hatching/hatch_probe.hpp"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <string>

#include "hatchway/core/files/files.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/maps/hatch_map.hpp"
#include "hatchway/maps/ink_map.hpp"
#include "hatchway/render/renderer.hpp"
#include "hatchway/render/view/camera_view.hpp"
#include "hatchway/style/style.hpp"

namespace hw {
namespace {

constexpr int kRings = 96;
constexpr double kPi = 3.14159265358979;
constexpr double kSphereShare = 0.06;  // radius over distance: fills a view of 8 degrees
constexpr float kSpacingPx = 8.0f;     // that of the map in its own texels

/// The hatch map alone, its level chosen in one way.
class ProbeStyle final : public Style {
 public:
    explicit ProbeStyle(std::string define) : define_(std::move(define)) {}
    Needs needs() const override
    {
        Needs needs;
        needs.streams.hatch_uv = true;
        return needs;
    }
    void prepare(ProgramCache& programs) override
    {
        program_ = programs.surface("measure/hatch_probe.frag", "#define " + define_ + " 1\n");
    }
    void surfaces(Pass& pass, Items items) override
    {
        Uniforms uniforms;
        uniforms.set("probe_spacing_px", kSpacingPx);
        pass.surfaces(program_, uniforms, items);
    }

 private:
    std::string define_;
    Program program_;
};

/// A plane through the place at -z, turned about the picture's x axis; v of its coordinates rises along it, metres.
MeshData plane_mesh(double angle_deg, double distance_m)
{
    const auto half = static_cast<float>(6.0 * distance_m);
    const double angle = glm::radians(angle_deg);
    const glm::vec3 up(0.0f, std::cos(angle), -std::sin(angle));
    const glm::vec3 middle(0.0f, 0.0f, -static_cast<float>(distance_m));
    MeshData mesh;
    for (const glm::vec2& corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
        mesh.positions.push_back(middle + half * (corner.x * glm::vec3(1, 0, 0) + corner.y * up));
        mesh.normals.emplace_back(0.0f, std::sin(angle), std::cos(angle));
        mesh.uv0.push_back(half * corner);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

/// A sphere; u runs around, v is the height: Archimedes' map, which keeps areas.
MeshData sphere_mesh(double distance_m)
{
    const double radius = kSphereShare * distance_m;
    MeshData mesh;
    for (int ring = 0; ring <= kRings; ++ring)
        for (int i = 0; i <= 2 * kRings; ++i) {
            const double up = kPi * (0.5 - static_cast<double>(ring) / kRings);
            const double around = kPi * i / kRings;
            const glm::dvec3 normal(std::cos(up) * std::sin(around), std::sin(up), std::cos(up) * std::cos(around));
            mesh.positions.emplace_back(normal * radius + glm::dvec3(0.0, 0.0, -distance_m));
            mesh.normals.emplace_back(normal);
            mesh.uv0.emplace_back(radius * around, radius * normal.y);
        }
    const std::uint32_t row = 2 * kRings + 1;
    for (std::uint32_t ring = 0; ring < kRings; ++ring)
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t at = ring * row + i;
            for (const std::uint32_t corner : {at, at + row, at + row + 1, at, at + row + 1, at + 1})
                mesh.indices.push_back(corner);
        }
    return mesh;
}

Scene scene_of(MeshData mesh)
{
    Scene scene;
    Object object{.node = 0, .mesh = 0, .material = 0};
    for (const glm::vec3& position : mesh.positions) object.bounds_world.add(glm::dvec3(position));
    scene.bounds_world = object.bounds_world;
    scene.nodes.push_back({.name = "surface", .path = "surface"});
    scene.materials.push_back({.is_double_sided = true});
    scene.meshes.push_back(std::move(mesh));
    scene.objects.push_back(object);
    return scene;
}

/// The define of hatch_probe.frag.
const char* define_of(LevelChoice choice)
{
    switch (choice) {
        case LevelChoice::ours:
            return "PROBE_OURS";
        case LevelChoice::anisotropic:
            return "PROBE_ANISOTROPIC";
        case LevelChoice::no_mips:
            return "PROBE_FINEST";
        case LevelChoice::trilinear:
        case LevelChoice::ordinary_mips:
            break;
    }
    return "PROBE_TRILINEAR";
}

}  // namespace

std::unique_ptr<Style> make_probe_style(LevelChoice choice)
{
    return std::make_unique<ProbeStyle>(define_of(choice));
}

MapLevels ordinary_levels(const MapLevels& map)
{
    MapLevels filtered = filtered_by_mean(map.levels.front(), map.size_m);
    filtered.kind = map.kind;
    filtered.spacing_texels = map.spacing_texels;
    return filtered;
}

struct HatchProbe::State {
    explicit State(Context& context) : renderer(context) {}

    Renderer renderer;
    MapLevels ours = make_hatch_map({});
    MapLevels ordinary = ordinary_levels(ours);
    std::array<std::unique_ptr<Style>, kLevelChoices.size()> styles;
    Scene scene;
};

HatchProbe::HatchProbe(Context& context) : state_(std::make_unique<State>(context))
{
    ProgramCache& programs = state_->renderer.program_cache(installation_prefix() / "share" / "hatchway" / "shaders");
    for (std::size_t i = 0; i < state_->styles.size(); ++i) {
        state_->styles[i] = make_probe_style(static_cast<LevelChoice>(i));
        state_->styles[i]->prepare(programs);
    }
}

HatchProbe::~HatchProbe() = default;

HatchPicture HatchProbe::draw(const HatchPlace& place, LevelChoice choice, glm::ivec2 size_px, double fov_deg)
{
    const double texel_m = state_->ours.size_m / state_->ours.levels.front().width;
    const double focal_px = 0.5 * size_px.y / std::tan(0.5 * glm::radians(fov_deg));
    const double distance_m = texel_m * focal_px * place.distance;
    state_->scene = scene_of(place.is_sphere ? sphere_mesh(distance_m) : plane_mesh(place.angle_deg, distance_m));

    SceneInput input;
    input.scene = &state_->scene;
    input.maps = {&state_->ours, &state_->ordinary};
    input.styles = {{"probe", state_->styles[static_cast<std::size_t>(choice)].get()}};
    StyledObject look;
    look.style = 0;
    look.maps[MapKind::hatch] = choice == LevelChoice::ordinary_mips ? 1 : 0;
    input.objects = {look};
    state_->renderer.load(std::move(input));

    const View view = camera_view({.fov_deg = fov_deg}, size_px, state_->scene.bounds_world);
    const FrameOptions options{.samples = 1, .is_timed = true};
    HatchPicture picture;
    picture.surfaces_ms = 1e9;
    for (int i = 0; i < 3; ++i)
        picture.surfaces_ms = std::min(picture.surfaces_ms, state_->renderer.draw(view, options).surfaces_ms);
    picture.pixels = state_->renderer.read_picture();
    return picture;
}

std::vector<double> column_ink(const Pixels& picture, int x)
{
    std::vector<double> ink;
    for (int y = 0; y < picture.height; ++y) {
        const double srgb = *picture.at(x, y) / 255.0;
        ink.push_back(1.0 - (srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4)));
    }
    return ink;
}

}  // namespace hw
