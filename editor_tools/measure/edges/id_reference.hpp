#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "hatchway/core/pixels.hpp"
#include "hatchway/style/view.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// The image triangle_ids as the device made it, rows from the bottom.
struct IdImage {
    glm::ivec2 size_px{0};
    std::vector<std::uint32_t> ids;
    std::vector<glm::vec4> planes;  ///< Its second output.
};

/// The operators `ids` and `ids_2011` of the edge map on the processor, by the same rule: which triangles share corners
/// is decided pair by pair.
class IdReference {
 public:
    explicit IdReference(const Scene& scene);

    /// `gap` and `small_px` are those of the edge map.
    struct Rule {
        bool is_of_2011 = false;
        float gap = 0.01f;
        float small_px = 4.0f;
    };
    /// Pixels of an edge map one pixel wide, seen from `view`, that are another edge than the rule makes of the image.
    std::size_t unlike(const Pixels& edge_map, const IdImage& image, const View& view, const Rule& rule) const;

 private:
    struct Edge {
        bool is_inner = false, is_profile = false, is_border = false;
        bool operator==(const Edge&) const = default;
    };
    struct Crack {
        bool ends = false;  ///< The first triangle ends before the other.
        bool meets = false;
        bool is_border = false;
    };
    Edge edge_at(const IdImage& image, glm::ivec2 at, const View& view, const Rule& rule) const;
    Crack crack(const IdImage& image, glm::ivec2 at, glm::ivec2 way, const View& view, const Rule& rule) const;
    int common_corners(std::uint32_t a, std::uint32_t b) const;
    float height_px(std::uint32_t id, float nearness, const View& view) const;

    std::vector<glm::uvec4> corners_;
};

}  // namespace hw
