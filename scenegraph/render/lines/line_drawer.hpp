#pragma once

#include <map>
#include <span>
#include <utility>

#include "hatchway/gl/context.hpp"
#include "hatchway/gl/gpu_state.hpp"
#include "hatchway/render/device/program_store.hpp"
#include "hatchway/render/lines/edge_store.hpp"
#include "hatchway/render/view/frame_options.hpp"
#include "hatchway/render/view/visible_set.hpp"
#include "hatchway/style/pass.hpp"
#include "hatchway/style/view.hpp"

namespace hw {

/// How lines reach the picture in one frame.
struct LineFrame {
    const View& view;
    LinePath path = LinePath::quads;
    std::uint32_t depth_texture = 0;  ///< Of the faces, behind them by the polygon offset.
};

/// An item whose lines are drawn and where its object stands.
struct LineItem {
    const DrawItem* item = nullptr;
    const VisibleObject* object = nullptr;
};

/// A pen of a style's own; without a program, the engine's.
struct LinePen {
    Program program;
    const Uniforms* uniforms = nullptr;
};

/// One call of a style for lines.
struct LineRun {
    const LineLook& look;
    float crease_rad = 0.7f;  ///< Of the style's needs.
    std::span<const LineItem> items;
    LinePen pen;
};

struct LineCounters {
    int silhouette_extractions = 0;
    std::uint64_t silhouette_edges = 0;
    std::uint64_t lines = 0;         ///< Drawn, by whichever path.
    bool changes_with_time = false;  ///< A share of lines over time is not at its end.
};

/// Draws objects' lines: those of their line meshes, and the silhouettes from this eye. Hidden parts fall to the depth
/// test against faces that lie behind by the polygon offset.
class LineDrawer {
 public:
    LineDrawer(const DeviceInfo& device, ProgramStore& programs, GpuState& state, LineIndices& indices);

    void draw(const LineFrame& frame, const LineRun& run, const EdgeStore& edges);
    LineCounters take_counters() { return std::exchange(counters_, {}); }

 private:
    struct Stretch;
    struct LineProgram;

    LinePath path_for(const LineFrame& frame, const LineRun& run) const;
    std::vector<std::uint32_t> stream_silhouettes(const LineFrame& frame, const LineRun& run, const EdgeStore& edges);
    /// Programs of one path for one call: bodies of lines, and for GL_LINES their ends.
    std::vector<LineProgram> programs_for(LinePath path, const LineRun& run, bool has_presence) const;
    static std::vector<Stretch> stretches_of(const LineMesh& lines, const LineFrame& frame, const LineLook& look,
                                             LinePath path);
    void set_look(const LineProgram& program, const LineFrame& frame, const LineRun& run);
    void draw_item(const LineProgram& program, const LineFrame& frame, const LineLook& look, const LineItem& item,
                   const LineMesh& lines, const LineBuffer& buffer, std::span<const Stretch> stretches);

    const DeviceInfo& device_;
    ProgramStore& programs_;
    GpuState& state_;
    LineIndices& indices_;
    LineBuffer stream_;
    SilhouetteScratch scratch_;
    std::vector<LineVertex> vertices_;
    LineCounters counters_;
};

}  // namespace hw
