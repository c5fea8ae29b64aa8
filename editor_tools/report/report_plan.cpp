#include "report/report_plan.hpp"

#include "report/edge_sections.hpp"
#include "report/hatching_sections.hpp"
#include "report/other_sections.hpp"
#include "report/section_arguments.hpp"
#include "report/silhouette_sections.hpp"

namespace hw {
namespace {

namespace fs = std::filesystem;

ReportSection frame_section(const std::string& level)
{
    return {.name = "frame",
            .title = "Frames",
            .judge = "The same renderer without the PVS: another set of chunks, the same drawing.",
            .leaves_out =
                "A GPU: frames are drawn by Mesa on the processor. A path along which everything is visible, as in the "
                "demo hall, cannot show what a PVS saves, and then equal pixels prove little.",
            .says =
                "Milliseconds of a frame along the level's tour at 1280 x 720 without the PVS and at its efforts, the "
                "share "
                "of the scene that their rows leave, and the share of pixels that differ from the same frame drawn "
                "without: it must be none.",
            .arguments = {"frame", level, "--frames", "15", "--pvs", "fast,full"},
            .plots = {{.title = "Frame time against what the PVS changes",
                       .x_column = "median_ms.total",
                       .x_label = "median ms of a frame",
                       .y_column = "pixels_unlike_without_pvs",
                       .y_label = "share of pixels that differ",
                       .series_columns = {"style", "samples", "pvs"}},
                      {.title = "Frame time against what the rows leave",
                       .x_column = "visible_share",
                       .x_label = "share of the scene's triangles in the row, mean over the path",
                       .y_column = "median_ms.total",
                       .y_label = "median ms of a frame",
                       .series_columns = {"style", "samples"}}}};
}

ReportSection bsp_section(const std::vector<std::string>& scenes)
{
    return {
        .name = "bsp",
        .title = "The tree",
        .judge = "Points by rational arithmetic (bsp_oracle); the area by the engine's own area of a polygon.",
        .leaves_out = "Whether the right polygons were chosen: the tree is judged by its own planes.",
        .says =
            "The tree that a level is compiled with: seconds to choose the structure and to build it, random points "
            "whose leaf rational arithmetic names otherwise (there must be none), and how far the area of all pieces "
            "is from that of the polygons.",
        .arguments = joined({"bsp"}, scenes, {"--points", "100000"}),
        .plots = {{.title = "Time against area error",
                   .x_column = "seconds",
                   .x_label = "seconds",
                   .y_column = "relative_area_error",
                   .y_label = "relative error of the area",
                   .series_columns = {"file"}},
                  {.title = "Time against misclassified points",
                   .x_column = "seconds",
                   .x_label = "seconds",
                   .y_column = "misclassified",
                   .y_label = "wrong of the random points",
                   .series_columns = {"file"}}}};
}

ReportSection pvs_section(const std::vector<std::string>& scenes)
{
    return {
        .name = "pvs",
        .title = "Potentially visible sets",
        .judge =
            "Rays by Embree, 64 from a place: half evenly over the sphere, half at hidden triangles. Each claim of "
            "a hidden chunk that is seen is confirmed with rational numbers. Rooms with slits: by construction.",
        .leaves_out =
            "Where people stand, which the next section tells: averages go over cells, and nobody is in most of "
            "them. A chunk counts as seen "
            "when one of its triangles is hit, which makes the over-estimate look smaller. It is told of cells that "
            "got 2,000 rays (sampled_clusters), where those are 30 and hide something.",
        .says =
            "Seconds to compile, the average visible share, and claims that sampled rays prove wrong: there "
            "must be none. The over-estimate compares rows with what a million rays met.",
        .arguments = joined({"pvs"}, scenes, {"--rays", "1000000", "--pvs", "fast,full"}),
        .more = {"slits"},
        .plots = {{.title = "Compile time against over-estimate",
                   .x_column = "seconds",
                   .x_label = "seconds",
                   .y_column = "over_estimate",
                   .y_label = "visible / visible by sampling",
                   .series_columns = {"file", "effort"}}}};
}

ReportSection visibility_section(const std::string& hall, const fs::path& data)
{
    std::vector<std::string> arguments{"visibility", hall};
    if (!data.empty())
        for (const char* name : {"scenes/dungeon_kaykit_9x7.glb", "scenes/city_kaykit_9x9.glb", "scenes/oa_oa_dm1.glb"})
            arguments.push_back((data / name).string());
    return {.name = "visibility",
            .title = "Visibility where people stand",
            .judge =
                "A ray by Embree through every quarter of a pixel; a chunk that is seen and hidden is confirmed with "
                "rational numbers. Pixels: the same frame without the PVS.",
            .leaves_out =
                "What is seen in less than a quarter of a pixel, so a little more is needed than the column says. Eyes "
                "that look up or down. The frames are of one style and of a software renderer; compiling is no part "
                "of them.",
            .says =
                "Eyes at places that a walker reaches on foot from the level's start and cameras, drawn at random. "
                "Triangles of the chunks in the frustum (in_view), what the PVS leaves of them (drawn), and what "
                "pieces of 64 triangles take of which a ray meets one (needed). Nothing may be lost.",
            .arguments = joined(std::move(arguments), {"--size", "480x300"}),
            .plots = {{.title = "A frame with the PVS against what it leaves",
                       .x_column = "frame_ms",
                       .x_label = "median ms",
                       .y_column = "drawn_share",
                       .y_label = "drawn / in view",
                       .series_columns = {"file"}}}};
}

ReportSection lines_section(std::vector<std::string> arguments)
{
    arguments.insert(arguments.begin(), "lines");
    arguments.insert(arguments.end(), {"--views", "2", "--sweep"});
    const auto plot = [](const char* title, const char* x, const char* x_label, const char* y, const char* y_label) {
        return PlotRecipe{.title = title,
                          .x_column = x,
                          .x_label = x_label,
                          .y_column = y,
                          .y_label = y_label,
                          .series_columns = {"model"},
                          .is_joined = true};
    };
    const char* factor = "polygon offset factor of the depth that lines are tested against";
    return {.name = "lines",
            .title = "Lines on the screen",
            .judge = "The engine's own exact visible lines and its own far policy.",
            .leaves_out =
                "What the exact lines and the far policy have wrong: the section on visible lines has a judge of its "
                "own. Width is told of lines that have no other within 3.5 pixels. The time of the exact lines leaves "
                "out adjacency and seams, which are prepared once.",
            .says =
                "Drawn lines against the exact visible lines at 1400 x 900: the share of their length that is missed, "
                "the share of ink that lies elsewhere, gaps, and the drawn width over the one asked for.",
            .arguments = std::move(arguments),
            .plots = {plot("Missed over the offset", "factor_swept", factor, "missed", "share of visible length"),
                      plot("Leaked over the offset", "factor_swept", factor, "leaked", "share of ink"),
                      plot("Narrowest lines over the offset", "factor_swept", factor, "width_p5",
                           "drawn / requested width, 5th percentile")}};
}

ReportSection visible_lines_section(const std::vector<std::string>& files)
{
    return {.name = "visible_lines",
            .title = "Visible lines",
            .judge =
                "measure/lines/ray_judge: all borders, creases and contours of the imported triangles, a ray for each "
                "pixel of them, no code of the search.",
            .leaves_out =
                "Lines where objects go through each other (unjudged, of all lines), and edges that have no other line "
                "(crossed, of the visible ones). A line stands for an edge within a "
                "pixel that runs like it, within 15 to 30 degrees. What lies within a thousandth of its distance "
                "behind something counts as neither seen nor hidden, nor do edges of more than two faces and joints "
                "that are nearly flat (unsure, of the lines judged).",
            .says =
                "The exact lines at 1400 x 900: the share of what is visible that they miss, that the style's far "
                "policy leaves out (thinned), and the share of them that no visible edge explains across which the "
                "surface bends or ends (extra). Hard meshes of the test data of other programs stand at the end. How "
                "sharp the judge is (noticed): the share of the lines found, "
                "weighed by length, that it would call missed if each were left out in turn. Seconds from the imported "
                "scene (cold: adjacency, edge table, seams, intersections and one view) and of one view of a prepared "
                "scene (warm).",
            .arguments = joined({"visible-lines"}, files, {"--views", "2"}),
            .plots = {{.title = "Cold time against missed lines",
                       .x_column = "cold_s",
                       .x_label = "seconds",
                       .y_column = "missed",
                       .y_label = "share of visible length",
                       .series_columns = {"model"}}}};
}

ReportSection portals_section(const fs::path& data)
{
    return {
        .name = "portals",
        .title = "Portals of a file",
        .judge = "A naive flow with separating planes (measure/visibility/naive_flow), of which it shares data types.",
        .leaves_out =
            "Other compilers: none of them runs here (for the share that q3map2 stored in another map beside ours, see "
            "docs/method/visibility.md). One file alone. What both flows hide and should not: the rays of the section "
            "before judge that, on other scenes. Preparing the portals, which both are given.",
        .says =
            "Seconds for all rows of a level of another engine, one thread each, and pairs (leaf, seen leaf) that one "
            "flow shows and the other not. Both cut with the same tolerances (kept up to 1e-6 behind a plane, gone "
            "where nothing is 1e-4 in front), take bits in words for sets, and no memory at a cut.",
        .arguments = {"portals", (data / "prt" / "E1M1-edited-ents.prt").string()},
        .plots = {}};
}

ReportSection lightmap_section()
{
    return {
        .name = "lightmap",
        .title = "Lightmaps",
        .judge = "Closed forms; the lit room by the same bake with 8 times the samples and another seed.",
        .leaves_out =
            "Bias of the lit room: noise alone is seen there, that of the reference added. Nothing throws a shadow "
            "in the "
            "cases of point and sun.",
        .says =
            "Seconds and error of baked light against closed-form form factors and a converged reference, over "
            "the number of samples. rms, worst_of_mean and bias are shares of the reference's mean, local_p95 is the "
            "95th percentile of errors that are each a share of the reference at its place. The foot of the wall is "
            "the sunny floor within 0.25 m, two luxels, of a wall that stands on it: what keeping light out of dark "
            "rooms costs.",
        .arguments = {"lightmap"},
        .more = {"leaks"},
        .plots = {{.title = "Time against error",
                   .x_column = "seconds",
                   .x_label = "seconds",
                   .y_column = "rms",
                   .y_label = "relative RMS error",
                   .series_columns = {"case"},
                   .is_joined = true}}};
}

ReportSection walk_section(const std::vector<std::string>& scenes)
{
    return {
        .name = "walk",
        .title = "Walking",
        .judge = "measure/walk/walk_oracle: distances and crossings in closed form, no code of the walker.",
        .leaves_out =
            "Moving objects. Walkers from other places than the level's own and those that the judge chose. Whether a "
            "walk that flies is stuck or lost.",
        .says =
            "Random inputs in each scene, frames of 1 to 100 ms, judged by distances and crossings that the walker "
            "does not use. All that is counted as wrong must be 0: bodies in walls, crossings, stuck walkers, who "
            "fell out of the world and was put back, who got on foot where nothing is below.",
        .arguments = joined({"walk"}, scenes, {"--inputs", "100000"}),
        .plots = {{.title = "Time against what went wrong",
                   .x_column = "seconds",
                   .x_label = "seconds",
                   .y_column = "wrong",
                   .y_label = "all that must not happen",
                   .series_columns = {"file"}}}};
}

ReportSection scale_section()
{
    const auto plot = [](const char* title, const char* column, const char* label) {
        return PlotRecipe{.title = title,
                          .x_column = "triangles",
                          .x_label = "drawn triangles of the level",
                          .y_column = column,
                          .y_label = label,
                          .series_columns = {},
                          .is_joined = true};
    };
    return {
        .name = "scale",
        .title = "Size of levels",
        .judge = "The same frame without the PVS, for pixels; times have no judge.",
        .leaves_out =
            "Styles other than photoreal, and the memory of a walker. What a frame draws differs between sizes "
            "(column frame_triangles). The memory is what is allocated with the level open and drawn, more than before "
            "it was opened; targets and what the software renderer keeps for a frame are in it and do not grow with "
            "the level, so it has no slope. The compiler's budgets cap "
            "clusters and the work on openings (column shortfalls: how many ran out), so the time flattens where more "
            "is drawn than need be.",
        .says =
            "Rooms on a grid, from 64 to 500 of them, 10 objects each: what grows with the level, and a frame from "
            "the first room. The pixels that differ from a frame drawn without the PVS must be none.",
        .arguments = {"scale"},
        .plots = {plot("Compile time", "compile_s", "seconds"), plot("Memory", "heap_mib", "MiB"),
                  plot("A frame from the first room", "frame_ms", "median ms")}};
}

}  // namespace

std::vector<ReportSection> report_plan(const fs::path& content, const fs::path& data)
{
    const std::string hall = (content / "levels" / "hall.level.json").string();
    std::vector<std::string> models{(content / "models" / "prism.glb").string()};
    std::vector<std::string> scenes{hall};
    if (!data.empty()) {
        models = joined(std::move(models), models_in(data / "models"));
        scenes = joined(std::move(scenes), models_in(data / "scenes"));
    }
    const std::vector<std::string> drawn = joined(models, scenes);
    std::vector<ReportSection> plan = silhouette_sections(models, data);
    const auto add = [&](ReportSection section) { plan.push_back(std::move(section)); };
    add(frame_section(hall));
    add(bsp_section(scenes));
    add(pvs_section(scenes));
    add(visibility_section(hall, data));
    if (!data.empty()) add(portals_section(data));
    add(lightmap_section());
    add(lines_section(drawn));
    add(visible_lines_section(data.empty() ? drawn : joined(drawn, models_in(data / "hard"))));
    for (ReportSection& section : edge_sections(hall, data)) add(std::move(section));
    add(hatch_section());
    add(coherence_section(hall));
    add(ink_section(content / "maps" / "ink"));
    add(walk_section(scenes));
    add(scale_section());
    for (ReportSection& section : sections_made_elsewhere()) add(std::move(section));
    return plan;
}

}  // namespace hw
