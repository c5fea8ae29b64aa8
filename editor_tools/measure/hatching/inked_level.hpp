#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "hatchway/plugin_host/plugin_registry.hpp"
#include "hatchway/render/renderer.hpp"
#include "hatchway/stage/level_world.hpp"
#include "hatchway/stage/map_store.hpp"
#include "hatchway/world/looks.hpp"
#include "measure/hatching/coherence_error.hpp"
#include "measure/hatching/hatch_probe.hpp"

namespace hw {

/// One kind of hatching on everything.
struct InkKind {
    std::string name;
    std::unique_ptr<Style> style;
    bool has_ink_maps = false;  ///< Where the level assigns them.
    int hatch_map = -1;         ///< Of the probe; -1: the style's own.
    bool is_cost = false;       ///< Drawn with lines, for its time alone.
};

/// A level without visibility, all of it drawn in one kind of hatching at a time.
class InkedLevel {
 public:
    /// Throws hw::Error. The context must be current in every call and outlive this.
    InkedLevel(Context& context, const std::filesystem::path& file);

    const Level& level() const { return level_; }
    const Scene& scene() const { return world_->scene; }
    const std::vector<MeshChunks>& chunks() const { return world_->chunks; }
    const std::vector<InkKind>& kinds() const { return kinds_; }

    void show(const InkKind& kind);
    FrameStats draw(const Camera& camera, glm::ivec2 size_px, int samples);
    /// At one sample.
    InkPicture picture(const Camera& camera, glm::ivec2 size_px);

    /// The kind that the others are compared with: a hatch map without levels.
    static constexpr const char* kUnfiltered = "unfiltered map";

 private:
    InkKind& add_ink(const std::string& name, const std::string& tone, const std::string& tonal, bool has_lines);
    void add_probe(const std::string& name, LevelChoice choice, int map);

    Renderer renderer_;
    PluginRegistry plugins_;
    Level level_;
    std::shared_ptr<const LevelWorld> world_;
    std::vector<ObjectLook> looks_;
    MapStore maps_;
    MapLevels ordinary_;
    std::vector<InkKind> kinds_;
};

}  // namespace hw
