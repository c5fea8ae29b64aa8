#include "program/level/hatch_info.hpp"

#include <fmt/format.h>

#include <chrono>

namespace hw {

HatchTotals hatch_totals(const Scene& scene, const std::string& source)
{
    const bool is_all = source != kModelHatching;
    const HatchSource made = source == "principal"  ? HatchSource::principal
                             : source == "cylinder" ? HatchSource::cylinder
                                                    : HatchSource::box;
    HatchTotals totals{.source = source};
    const auto start = std::chrono::steady_clock::now();
    for (const MeshData& mesh : scene.meshes) {
        if (mesh.indices.empty() || (!is_all && !mesh.uv0.empty())) continue;
        const HatchCoordinates hatch = make_hatch_coordinates(mesh, made);
        ++totals.meshes;
        totals.vertices_added += hatch.vertex.size() - std::min(hatch.vertex.size(), mesh.positions.size());
        totals.report.charts += hatch.report.charts;
        totals.report.crease_edges += hatch.report.crease_edges;
        totals.report.chart_border_edges += hatch.report.chart_border_edges;
        totals.report.singularities += hatch.report.singularities;
    }
    totals.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return totals;
}

std::string hatch_text(const HatchTotals& totals)
{
    return fmt::format(
        "hatching    {}: {} meshes got coordinates, {} charts; breaks at {} creases and {} chart borders, {} singular "
        "points; "
        "{} vertices more; {:.2f} s\n",
        totals.source, totals.meshes, totals.report.charts, totals.report.crease_edges,
        totals.report.chart_border_edges, totals.report.singularities, totals.vertices_added, totals.seconds);
}

void add_hatch_json(const HatchTotals& totals, JsonValue& json)
{
    json.set("hatch_source", totals.source).set("hatch_meshes", totals.meshes);
    json.set("hatch_charts", totals.report.charts).set("hatch_creases", totals.report.crease_edges);
    json.set("hatch_chart_borders", totals.report.chart_border_edges);
    json.set("hatch_singularities", totals.report.singularities).set("hatch_vertices_added", totals.vertices_added);
    json.set("hatch_s", totals.seconds);
}

}  // namespace hw
