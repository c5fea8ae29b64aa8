#include "hatchway/world/light/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <optional>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/world/light/charts.hpp"
#include "hatchway/world/light/pack.hpp"
#include "hatchway/world/light/scene.hpp"
#include "hatchway/world/open_backs.hpp"

namespace hw {
namespace {

constexpr int kBorder = 1;
constexpr double kMostWaste = 6.0;  // luxels of charts with borders, for each that the surface or a vertex needs
constexpr int kMaxSide = 4096;      // every device that runs GLES 3.0 well has textures of this size
constexpr double kLessDense = 0.85;
constexpr int kMostSteps = 256;  // less dense by 1e18: scenes of any size have a luxel for each chart
constexpr std::array<std::uint16_t, 4> kDark{0, 0, 0, 0x3c00};

/// A chart's own coordinates in luxels.
struct ChartFrame {
    glm::dvec3 origin{0.0};
    glm::dvec3 u{0.0};  // luxels per unit along the chart's two directions
    glm::dvec3 v{0.0};
    glm::ivec2 size{1};

    glm::vec2 at(const glm::vec3& position) const
    {
        const glm::dvec3 from = glm::dvec3(position) - origin;
        return {glm::dot(from, u), glm::dot(from, v)};
    }
};

ChartFrame frame_of(const MeshData& mesh, const PlanarChart& chart, double luxels_per_unit)
{
    const glm::dvec3 across = glm::cross(chart.normal, chart.along);
    glm::dvec2 low(std::numeric_limits<double>::infinity()), high(-std::numeric_limits<double>::infinity());
    for (const std::uint32_t t : chart.triangles)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const glm::dvec3 p(mesh.positions[mesh.indices[t * 3 + k]]);
            const glm::dvec2 at(glm::dot(p, chart.along), glm::dot(p, across));
            low = glm::min(low, at);
            high = glm::max(high, at);
        }
    ChartFrame frame;
    const glm::dvec2 extent = high - low;
    frame.origin = chart.along * low.x + across * low.y;
    for (int axis = 0; axis < 2; ++axis) {
        const double luxels = std::ceil(extent[axis] * luxels_per_unit - 1e-6);
        frame.size[axis] = static_cast<int>(std::clamp(luxels, 1.0, double{kMaxChartLuxels}));
        const double scale = extent[axis] > 0.0 ? frame.size[axis] / extent[axis] : 0.0;
        (axis == 0 ? frame.u : frame.v) = scale * (axis == 0 ? chart.along : across);
    }
    return frame;
}

int strip_width(std::span<const glm::ivec2> sizes, int least)
{
    double area = 0.0;
    int widest = least;
    for (const glm::ivec2& size : sizes) {
        area += static_cast<double>(size.x) * size.y;
        widest = std::max(widest, size.x);
    }
    return sizes.size() < 2 ? widest : std::max(widest, static_cast<int>(std::ceil(std::sqrt(1.1 * area))));
}

/// Gives every corner of a chart's triangles its place, and a vertex of its own where another chart has taken it.
class CornerPlaces {
 public:
    CornerPlaces(const MeshData& mesh, LightmapLayout& layout)
        : mesh_(mesh), layout_(layout), chart_of_vertex_(mesh.positions.size(), kFree)
    {
        layout_.indices = mesh.indices;
        layout_.uv.assign(mesh.positions.size(), glm::vec2(0.0f));
    }
    void place(const PlanarChart& chart, const ChartFrame& frame, glm::ivec2 corner)
    {
        copies_.clear();
        ++number_;
        for (const std::uint32_t t : chart.triangles)
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t vertex = mesh_.indices[t * 3 + k];
                const std::uint32_t own = own_vertex(vertex);
                layout_.indices[t * 3 + k] = own;
                layout_.uv[own] = glm::vec2(corner + kBorder) + frame.at(mesh_.positions[vertex]);
            }
    }

 private:
    static constexpr std::uint32_t kFree = 0xffffffffu;

    std::uint32_t own_vertex(std::uint32_t vertex)
    {
        if (chart_of_vertex_[vertex] == kFree) chart_of_vertex_[vertex] = number_;
        if (chart_of_vertex_[vertex] == number_) return vertex;
        const auto [copy, is_new] = copies_.try_emplace(vertex, static_cast<std::uint32_t>(layout_.uv.size()));
        if (is_new) {
            layout_.uv.emplace_back(0.0f);
            layout_.copied_vertices.push_back(vertex);
        }
        return copy->second;
    }

    const MeshData& mesh_;
    LightmapLayout& layout_;
    std::vector<std::uint32_t> chart_of_vertex_;
    std::map<std::uint32_t, std::uint32_t> copies_;  // of the present chart
    std::uint32_t number_ = 0;
};

/// For each object, whether it gets baked light.
std::vector<bool> find_receivers(const Scene& scene, std::span<const ObjectId> receivers)
{
    std::vector<bool> result(scene.objects.size(), receivers.empty());
    for (const ObjectId id : receivers) result[id] = true;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) result[id] = result[id] && receives_light(scene, id);
    if (std::ranges::find(result, true) == result.end())
        throw Error({.what = "nothing gets baked light",
                     .file = scene.file,
                     .expected = "an object that is visible and whose material is lit"});
    return result;
}

/// Luxels to the unit of object space for each mesh: as the largest of its instances needs. 0: none is lit.
std::vector<double> densities(const Scene& scene, const std::vector<bool>& is_receiver, double luxels_per_m)
{
    std::vector<double> result(scene.meshes.size(), 0.0);
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        if (!is_receiver[id]) continue;
        const glm::dmat3 matrix(scene.world_from_object(id));
        const double scale = std::max({glm::length(matrix[0]), glm::length(matrix[1]), glm::length(matrix[2])});
        double& density = result[scene.objects[id].mesh];
        if (std::isfinite(scale)) density = std::max(density, luxels_per_m * scale);
    }
    return result;
}

/// Places all objects. False: they do not fit.
bool place_objects(const Scene& scene, const std::vector<bool>& is_receiver, const std::vector<bool>& open_backs,
                   std::uint64_t budget, Lightmap& lightmap)
{
    std::vector<glm::ivec2> sizes;
    std::vector<ObjectId> charted;
    std::uint64_t vertex_luxels = 0;
    lightmap.places.assign(scene.objects.size(), {});
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const Object& object = scene.objects[id];
        const LightmapLayout& layout = lightmap.layouts[object.mesh];
        if (!is_receiver[id] || layout.is_empty()) continue;
        LightmapPlace& place = lightmap.places[id];
        place.sides = open_backs[id] ? 2 : 1;
        if (layout.is_per_vertex) {
            vertex_luxels += scene.meshes[object.mesh].positions.size() * place.sides;
            continue;
        }
        charted.push_back(id);
        sizes.push_back({layout.size.x * place.sides, layout.size.y});
    }
    const int width = strip_width(sizes, static_cast<int>(std::min(2048.0, std::ceil(std::sqrt(vertex_luxels)))));
    if (width > kMaxSide) return false;
    const Packing packing = pack_in_rows(sizes, width);
    for (std::size_t i = 0; i < charted.size(); ++i) lightmap.places[charted[i]].corner = packing.corners[i];
    std::uint64_t next = static_cast<std::uint64_t>(packing.height) * width;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        LightmapPlace& place = lightmap.places[id];
        const int mesh = scene.objects[id].mesh;
        if (place.sides == 0 || !lightmap.layouts[mesh].is_per_vertex) continue;
        place.corner = {static_cast<int>(next % width), static_cast<int>(next / width)};
        next += scene.meshes[mesh].positions.size() * place.sides;
    }
    const std::uint64_t height = std::max<std::uint64_t>(1, (next + width - 1) / std::max(width, 1));
    if (height > kMaxSide || height * static_cast<std::uint64_t>(width) > budget) return false;
    lightmap.size = {std::max(width, 1), static_cast<int>(height)};
    return true;
}

}  // namespace

LightmapLayout lay_out(const MeshData& mesh, double luxels_per_unit)
{
    LightmapLayout layout;
    if (mesh.indices.empty()) return layout;
    const std::vector<PlanarChart> charts = planar_charts(mesh);
    std::vector<ChartFrame> frames;
    std::vector<glm::ivec2> sizes;
    double needed = 0.0;
    double taken = 0.0;
    for (const PlanarChart& chart : charts) {
        frames.push_back(frame_of(mesh, chart, luxels_per_unit));
        sizes.push_back(frames.back().size + 2 * kBorder);
        needed += chart.area * luxels_per_unit * luxels_per_unit;
        taken += static_cast<double>(sizes.back().x) * sizes.back().y;
    }
    if (taken > kMostWaste * std::max(needed, static_cast<double>(mesh.positions.size()))) {
        layout.is_per_vertex = true;
        return layout;
    }
    const int width = strip_width(sizes, 1);
    const Packing packing = pack_in_rows(sizes, width);
    layout.size = {width, packing.height};
    CornerPlaces places(mesh, layout);
    for (std::size_t i = 0; i < charts.size(); ++i) places.place(charts[i], frames[i], packing.corners[i]);
    return layout;
}

Lightmap plan_lightmap(const Scene& scene, double luxels_per_m, std::uint64_t budget,
                       std::span<const ObjectId> receivers, std::span<const Light> lights,
                       std::span<const glm::dvec3> eyes_world)
{
    const std::vector<bool> is_receiver = find_receivers(scene, receivers);
    const std::vector<bool> open_backs = find_open_backs(scene, lights, eyes_world);
    const auto planned = [&](int steps) {
        std::optional<Lightmap> lightmap(std::in_place);
        lightmap->luxels_per_m = luxels_per_m * std::pow(kLessDense, steps);
        const std::vector<double> of_meshes = densities(scene, is_receiver, lightmap->luxels_per_m);
        for (std::size_t i = 0; i < scene.meshes.size(); ++i)
            lightmap->layouts.push_back(of_meshes[i] > 0.0 ? lay_out(scene.meshes[i], of_meshes[i]) : LightmapLayout{});
        if (!place_objects(scene, is_receiver, open_backs, budget, *lightmap)) lightmap.reset();
        return lightmap;
    };
    std::optional<Lightmap> best = planned(0);
    if (!best) best = planned(kMostSteps);
    if (!best)
        throw Error({.what = "the lightmap takes more than " + std::to_string(budget) + " luxels at any density",
                     .file = scene.file,
                     .expected = "fewer nodes: `hatchway bake --nodes GLOB` bakes those of a glob"});
    if (best->luxels_per_m < luxels_per_m) {
        for (int too_dense = 0, enough = kMostSteps; enough - too_dense > 1;) {
            const int middle = (too_dense + enough) / 2;
            std::optional<Lightmap> denser = planned(middle);
            (denser ? enough : too_dense) = middle;
            if (denser) best = std::move(denser);
        }
        log_info(
            fmt::format("Lightmap: {:.3g} luxels per metre instead of {:.3g}, to keep the budget; "
                        "--budget-factor 2 doubles it, `hatchway bake --nodes GLOB` bakes fewer nodes, more finely",
                        best->luxels_per_m, luxels_per_m));
    }
    best->luxels.assign(static_cast<std::size_t>(best->size.x) * best->size.y, kDark);
    return std::move(*best);
}

}  // namespace hw
