#pragma once

#include <map>
#include <optional>
#include <vector>

#include "hatchway/gl/gpu_queries.hpp"
#include "hatchway/render/device/surface_drawer.hpp"
#include "hatchway/render/lines/edge_store.hpp"
#include "hatchway/render/lines/line_drawer.hpp"
#include "hatchway/render/products/shared_images.hpp"

namespace hw {

/// Which light of the frame and which streams of meshes a style reads.
struct StyleLight {
    bool uses_shadow = false;
    bool uses_lightmap = false;
    Streams streams = {};
};

/// One call of a style for faces, kept until all styles have said what they draw.
struct FaceCall {
    Program program;
    Uniforms uniforms;
    std::vector<DrawItem> items;
    StyleLight light;
    const std::map<MapKind, int>* style_maps = nullptr;
};

/// What one frame's passes share.
struct FrameParts {
    const View* view = nullptr;
    const VisibleSet* visible = nullptr;
    const std::vector<StyledObject>* looks = nullptr;
    GpuTarget* picture = nullptr;
    GpuState* state = nullptr;
    ProgramStore* programs = nullptr;
    TargetPool* pool = nullptr;
    SurfaceDrawer* surfaces = nullptr;
    LineDrawer* lines = nullptr;
    EdgeStore* edges = nullptr;
    LineFrame line_frame;
    const GpuVertexArray* no_vertices = nullptr;
    SurfaceFeatures scene_features = 0;  ///< Number of lights.
    std::uint32_t shadow_texture = 0;
    const GpuLightmap* lightmap = nullptr;
    std::map<ImageKey, Image> images;
    bool has_lines = false;              ///< Some style of the scene draws lines, seen or not.
    std::vector<FaceCall> opaque_faces;  ///< In the order of the calls.
    GpuQueries* queries = nullptr;       ///< Null: what is hidden is drawn all the same.
    std::optional<VisibleSet> seen;      ///< What of `visible` is not hidden by other faces, when that was asked.
    int transient_targets = 0;
};

}  // namespace hw
