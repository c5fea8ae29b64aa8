#pragma once

#include <cstdint>

namespace hw {

/// What loading and one frame did. Counters of products built once (edge tables, shadow maps, programs) count since
/// load().
struct FrameStats {
    // Visibility.
    int leaves_visible = 0;  ///< From the eye; 0 when no visibility is used.
    int leaves_total = 0;
    int objects_visible = 0;  ///< From the eye.
    int objects_total = 0;
    // Work of this frame, what mirrors show included.
    int mirror_views = 0;           ///< Views of mirrors that were drawn, those within others counted, too.
    std::uint64_t faces_drawn = 0;  ///< Triangles of objects that the camera's passes draw, each once.
    std::uint64_t triangles = 0;    ///< Sent to the device, each pass counted: also shadows, questions, lines as quads.
    std::uint64_t lines = 0;        ///< Line segments sent to the device, as lines or as quads.
    int draw_calls = 0;
    int state_changes = 0;
    int program_switches = 0;
    int silhouette_extractions = 0;  ///< Objects whose silhouettes were computed for this frame.
    std::uint64_t silhouette_edges = 0;
    int images_made = 0;        ///< Shared images and image passes of this frame.
    int transient_targets = 0;  ///< Results of Pass::render and Pass::filter.
    /// The same view looks different later: what is visible needs the clock, or its presence or a share of its lines
    /// over time is not at its end.
    bool changes_with_time = false;
    // Products since load().
    int edge_tables_built = 0;
    int adjacencies_built = 0;
    int hatch_streams_built = 0;
    int shadow_maps_drawn = 0;
    int lightmaps_uploaded = 0;
    int programs_compiled = 0;
    // Milliseconds of this frame. With FrameOptions::is_timed the device is waited for after each phase.
    double visibility_ms = 0.0;
    double products_ms = 0.0;
    double images_ms = 0.0;
    double surfaces_ms = 0.0;
    double lines_ms = 0.0;
    double resolve_ms = 0.0;
    double total_ms = 0.0;
};

}  // namespace hw
