// Each length is spread over the 27 nodes around it and collected from the 27 nodes around a place, both by quadratic
// B-splines: smooth, and a straight line through the place always counts about the same, wherever it lies between
// nodes.
#include "hatchway/geometry/lines/line_crowding.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

#include "hatchway/core/box.hpp"

namespace hw {
namespace {

constexpr double kWindowsAcross = 256.0;   // smallest windows along an object's largest extent, at most
constexpr double kMostSamples = 131072.0;  // about: fine meshes get wider windows
constexpr float kCreaseShare = 0.75f;      // of a crease: from how many places one of its two faces is seen
constexpr float kTurn = 0.25f;             // share of a smooth edge for each radian of its fold, see crowding_lines()
constexpr float kScaleStep = 4.0f;
constexpr double kFewLines = 1.25;  // samples for each of lines laid end to end: shorter lines share cells
constexpr float kFreeLines = 2.0f;  // side by side in a window before any is thinned: near views stay whole

/// Weights of three nodes in a row, the middle one closest.
std::array<float, 3> spline(float off_middle)
{
    const float left = 0.5f - off_middle, right = 0.5f + off_middle;
    return {0.5f * left * left, 0.75f - off_middle * off_middle, 0.5f * right * right};
}

struct Sample {
    glm::vec3 place;
    float length;
};

/// Cells of an object are within +-2^10 of its middle at every scale; 0 is no cell.
std::uint64_t key_of(const glm::ivec3& cell)
{
    const auto part = [](int x) { return static_cast<std::uint64_t>(x + (1 << 20)) & 0x1fffff; };
    return part(cell.x) << 42 | part(cell.y) << 21 | part(cell.z);
}

/// The 27 nodes around a place.
struct Nodes {
    glm::ivec3 low;
    std::array<std::array<float, 3>, 3> weights;  ///< By axis.

    Nodes(const glm::vec3& place, float cell)
    {
        const glm::vec3 at = place / cell;
        const glm::vec3 rounded = glm::floor(at + 0.5f);
        low = glm::ivec3(rounded) - 1;
        for (int axis = 0; axis < 3; ++axis) weights[axis] = spline(at[axis] - rounded[axis]);
    }

    /// `visit` gets the key of each brick that they lie in, which of 2 x 2 x 2 neighbours it is for all, and for these.
    template <typename Visit>
    void for_each_brick(Visit&& visit) const
    {
        const glm::ivec3 first = low >> 2, last = (low + 2) >> 2;
        for (int x = first.x; x <= last.x; ++x)
            for (int y = first.y; y <= last.y; ++y)
                for (int z = first.z; z <= last.z; ++z)
                    visit(key_of({x, y, z}), (x & 1) * 4 + (y & 1) * 2 + (z & 1),
                          (x - first.x) * 4 + (y - first.y) * 2 + z - first.z);
    }

    /// The bricks stand in the order that for_each_brick() tells last; `use` gets node and weight.
    template <typename Brick, typename Use>
    void for_each(const std::array<Brick*, 8>& bricks, Use&& use) const
    {
        const glm::ivec3 first = low >> 2;
        for (int x = 0; x < 3; ++x)
            for (int y = 0; y < 3; ++y)
                for (int z = 0; z < 3; ++z) {
                    const glm::ivec3 node = low + glm::ivec3(x, y, z), brick = (node >> 2) - first, in = node & 3;
                    use((*bricks[brick.x * 4 + brick.y * 2 + brick.z])[in.x * 16 + in.y * 4 + in.z],
                        weights[0][x] * weights[1][y] * weights[2][z]);
                }
    }
};

/// Cuts lines into samples no longer than `step`.
std::vector<Sample> sampled(std::span<const CrowdingLine> lines, const glm::vec3& origin, float step)
{
    std::vector<Sample> samples;
    for (const CrowdingLine& line : lines) {
        const float length = glm::distance(line.ends[0], line.ends[1]);
        const int count = 1 + static_cast<int>(length / step);
        for (int i = 0; i < count; ++i) {
            const float t = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
            samples.push_back(
                {glm::mix(line.ends[0], line.ends[1], t) - origin, line.share * length / static_cast<float>(count)});
        }
    }
    return samples;
}

/// Spreads keys over a table of 2^n slots.
std::size_t slot_for(std::uint64_t key, std::size_t slot_count)
{
    return (key * 0x9e3779b97f4a7c15ull) >> 20 & (slot_count - 1);
}

/// Joins the samples in each cell of a grid to one in their middle, in the order in which cells come up.
std::vector<Sample> joined(std::span<const Sample> samples, float cell)
{
    constexpr std::uint32_t kEmpty = ~0u;
    struct Cell {
        std::uint64_t key;
        glm::dvec3 moment{0.0};
        double length = 0.0;
    };
    std::vector<std::uint32_t> slots(std::bit_ceil(2 * samples.size() + 1), kEmpty);
    std::vector<Cell> cells;
    cells.reserve(samples.size());
    for (const Sample& s : samples) {
        const std::uint64_t key = key_of(glm::ivec3(glm::floor(s.place / cell)));
        std::size_t at = slot_for(key, slots.size());
        while (slots[at] != kEmpty && cells[slots[at]].key != key) at = (at + 1) & (slots.size() - 1);
        if (slots[at] == kEmpty) {
            slots[at] = static_cast<std::uint32_t>(cells.size());
            cells.push_back({key});
        }
        Cell& in = cells[slots[at]];
        in.moment += static_cast<double>(s.length) * glm::dvec3(s.place);
        in.length += s.length;
    }
    std::vector<Sample> result;
    result.reserve(cells.size());
    for (const Cell& in : cells)
        if (in.length > 0.0) result.push_back({glm::vec3(in.moment / in.length), static_cast<float>(in.length)});
    return result;
}

}  // namespace

std::vector<CrowdingLine> crowding_lines(const Surface& surface, float crease_rad, const Seams* seams,
                                         std::span<const std::array<glm::vec3, 2>> pieces)
{
    const EdgeClasses classes = classes_at(surface, crease_rad);
    std::vector<CrowdingLine> lines;
    const auto is_among = [](const std::vector<std::uint32_t>& rising, std::uint32_t edge) {
        return std::binary_search(rising.begin(), rising.end(), edge);
    };
    const auto add = [&](std::uint32_t edge, float share) {
        const auto [a, b] = edge_vertices(surface, edge);
        lines.push_back({{surface.positions[a], surface.positions[b]}, share});
    };
    const auto add_drawn = [&](EdgeRange range, float share) {
        for (std::uint32_t edge = range.begin; edge < range.end; ++edge) {
            if (seams && (is_among(seams->hidden, edge) || is_among(seams->partly_hidden, edge))) continue;
            add(edge, share);
        }
    };
    add_drawn(classes.borders, 1.0f);
    for (const EdgeRange range : classes.artist) add_drawn(range, kCreaseShare);
    for (const EdgeRange range : classes.ridges) add_drawn(range, kCreaseShare);
    for (const EdgeRange range : classes.valleys) add_drawn(range, kCreaseShare);
    // In a share fold / pi of all views a smooth edge is a silhouette, and such edges zigzag: the picture's line is as
    // pi / 4 times their length.
    for (const EdgeRange range : classes.candidates)
        for (std::uint32_t edge = range.begin; edge < range.end; ++edge) add(edge, kTurn * fold_rad(surface, edge));
    if (seams)
        for (const KeptPiece& piece : seams->kept) lines.push_back({piece.ends, 1.0f});
    for (const auto& piece : pieces) lines.push_back({piece, 1.0f});
    return lines;
}

std::size_t LineCrowding::bytes() const
{
    std::size_t sum = 0;
    for (const Lengths& scale : scales_) sum += scale.bytes();
    return sum;
}

LineCrowding::Lengths::Lengths(float cell) : cell_(cell), slots_(64) {}

std::size_t LineCrowding::Lengths::slot_of(std::uint64_t key) const
{
    std::size_t at = slot_for(key, slots_.size());
    while (slots_[at].key != key && slots_[at].key != 0) at = (at + 1) & (slots_.size() - 1);
    return at;
}

std::uint32_t LineCrowding::Lengths::found(std::uint64_t key) const
{
    const Slot& slot = slots_[slot_of(key)];
    return slot.key == 0 ? kNoBrick : slot.brick;
}

std::uint32_t LineCrowding::Lengths::made(std::uint64_t key)
{
    if (const std::uint32_t brick = found(key); brick != kNoBrick) return brick;
    if (2 * (bricks_.size() + 1) > slots_.size()) grow();
    slots_[slot_of(key)] = {key, static_cast<std::uint32_t>(bricks_.size())};
    bricks_.emplace_back();
    return static_cast<std::uint32_t>(bricks_.size() - 1);
}

void LineCrowding::Lengths::grow()
{
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old)
        if (slot.key != 0) slots_[slot_of(slot.key)] = slot;
}

void LineCrowding::Lengths::make_room(const glm::vec3& place)
{
    Nodes(place, cell_).for_each_brick([&](std::uint64_t key, int corner, int) {
        near_.brick(key, corner, [&] { return made(key); });
    });
}

void LineCrowding::Lengths::add(const glm::vec3& place, float length)
{
    const Nodes nodes(place, cell_);
    Brick nowhere{};
    std::array<Brick*, 8> bricks;
    bool is_anywhere = false;
    nodes.for_each_brick([&](std::uint64_t key, int corner, int at) {
        const std::uint32_t brick = near_.brick(key, corner, [&] { return found(key); });
        bricks[at] = brick == kNoBrick ? &nowhere : &bricks_[brick];
        is_anywhere |= brick != kNoBrick;
    });
    if (is_anywhere) nodes.for_each(bricks, [&](float& node, float weight) { node += weight * length; });
}

float LineCrowding::Lengths::lines_at(const glm::vec3& place, NearBricks& near) const
{
    static constexpr Brick kNothing{};
    const Nodes nodes(place, cell_);
    std::array<const Brick*, 8> bricks;
    nodes.for_each_brick([&](std::uint64_t key, int corner, int at) {
        const std::uint32_t brick = near.brick(key, corner, [&] { return found(key); });
        bricks[at] = brick == kNoBrick ? &kNothing : &bricks_[brick];
    });
    float sum = 0.0f, own = 1.0f;
    nodes.for_each(bricks, [&](float node, float weight) { sum += weight * node; });
    // What a line through the place adds: its length in a window, as much of it as is collected across it.
    for (const auto& w : nodes.weights) own *= w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
    return sum / (cell_ * std::cbrt(own * own));
}

LineCrowding::LineCrowding(std::span<const CrowdingLine> lines, std::optional<std::span<const glm::vec3>> places)
{
    Box box;
    double length = 0.0;
    for (const CrowdingLine& line : lines) {
        for (const glm::vec3& end : line.ends) box.add(glm::dvec3(end));
        length += glm::distance(line.ends[0], line.ends[1]);
    }
    if (!(length > 0.0)) return;
    const glm::dvec3 size = box.size();
    const double extent = std::max({size.x, size.y, size.z});
    window_ = static_cast<float>(std::max(extent / kWindowsAcross, 2.0 * length / kMostSamples));
    origin_ = glm::vec3(box.centre());
    std::vector<Sample> samples;
    float cell = window_;
    for (int scale = 0; scale < kScales; ++scale, cell *= kScaleStep) {
        const double along = length / cell;
        if (samples.empty() || along + static_cast<double>(lines.size()) < static_cast<double>(samples.size()))
            samples = sampled(lines, origin_, cell);
        if (static_cast<double>(samples.size()) > kFewLines * along) samples = joined(samples, 0.5f * cell);
        Lengths& lengths = scales_.emplace_back(cell);
        if (places) {
            for (const glm::vec3& place : *places) lengths.make_room(place - origin_);
        } else {
            for (const Sample& s : samples) lengths.make_room(s.place);
        }
        for (const Sample& s : samples) lengths.add(s.place, s.length);
    }
}

glm::vec4 LineCrowding::at(const glm::vec3& place, Near& near) const
{
    glm::vec4 result(0.0f);
    float most = kFreeLines;
    for (std::size_t scale = 0; scale < scales_.size(); ++scale) {
        most = std::max(most, scales_[scale].lines_at(place - origin_, near[scale]));
        result[static_cast<int>(scale)] = std::log2(most / kFreeLines);
    }
    return result;
}

glm::vec4 LineCrowding::at(const glm::vec3& place) const
{
    Near near;
    return at(place, near);
}

std::vector<glm::vec4> LineCrowding::at(std::span<const glm::vec3> places) const
{
    std::vector<glm::vec4> result(places.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, places.size(), 256), [&](const auto& range) {
        Near near;
        for (std::size_t i = range.begin(); i < range.end(); ++i) result[i] = at(places[i], near);
    });
    return result;
}

std::array<glm::vec4, 2> crowding_of_line(const glm::vec4& at_a, const glm::vec4& at_b, const glm::vec4& in_middle)
{
    const auto at_end = [&](const glm::vec4& end) { return glm::min(0.5f * (end + in_middle), in_middle); };
    return {at_end(at_a), at_end(at_b)};
}

// Between two scales, lines begin to count as late as the larger one allows: their number grows like the window, twice
// in an octave, or faster where it must.
float crowded_share(const glm::vec4& crowding, float windows)
{
    const float scale = 0.5f * std::log2(std::max(windows, 1e-20f));
    const int upper = std::clamp(static_cast<int>(std::ceil(scale)), 0, 3);
    const float least = upper > 0 ? crowding[upper - 1] : 0.0f;
    const float slope = upper > 0 ? std::max(crowding[upper] - least, 2.0f) : 2.0f;
    return std::exp2(-std::max(least, crowding[upper] + slope * (scale - static_cast<float>(upper))));
}

}  // namespace hw
