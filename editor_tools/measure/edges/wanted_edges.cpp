#include "measure/edges/wanted_edges.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "hatchway/geometry/surface/edge_table.hpp"
#include "hatchway/render/view/line_camera.hpp"
#include "measure/lines/eye_rays.hpp"

namespace hw {
namespace {

constexpr double kStepPx = 0.5;
constexpr double kBesidePx = 0.5;

/// Whether an edge of the object has one face, or two of which one looks away.
bool is_profile(const LineObject& object, std::uint32_t edge, const glm::dvec3& eye_world)
{
    const Surface& surface = *object.surface;
    const glm::dvec3 eye(glm::inverse(object.world_from_object) * glm::dvec4(eye_world, 1.0));
    const auto looks_here = [&](std::uint32_t face) {
        const auto& [a, b, c] = surface.faces[face];
        const glm::dvec3 p(surface.positions[a]), q(surface.positions[b]), r(surface.positions[c]);
        return glm::dot(glm::cross(q - p, r - p), eye - p) > 0.0;
    };
    const auto [a, b] = surface.edges[edge].faces();
    if (b == kNoFace || a >= surface.faces.size() || b >= surface.faces.size()) return true;
    return looks_here(a) != looks_here(b);
}

class Sampler {
 public:
    Sampler(const ExactLines& lines, const LineCamera& camera)
        : lines_(lines),
          pinhole_({camera.eye_world, camera.target_world, camera.fov_rad, camera.size_px, camera.near_m}),
          eye_world_(camera.eye_world),
          rays_(hiding_triangles(lines.scene()), camera.eye_world)
    {
    }

    void add(const VisibleLine& line)
    {
        for (std::size_t i = 0; i < line.sources.size(); ++i) {
            const std::size_t next = (i + 1) % line.points_px.size();
            const glm::dvec2 a = line.points_px[i], b = line.points_px[next];
            const double length = glm::distance(a, b);
            const EdgeKind kind = kind_of(line, line.sources[i]);
            const int count = 1 + static_cast<int>(length / kStepPx);
            for (int k = 0; k < count && length > 0.0; ++k) {
                const double t = (k + 0.5) / count;
                const double inverse = glm::mix(line.inverse_depths[i], line.inverse_depths[next], t);
                const glm::dvec2 across = glm::dvec2(a.y - b.y, b.x - a.x) / length;
                WantedEdge edge{glm::mix(a, b, t), across, length / count, kind};
                if (kind == EdgeKind::profile && gap_behind(edge, 1.0 / inverse) < kGap) edge.kind = EdgeKind::flush;
                if (pinhole_.holds(edge.at_px)) edges.push_back(edge);
            }
        }
    }

    std::vector<WantedEdge> edges;

 private:
    EdgeKind kind_of(const VisibleLine& line, const LineSource& source) const
    {
        if (is_contour(line.line_class)) return EdgeKind::profile;
        if (line.line_class == LineClass::intersection) return EdgeKind::other;
        if (source.is_edge() && is_profile(lines_.objects()[line.object], source.index(), eye_world_))
            return EdgeKind::profile;
        return is_crease(line.line_class) ? EdgeKind::inner : EdgeKind::other;
    }

    /// How much farther it goes beside the line, as a share of the distance.
    double gap_behind(const WantedEdge& edge, double depth_m) const
    {
        double farthest_m = 0.0;
        for (const double side : {-kBesidePx, kBesidePx}) {
            const glm::dvec3 way = pinhole_.ray(edge.at_px + side * edge.across);
            const std::optional<Hit> hit = rays_.first(way, 1e9);
            if (!hit) return 1.0;
            farthest_m = std::max(farthest_m, hit->share * pinhole_.depth(way));
        }
        return farthest_m / depth_m - 1.0;
    }

    const ExactLines& lines_;
    Pinhole pinhole_;
    glm::dvec3 eye_world_;
    EyeRays rays_;
};

}  // namespace

std::vector<WantedEdge> wanted_edges(const ExactLines& lines, const CameraPlace& camera, glm::ivec2 size_px)
{
    Sampler sampler(lines, line_camera(camera, camera_view(camera, size_px, lines.scene().bounds_world)));
    for (const VisibleLine& line : lines.find(camera, size_px)) sampler.add(line);
    return std::move(sampler.edges);
}

}  // namespace hw
