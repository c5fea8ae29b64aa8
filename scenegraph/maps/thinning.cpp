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
    std::vector<Pixel> left;
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x)
            if (mask.at(x, y)) left.push_back({x, y});
    std::vector<Pixel> going;
    const auto peel = [&](bool is_first_half) {
        going.clear();
        for (const Pixel& p : left)
            if (may_go(result, p, is_first_half)) going.push_back(p);
        for (const Pixel& p : going) result.ink[result.place(p.x, p.y)] = 0;
        std::erase_if(left, [&](const Pixel& p) { return !result.at(p.x, p.y); });
        return !going.empty();
    };
    while (true) {
        const bool has_changed = peel(true);
        if (!peel(false) && !has_changed) break;
    }
    for (const Pixel& p : left)
        if (is_stair_corner(result, p)) result.ink[result.place(p.x, p.y)] = 0;
    keep_spots(mask, result);
    return result;
}

}  // namespace hw
