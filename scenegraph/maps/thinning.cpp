#include "hatchway/maps/thinning.hpp"

#include <algorithm>
#include <array>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

/// The eight neighbours, from the upper one clockwise.
constexpr std::array<std::array<int, 2>, 8> kAround{
    {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};

struct Pixel {
    int x;
    int y;
};

std::array<int, 8> neighbours(const InkMask& mask, const Pixel& p)
{
    std::array<int, 8> result;
    for (std::size_t i = 0; i < 8; ++i) result[i] = mask.at(p.x + kAround[i][0], p.y + kAround[i][1]) ? 1 : 0;
    return result;
}

bool may_go(const InkMask& mask, const Pixel& p, bool is_first_half)
{
    const std::array<int, 8> n = neighbours(mask, p);
    int count = 0;
    int starts = 0;  // of ink, going round
    for (std::size_t i = 0; i < 8; ++i) {
        count += n[i];
        starts += n[i] == 0 && n[(i + 1) % 8] == 1 ? 1 : 0;
    }
    if (count < 2 || count > 6 || starts != 1) return false;
    const auto [up, right, down, left] = std::array{n[0], n[2], n[4], n[6]};
    return is_first_half ? up * right * down == 0 && right * down * left == 0
                         : up * right * left == 0 && up * down * left == 0;
}

/// The corner of a step, without which its neighbours still touch.
bool is_stair_corner(const InkMask& mask, const Pixel& p)
{
    const std::array<int, 8> n = neighbours(mask, p);
    for (std::size_t i = 0; i < 8; i += 2)
        if (n[i] == 1 && n[(i + 2) % 8] == 1 && n[(i + 5) % 8] == 0 && n[(i + 4) % 8] == 0 && n[(i + 6) % 8] == 0)
            return true;
    return false;
}

double brightness(const std::uint8_t* p, int channels)
{
    const double alpha = channels == 4 ? p[3] / 255.0 : channels == 2 ? p[1] / 255.0 : 1.0;
    const double value = channels < 3 ? p[0] : 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
    return 1.0 - alpha + alpha * value / 255.0;
}

/// Whether paper is so near that the pixel may go at first.
bool is_at_edge(const InkMask& mask, const Pixel& p)
{
    const std::array<int, 8> n = neighbours(mask, p);
    return std::count(n.begin(), n.end(), 0) >= 2;
}

/// Peels ink off half a layer at a time. Only where pixels went in the last two peelings can new ones go.
class Peeling {
 public:
    explicit Peeling(InkMask& mask) : mask_(mask), seen_(mask.ink.size(), 0)
    {
        for (int y = 0; y < mask.height; ++y)
            for (int x = 0; x < mask.width; ++x)
                if (mask.at(x, y) && is_at_edge(mask, {x, y})) near_[0].push_back({x, y});
        near_[1] = near_[0];
    }

    /// Whether a pixel went.
    bool peel(bool is_first_half)
    {
        std::vector<Pixel> going;
        ++round_;
        for (const std::vector<Pixel>& pixels : near_)
            for (const Pixel& p : pixels)
                if (is_new(p) && may_go(mask_, p, is_first_half)) going.push_back(p);
        for (const Pixel& p : going) mask_.ink[mask_.place(p.x, p.y)] = 0;
        near_[0] = std::move(near_[1]);
        near_[1] = around(going);
        return !going.empty();
    }

 private:
    /// Whether it is ink, and met for the first time in this round.
    bool is_new(const Pixel& p)
    {
        int& seen = seen_[mask_.place(p.x, p.y)];
        const bool result = mask_.at(p.x, p.y) && seen != round_;
        seen = round_;
        return result;
    }
    std::vector<Pixel> around(const std::vector<Pixel>& going)
    {
        std::vector<Pixel> pixels;
        ++round_;
        for (const Pixel& p : going)
            for (const auto& [dx, dy] : kAround) {
                const Pixel beside{(p.x + dx + mask_.width) % mask_.width, (p.y + dy + mask_.height) % mask_.height};
                if (is_new(beside)) pixels.push_back(beside);
            }
        return pixels;
    }

    InkMask& mask_;
    std::vector<int> seen_;  ///< The round in which each pixel was last met.
    int round_ = 0;
    std::array<std::vector<Pixel>, 2>
        near_;  ///< What pixels went from the neighbourhood of: two peelings ago, and in the last.
};

/// Takes a spot out of `left` and gives its place that lies deepest in the ink, or none where it holds a line.
void keep_spot(const InkMask& lines, const std::vector<float>& depth, const Pixel& start, InkMask& left, InkMask& kept)
{
    std::vector<Pixel> spot{start};
    left.ink[left.place(start.x, start.y)] = 0;
    Pixel deepest = start;
    bool has_line = false;
    while (!spot.empty()) {
        const Pixel p = spot.back();
        spot.pop_back();
        has_line = has_line || lines.at(p.x, p.y);
        if (depth[left.place(p.x, p.y)] > depth[left.place(deepest.x, deepest.y)]) deepest = p;
        for (const auto& [dx, dy] : kAround) {
            if (!left.at(p.x + dx, p.y + dy)) continue;
            left.ink[left.place(p.x + dx, p.y + dy)] = 0;
            spot.push_back({p.x + dx, p.y + dy});
        }
    }
    if (!has_line) kept.ink[kept.place(deepest.x, deepest.y)] = 1;
}

/// Thinning eats spots of 2 x 2 pixels: each gets a pixel back.
void keep_spots(const InkMask& mask, InkMask& lines)
{
    InkMask left = mask;
    const std::vector<float> depth = distance_to_paper(mask);
    const InkMask found = lines;
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x)
            if (left.at(x, y)) keep_spot(found, depth, {x, y}, left, lines);
}

}  // namespace

InkMask ink_of(const Pixels& drawing, double ink_below)
{
    HW_ASSERT(!drawing.is_empty());
    InkMask mask{.width = drawing.width, .height = drawing.height, .ink = {}};
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x)
            mask.ink.push_back(brightness(drawing.at(x, y), drawing.channels) < ink_below ? 1 : 0);
    return mask;
}

std::vector<float> distance_to_paper(const InkMask& mask)
{
    constexpr float kDiagonal = 1.4142136f;
    const auto farthest = static_cast<float>(mask.width + mask.height);
    std::vector<float> distance;
    for (const std::uint8_t ink : mask.ink) distance.push_back(ink != 0 ? farthest : 0.0f);
    const auto relax = [&](int x, int y, int dx, int dy, float step) {
        float& here = distance[mask.place(x, y)];
        here = std::min(here, distance[mask.place(x + dx, y + dy)] + step);
    };
    for (int round = 0; round < 2; ++round) {  // the second carries distances across the sides that touch
        for (int y = 0; y < mask.height; ++y)
            for (int x = 0; x < mask.width; ++x) {
                relax(x, y, -1, 0, 1.0f);
                relax(x, y, 0, -1, 1.0f);
                relax(x, y, -1, -1, kDiagonal);
                relax(x, y, 1, -1, kDiagonal);
            }
        for (int y = mask.height - 1; y >= 0; --y)
            for (int x = mask.width - 1; x >= 0; --x) {
                relax(x, y, 1, 0, 1.0f);
                relax(x, y, 0, 1, 1.0f);
                relax(x, y, 1, 1, kDiagonal);
                relax(x, y, -1, 1, kDiagonal);
            }
    }
    return distance;
}

InkMask thinned(const InkMask& mask)
{
    InkMask result = mask;
    Peeling peeling(result);
    while (true) {
        const bool has_changed = peeling.peel(true);
        if (!peeling.peel(false) && !has_changed) break;
    }
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x)
            if (result.at(x, y) && is_stair_corner(result, {x, y})) result.ink[result.place(x, y)] = 0;
    keep_spots(mask, result);
    return result;
}

}  // namespace hw
