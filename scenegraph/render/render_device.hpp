#pragma once

#include "hatchway/gl/context.hpp"
#include "hatchway/gl/gpu_queries.hpp"
#include "hatchway/render/device/target_pool.hpp"
#include "hatchway/render/lines/line_drawer.hpp"
#include "hatchway/render/overlay/overlay_drawer.hpp"

namespace hw {

/// What a renderer keeps on the device whatever scene and view it draws.
struct RenderDevice {
    explicit RenderDevice(Context& own_context);

    Context& context;
    GpuState state;
    ProgramStore programs;
    TargetPool pool;           ///< Transient targets; they live as long as the frame.
    GpuQueries queries;        ///< Numbered by what asks; free between phases.
    LineIndices line_indices;  ///< Shared by all line meshes.
    LineDrawer lines;
    OverlayDrawer overlay;
    GpuVertexArray no_vertices;  ///< For full-screen passes.
    GpuBuffer frame_block;       ///< HwFrame of the view that is being drawn.
};

}  // namespace hw
