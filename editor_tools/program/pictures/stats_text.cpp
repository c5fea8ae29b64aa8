#include "program/pictures/stats_text.hpp"

#include <fmt/format.h>

namespace hw {

std::string stats_text(const FrameStats& stats)
{
    return fmt::format(
        "visible    {} of {} leaves, {} of {} objects\n"
        "drawn      {} faces, {} triangles in all passes, {} lines, {} draw calls, {} state changes, {} program "
        "switches\n"
        "products   {} silhouette extractions ({} edges), {} images, {} transient targets, {} mirror views\n"
        "since load {} edge tables, {} adjacencies, {} hatch streams, {} shadow maps, {} programs\n"
        "time ms    visibility {:.2f}, products {:.2f}, images {:.2f}, surfaces {:.2f}, lines {:.2f}, resolve {:.2f}, "
        "total {:.2f}\n",
        stats.leaves_visible, stats.leaves_total, stats.objects_visible, stats.objects_total, stats.faces_drawn,
        stats.triangles, stats.lines, stats.draw_calls, stats.state_changes, stats.program_switches,
        stats.silhouette_extractions, stats.silhouette_edges, stats.images_made, stats.transient_targets,
        stats.mirror_views, stats.edge_tables_built, stats.adjacencies_built, stats.hatch_streams_built,
        stats.shadow_maps_drawn, stats.programs_compiled, stats.visibility_ms, stats.products_ms, stats.images_ms,
        stats.surfaces_ms, stats.lines_ms, stats.resolve_ms, stats.total_ms);
}

JsonValue stats_json(const FrameStats& stats)
{
    JsonValue json = JsonValue::object();
    json.set("leaves_visible", stats.leaves_visible).set("leaves_total", stats.leaves_total);
    json.set("objects_visible", stats.objects_visible).set("objects_total", stats.objects_total);
    json.set("faces_drawn", stats.faces_drawn).set("triangles", stats.triangles).set("lines", stats.lines);
    json.set("draw_calls", stats.draw_calls).set("state_changes", stats.state_changes);
    json.set("program_switches", stats.program_switches);
    json.set("silhouette_extractions", stats.silhouette_extractions).set("silhouette_edges", stats.silhouette_edges);
    json.set("images_made", stats.images_made).set("transient_targets", stats.transient_targets);
    json.set("mirror_views", stats.mirror_views);
    json.set("edge_tables_built", stats.edge_tables_built).set("adjacencies_built", stats.adjacencies_built);
    json.set("hatch_streams_built", stats.hatch_streams_built).set("shadow_maps_drawn", stats.shadow_maps_drawn);
    json.set("programs_compiled", stats.programs_compiled);
    json.set("visibility_ms", stats.visibility_ms).set("products_ms", stats.products_ms);
    json.set("images_ms", stats.images_ms).set("surfaces_ms", stats.surfaces_ms);
    json.set("lines_ms", stats.lines_ms).set("resolve_ms", stats.resolve_ms).set("total_ms", stats.total_ms);
    return json;
}

}  // namespace hw
