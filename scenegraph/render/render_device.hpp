#pragma once

#include <set>
#include <string>

#include "hatchway/gl/context.hpp"
#include "hatchway/gl/gpu_queries.hpp"
#include "hatchway/render/device/surface_drawer.hpp"
#include "hatchway/render/device/target_pool.hpp"
#include "hatchway/render/lines/line_drawer.hpp"
#include "hatchway/render/overlay/overlay_drawer.hpp"

namespace hw {

/// What a renderer keeps on the device whatever scene and view it draws.
struct RenderDevice {
    /// `read_image` decodes textures of styles.
    RenderDevice(Context& own_context, ImageReader read_image);

    /// Logs a text as an error, once; in a rehearsal only notes it.
    void tell_once(const std::string& text);
    /// The same as a warning.
    void warn_once(const std::string& text);

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
    std::set<std::string> told;  ///< By tell_once() and warn_once().
    bool is_rehearsal = false;   ///< FrameOptions::is_rehearsal of the frame that is drawn.
};

/// Fills the bound target by a program for full-screen passes, or lays it over what is there.
void draw_full_screen(RenderDevice& device, const GpuProgram& program, const Uniforms& uniforms,
                      Blending blending = Blending::off);

}  // namespace hw
