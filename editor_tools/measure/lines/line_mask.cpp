#include "measure/lines/line_mask.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "measure/pixels_near.hpp"

namespace hw {
namespace {

constexpr int kWays = 12;
constexpr std::uint16_t kEveryWay = (1u << kWays) - 1u;
constexpr double kNoWay_px = 1e-9;

int index_of(const glm::dvec2& way)
{
    const double turn = std::atan2(way.y, way.x) / std::numbers::pi;  // of half a turn, -1 to 1
    return static_cast<int>(std::floor((turn + 1.0) * kWays)) % kWays;
}

}  // namespace

LineMask::LineMask(glm::ivec2 size_px) : size_(size_px), bits_(static_cast<std::size_t>(size_px.x) * size_px.y) {}

template <typename Use>
void LineMask::stamp(const glm::dvec2& at, const glm::dvec2& way, const Use& use) const
{
    std::uint16_t bits = kEveryWay;
    if (glm::length(way) > kNoWay_px) {
        const int index = index_of(way);
        bits = static_cast<std::uint16_t>(1u << index | 1u << (index + 1) % kWays | 1u << (index + kWays - 1) % kWays);
    }
    for_each_pixel_near(at, kReach_px, size_, [&](int x, int y, double) {
        use(Stamp{static_cast<std::size_t>(y) * size_.x + x, bits});
    });
}

void LineMask::add(const glm::dvec2& at, const glm::dvec2& way)
{
    stamp(at, way, [&](const Stamp& one) { add(one); });
}

bool LineMask::holds(const glm::dvec2& at, const glm::dvec2& way) const
{
    const glm::ivec2 pixel(glm::floor(at));
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size_.x || pixel.y >= size_.y) return false;
    const std::uint16_t bits = bits_[static_cast<std::size_t>(pixel.y) * size_.x + pixel.x];
    return glm::length(way) > kNoWay_px ? (bits >> index_of(way) & 1) != 0 : bits != 0;
}

void FoundLines::add(const glm::dvec2& at, const glm::dvec2& way)
{
    all_.stamp(at, way, [&](const LineMask::Stamp& one) { line_.push_back(one); });
}

void FoundLines::end_line()
{
    for (const auto& [pixel, bits] : line_) shared_.add({pixel, static_cast<std::uint16_t>(all_.bits(pixel) & bits)});
    for (const LineMask::Stamp& one : line_) all_.add(one);
    line_.clear();
}

}  // namespace hw
