#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <vector>

#include "hatchway/drawing/level_lines.hpp"
#include "hatchway/render/view/camera_view.hpp"
#include "hatchway/stage/level_world.hpp"

namespace hw {

/// The exact visible lines of a level or a model in which every object wears one style.
class ExactLines {
 public:
    ExactLines(const std::filesystem::path& file, const NamedStyle& style);

    const Level& level() const { return level_; }
    const LevelWorld& world() const { return *world_; }
    const Scene& scene() const { return world_->scene; }
    /// What the lines of find() are edges of.
    const std::vector<LineObject>& objects() const { return lines_.objects(); }

    /// What it took to make adjacency, edge table, seams and intersections of the imported scene.
    double prepare_s() const { return prepare_s_; }

    /// The level's cameras, `count` at most; else so many places around the scene.
    std::vector<CameraPlace> cameras(int count, double aspect) const;

    /// `seconds`, when not null, gets what it costs, extraction, occlusion and chaining: the median of five runs.
    std::vector<VisibleLine> find(const CameraPlace& camera, glm::ivec2 size_px, double* seconds = nullptr) const;

    /// The same in pieces with the widths that the style has there: what crowded lines of far objects are thinned to.
    std::vector<VectorLine> drawn(const CameraPlace& camera, glm::ivec2 size_px, double* seconds = nullptr);

 private:
    Level level_;
    std::shared_ptr<const LevelWorld> world_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();  // between its neighbours
    LevelLines lines_;
    double prepare_s_ = 0.0;
};

}  // namespace hw
