#include "hatchway/maps/tonal_map.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "hatchway/core/error.hpp"
#include "hatchway/maps/stroke_drawing.hpp"

namespace hw {
namespace {

constexpr int kCandidates = 24;
constexpr double kTurn = 6.283185307179586;

/// Numbers in [0, 1) that are the same with every standard library.
class Random {
 public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    double next() { return engine_() / 4294967296.0; }

 private:
    std::mt19937 engine_;
};

/// A stroke of four points that bends a little.
MapStroke random_stroke(const TonalMapDesc& desc, bool crosses, Random& random)
{
    const double spread = desc.angle_spread_deg * (2.0 * random.next() - 1.0);
    const double angle = ((crosses ? desc.cross_angle_deg : 0.0) + spread) * kTurn / 360.0;
    const double length = desc.length_share * (0.6 + 0.8 * random.next());
    const glm::dvec2 along(std::cos(angle), -std::sin(angle));
    const glm::dvec2 aside(-along.y, along.x);
    const glm::dvec2 start(random.next(), random.next());
    const double bend = 0.012 * length * (2.0 * random.next() - 1.0);
    MapStroke stroke{.width = 0.85 + 0.3 * random.next()};
    for (int i = 0; i <= 3; ++i) {
        const double t = i / 3.0;
        stroke.points.push_back(start + length * t * along + bend * std::sin(0.5 * kTurn * t) * aside);
    }
    return stroke;
}

/// A plane that remembers how much ink lies around each place, coarsely, to find where strokes are missing.
class Layer {
 public:
    explicit Layer(int size) : plane_(size, size) {}

    void draw(const MapStroke& stroke, double pen) { draw_stroke(plane_, stroke, pen); }
    const InkPlane& plane() const { return plane_; }
    double tone() const { return mean_ink(plane_); }

    /// Ink that lies along the stroke and beside it already: low where the stroke is wanted.
    double crowding(const MapStroke& stroke) const
    {
        const glm::dvec2 along = glm::normalize(stroke.points.back() - stroke.points.front());
        const glm::dvec2 aside(-along.y, along.x);
        const double length = glm::distance(stroke.points.back(), stroke.points.front());
        double sum = 0.0;
        for (int i = 0; i <= 12; ++i) {
            const glm::dvec2 at = stroke.points.front() + along * (length * i / 12.0);
            for (int j = -3; j <= 3; ++j)
                sum += (4.0 - std::abs(j)) * sample(at * double(plane_.width) + aside * (1.3 * j));
        }
        return sum;
    }

 private:
    double sample(const glm::dvec2& at) const
    {
        const int mask = plane_.width - 1;
        return plane_.at(static_cast<int>(std::floor(at.x)) & mask, static_cast<int>(std::floor(at.y)) & mask);
    }
    InkPlane plane_;
};

MapStroke best_stroke(const TonalMapDesc& desc, const Layer& layer, bool crosses, Random& random)
{
    MapStroke best = random_stroke(desc, crosses, random);
    double least = layer.crowding(best);
    for (int i = 1; i < kCandidates; ++i) {
        MapStroke candidate = random_stroke(desc, crosses, random);
        const double crowding = layer.crowding(candidate);
        if (crowding < least) {
            least = crowding;
            best = std::move(candidate);
        }
    }
    return best;
}

/// Adds strokes to one level and tone until its tone is reached; `strokes` holds what lighter tones and coarser levels
/// show, and receives the new ones.
void fill_tone(const TonalMapDesc& desc, Layer& layer, std::vector<MapStroke>& strokes, int tone, Random& random)
{
    const double wanted = static_cast<double>(tone + 1) / desc.tones;
    const bool crosses = 2 * tone >= desc.tones;
    while (layer.tone() < wanted - 0.002) {
        MapStroke stroke = best_stroke(desc, layer, crosses, random);
        Layer next = layer;
        next.draw(stroke, desc.pen_texels);
        if (next.tone() - wanted > wanted - layer.tone()) return;
        layer = std::move(next);
        strokes.push_back(std::move(stroke));
    }
}

/// One level: the tones side by side. A tone at which everything is ink is filled, and so are levels too small for
/// strokes.
Pixels drawn_level(const TonalMapDesc& desc, int size, std::vector<std::vector<MapStroke>>& strokes, Random& random)
{
    InkPlane level(size * desc.tones, size);
    Layer layer(size);
    for (int tone = 0; tone < desc.tones; ++tone) {
        const bool is_even = size < desc.smallest_texels || tone + 1 == desc.tones;
        if (!is_even) {
            for (const MapStroke& stroke : strokes[tone]) layer.draw(stroke, desc.pen_texels);
            fill_tone(desc, layer, strokes[tone], tone, random);
        }
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                level.at(tone * size + x, y) =
                    is_even ? static_cast<float>(tone + 1) / static_cast<float>(desc.tones) : layer.plane().at(x, y);
    }
    return level_of(level);
}

/// In how many of a level's tones each texel is ink, by rank: soft edges of strokes would else crowd in the middle.
Pixels priorities_of(const Pixels& level, int tones)
{
    const int size = level.height;
    std::vector<int> paper(static_cast<std::size_t>(size) * size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            for (int tone = 0; tone < tones; ++tone) paper[y * size + x] += *level.at(tone * size + x, y);
    std::vector<int> sorted = paper;
    std::ranges::sort(sorted);
    Pixels priorities{.width = size, .height = size, .channels = 1};
    for (const int value : paper) {
        const auto [first, last] = std::equal_range(sorted.begin(), sorted.end(), value);
        const double rank = 0.5 * static_cast<double>((first - sorted.begin()) + (last - sorted.begin()));
        priorities.bytes.push_back(static_cast<std::uint8_t>(std::lround(255.0 * rank / double(sorted.size()))));
    }
    return priorities;
}

}  // namespace

MapLevels make_tonal_map(const TonalMapDesc& desc)
{
    HW_ASSERT(desc.size_texels > 0 && std::has_single_bit(static_cast<unsigned>(desc.size_texels)));
    HW_ASSERT(desc.tones >= 2 && desc.pen_texels > 0.0);
    Random random(desc.seed);
    std::vector<std::vector<MapStroke>> strokes(desc.tones);  // what each tone adds to the lighter ones
    MapLevels map{.kind = MapKind::tonal, .size_m = desc.size_m};
    for (int size = 1; size <= desc.size_texels; size *= 2)
        map.levels.push_back(drawn_level(desc, size, strokes, random));
    std::ranges::reverse(map.levels);
    return map;
}

MapLevels make_priority_map(const TonalMapDesc& desc)
{
    MapLevels map = make_tonal_map(desc);
    for (Pixels& level : map.levels) level = priorities_of(level, desc.tones);
    return map;
}

}  // namespace hw
