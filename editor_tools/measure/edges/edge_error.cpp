#include "measure/edges/edge_error.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "measure/pixels_near.hpp"

namespace hw {
namespace {

constexpr double kReachPx = 1.0;
constexpr double kFalseBeyondPx = 2.0;
constexpr double kCrossStepPx = 0.25;
constexpr double kAlonePx = 3.0;  // beyond the width

double edge_at(const Pixels& map, int x, int y, int channel)
{
    return 1.0 - map.at(x, y)[channel] / 255.0;
}

bool is_profile(EdgeKind kind)
{
    return kind == EdgeKind::profile || kind == EdgeKind::flush;
}

}  // namespace

double EdgeError::recall(EdgeKind kind) const
{
    const auto i = static_cast<std::size_t>(kind);
    return measure::share_of(found_px[i], wanted_px[i]);
}

void EdgeError::add(const EdgeError& other)
{
    for (std::size_t i = 0; i < wanted_px.size(); ++i) {
        wanted_px[i] += other.wanted_px[i];
        found_px[i] += other.found_px[i];
    }
    profiles += other.profiles;
    profiles_right += other.profiles_right;
    inners += other.inners;
    inners_right += other.inners_right;
    distance_sum_px += other.distance_sum_px;
    distances += other.distances;
    false_pixels += other.false_pixels;
    pixels += other.pixels;
}

EdgeJudge::EdgeJudge(const Pixels& objects, std::vector<WantedEdge> wanted)
    : size_px_(objects.width, objects.height), wanted_(std::move(wanted))
{
    for (int y = 0; y < size_px_.y; ++y)
        for (int x = 0; x < size_px_.x; ++x) {
            const std::uint8_t* rgb = objects.at(x, y);
            is_covered_.push_back(rgb[0] + rgb[1] + rgb[2] > 0);
        }
    to_any_.assign(is_covered_.size(), EdgeError::kFarthestPx);
    to_profile_ = to_any_;
    for (const WantedEdge& edge : wanted_) {
        add_to(to_any_, edge.at_px);
        if (is_profile(edge.kind)) add_to(to_profile_, edge.at_px);
    }
}

void EdgeJudge::add_to(Field& field, const glm::dvec2& at_px) const
{
    for_each_pixel_near(at_px, EdgeError::kFarthestPx, size_px_, [&](int x, int y, double distance) {
        float& nearest = field[index(x, y)];
        nearest = std::min(nearest, static_cast<float>(distance));
    });
}

void EdgeJudge::judge_mark(EdgeError& error, std::size_t pixel, bool is_profile_mark, EdgeVerdict& verdict) const
{
    const float any_px = to_any_[pixel], profile_px = to_profile_[pixel];
    const bool is_right = (is_profile_mark ? profile_px : any_px) <= kReachPx;
    (is_profile_mark ? error.profiles : error.inners) += 1.0;
    (is_profile_mark ? error.profiles_right : error.inners_right) += is_right ? 1.0 : 0.0;
    if (any_px > kFalseBeyondPx) ++error.false_pixels;
    if (is_profile_mark) {
        error.distance_sum_px += profile_px;
        ++error.distances;
    }
    const EdgeVerdict right = is_profile_mark ? EdgeVerdict::right_profile : EdgeVerdict::right_inner;
    verdict = is_right ? right : EdgeVerdict::wrong;
}

bool EdgeJudge::judge_line(EdgeError& error, const WantedEdge& edge, const Pixels& map, double threshold) const
{
    double nearest_px = EdgeError::kFarthestPx;
    bool is_found = false;
    const double reach_px = edge.kind == EdgeKind::profile ? EdgeError::kFarthestPx : kReachPx;
    for_each_pixel_near(edge.at_px, reach_px, size_px_, [&](int x, int y, double distance) {
        if (!is_covered_[index(x, y)]) return;
        const bool is_profile_mark = edge_at(map, x, y, 1) >= threshold;
        if (is_profile_mark) nearest_px = std::min(nearest_px, distance);
        const bool is_mark = is_profile_mark || (edge.kind != EdgeKind::profile && edge_at(map, x, y, 0) >= threshold);
        is_found |= is_mark && distance <= kReachPx;
    });
    const auto kind = static_cast<std::size_t>(edge.kind);
    error.wanted_px[kind] += edge.length_px;
    if (is_found) error.found_px[kind] += edge.length_px;
    if (edge.kind != EdgeKind::profile) return is_found;
    error.distance_sum_px += nearest_px;
    ++error.distances;
    return is_found;
}

EdgeError EdgeJudge::judge(const Pixels& map, double threshold, std::vector<EdgeVerdict>* to_show) const
{
    EdgeError error;
    error.pixels = static_cast<double>(to_any_.size());
    std::vector<EdgeVerdict> verdicts(to_any_.size(), EdgeVerdict::paper);
    for (int y = 0; y < size_px_.y; ++y)
        for (int x = 0; x < size_px_.x; ++x) {
            if (!is_covered_[index(x, y)]) continue;
            const bool is_profile_mark = edge_at(map, x, y, 1) >= threshold;
            if (is_profile_mark || edge_at(map, x, y, 0) >= threshold)
                judge_mark(error, index(x, y), is_profile_mark, verdicts[index(x, y)]);
        }
    for (const WantedEdge& edge : wanted_)
        if (!judge_line(error, edge, map, threshold) && edge.kind != EdgeKind::other)
            verdicts[index(static_cast<int>(edge.at_px.x), static_cast<int>(edge.at_px.y))] = EdgeVerdict::missed;
    if (to_show != nullptr) *to_show = std::move(verdicts);
    return error;
}

bool EdgeJudge::stands_alone(const WantedEdge& edge, double reach_px) const
{
    for (const double side : {-1.0, 1.0})
        for (double d = 1.0; d <= reach_px; d += 0.5) {
            const glm::dvec2 at = edge.at_px + side * d * edge.across;
            const glm::ivec2 pixel(glm::floor(at));
            if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size_px_.x || pixel.y >= size_px_.y) return false;
            const double own = glm::dot(glm::dvec2(pixel) + 0.5 - edge.at_px, edge.across);
            if (to_any_[index(pixel.x, pixel.y)] < std::min(std::abs(own), EdgeError::kFarthestPx) - 0.3) return false;
        }
    return true;
}

std::vector<float> EdgeJudge::width_ratios(const Pixels& map, double width_px) const
{
    std::vector<float> ratios;
    const double reach_px = width_px + kAlonePx;
    for (const WantedEdge& edge : wanted_) {
        if (edge.kind != EdgeKind::profile || !stands_alone(edge, reach_px)) continue;
        double ink_px = 0.0;
        for (double d = -reach_px + 1.0; d <= reach_px - 1.0; d += kCrossStepPx) {
            const glm::ivec2 pixel(glm::floor(edge.at_px + d * edge.across));
            ink_px += kCrossStepPx * edge_at(map, pixel.x, pixel.y, 1);
        }
        ratios.push_back(static_cast<float>(ink_px / width_px));
    }
    return ratios;
}

}  // namespace hw
