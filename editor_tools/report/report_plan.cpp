#include "report/report_plan.hpp"

#include <algorithm>

namespace hw {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> models_in(const fs::path& folder)
{
    std::vector<std::string> files;
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(folder, missing))
        if (entry.path().extension() == ".glb") files.push_back(entry.path().string());
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& second,
                                const std::vector<std::string>& third = {})
{
    first.insert(first.end(), second.begin(), second.end());
    first.insert(first.end(), third.begin(), third.end());
    return first;
}

ReportSection silhouettes_section(const std::vector<std::string>& models)
{
    return {.name = "silhouettes",
            .title = "Silhouettes",
            .judge =
                "Rational arithmetic (measure/silhouettes/silhouette_oracle), which shares no code with the search. It "
                "starts from the file's triangles, equal positions made one (fp, fn); repaired_fp and repaired_fn "
                "compare with our surface after welding and repair. Where a node is turned and moved, it computes in "
                "world space without rounding.",
            .leaves_out =
                "Preparing a surface (column preprocess_s). Which edges are candidates, for the row of that name: the "
                "engine says so. Where float positions collapse so that less than 90 % of the faces are left, there is "
                "no row.",
            .says =
                "Milliseconds to find the silhouette edges from one eye, and the wrong edges against rational "
                "arithmetic, for every method and precision, at growing offsets from the origin: of the vertices, in "
                "floats, and of the node, in doubles. OpenMesh goes two ways: a plain loop over edges, and one that "
                "keeps each face's facing; both are built with the engine's options.",
            .arguments = joined({"silhouettes"}, models, {"--offset", "0,1e3,1e5,1e6", "--node-offset", "1e3,1e5,1e7"}),
            .plots = {{.title = "Time against wrong edges (all models and offsets)",
                       .x_column = "ms_median",
                       .x_label = "median ms for a view",
                       .y_column = "fp+fn",
                       .y_label = "false + missing edges, all views",
                       .series_columns = {"method", "precision"}}}};
}

ReportSection silhouette_growth_section()
{
    return {.name = "silhouette_growth",
            .title = "Silhouettes of one smooth shape, ever finer",
            .judge = "As above.",
            .leaves_out = "Rough meshes, which gain less; preparing a surface.",
            .says =
                "Milliseconds of every method by the number of faces; wrong edges as above. The hierarchy's work grows "
                "with the contour, brute force with the mesh.",
            .arguments = {"silhouettes", "--smooth", "30000,125000,500000,2000000", "--offset", "0"},
            .plots = {{.title = "Time by number of faces",
                       .x_column = "faces",
                       .x_label = "faces",
                       .y_column = "ms_median",
                       .y_label = "median ms for a view",
                       .series_columns = {"method", "precision"}}}};
}

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
        .leaves_out =
            "The tree that a level ships with: structure is chosen with smaller budgets here, and without cells.",
        .says =
            "Seconds to choose the structure and to build the tree, random points whose leaf rational arithmetic "
            "names otherwise (there must be none), and how far the area of all pieces is from that of the polygons.",
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
    return {.name = "pvs",
            .title = "Potentially visible sets",
            .judge = "Rays by Embree; each claim of a hidden chunk that is seen is confirmed with rational numbers.",
            .leaves_out =
                "Where people stand: averages go over cells, and nobody is in most of them. A chunk counts as seen "
                "when one of its triangles is hit, which makes the over-estimate look smaller.",
            .says =
                "Seconds to compile, the average visible share, and claims that sampled rays prove wrong: there "
                "must be none. The over-estimate compares rows with what a million rays met.",
            .arguments = joined({"pvs"}, scenes, {"--rays", "1000000", "--pvs", "fast,full"}),
            .plots = {{.title = "Compile time against over-estimate",
                       .x_column = "seconds",
                       .x_label = "seconds",
                       .y_column = "over_estimate",
                       .y_label = "visible / visible by sampling",
                       .series_columns = {"file", "effort"}}}};
}

ReportSection lines_section(const std::string& prism, const std::string& hall, const fs::path& data)
{
    std::vector<std::string> arguments{"lines", prism, hall};
    if (!data.empty())
        for (const char* name : {"models/teapot_bezier_n20.glb", "models/teapot_bezier_n31.glb", "models/bunny_69k.glb",
                                 "scenes/dungeon_kaykit_9x7.glb"})
            arguments.push_back((data / name).string());
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
                "Candidate edges that both overlook, and lines that the far policy wrongly thins. The time of the "
                "exact lines leaves out adjacency and seams, which are prepared once.",
            .says =
                "Drawn lines against the exact visible lines at 1400 x 900: the share of their length that is missed, "
                "the share of ink that lies elsewhere, gaps, and the drawn width over the one asked for.",
            .arguments = std::move(arguments),
            .plots = {plot("Missed over the offset", "factor_swept", factor, "missed", "share of visible length"),
                      plot("Leaked over the offset", "factor_swept", factor, "leaked", "share of ink"),
                      plot("Narrowest lines over the offset", "factor_swept", factor, "width_p5",
                           "drawn / requested width, 5th percentile")}};
}

ReportSection hatch_section()
{
    return {
        .name = "hatch",
        .title = "Hatch maps",
        .judge =
            "Columns of pixels, compared with lines of one width and one spacing (hatch_profile, no code of the "
            "engine).",
        .leaves_out = "Curved surfaces other than a sphere.",
        .says =
            "Spacing, stroke width, tone and contrast of hatch maps on planes and a sphere over distance and angle, "
            "against lines of one width and one spacing: our choice of the level, hardware filtering, ordinary mips "
            "and none.",
        .arguments = {"hatch", "--angles", "0,45,80", "--distances", "1,1.4,8,64,256"},
        .plots = {{.title = "Time against tone error",
                   .x_column = "ms",
                   .x_label = "ms for a picture of 64 x 512",
                   .y_column = "tone_rms",
                   .y_label = "RMS of tone, box-blurred over two spacings",
                   .series_columns = {"choice"}},
                  {.title = "Spacing by ink over distance",
                   .x_column = "distance",
                   .x_label = "distance; 1: a texel covers a pixel",
                   .y_column = "ink_spacing_median",
                   .y_label = "relative error, median",
                   .series_columns = {"choice"}}}};
}

ReportSection ink_section(const fs::path& maps)
{
    std::vector<std::string> arguments{"ink"};
    for (const char* name : {"stone_courses", "flagstones", "planks", "roof_tiles"})
        arguments.push_back((maps / name).string());
    return {
        .name = "ink",
        .title = "Ink maps",
        .judge = "The ink of level 0 of the same map, counted along rows and columns.",
        .leaves_out =
            "Maps drawn by hand or from bitmaps. Level 0 has half the tone of the others by design: errors of tone are "
            "absolute.",
        .says =
            "Width of strokes, tone and contrast of ink maps level by level: drawn anew from vectors, and filtered by "
            "the minimum and the mean.",
        .arguments = std::move(arguments),
        .plots = {{.title = "Tone of the levels",
                   .x_column = "level",
                   .x_label = "level",
                   .y_column = "tone",
                   .y_label = "ink coverage",
                   .series_columns = {"map", "filter"},
                   .is_joined = true}}};
}

ReportSection coherence_section(const std::string& level)
{
    return {.name = "coherence",
            .title = "Hatching from frame to frame",
            .judge = "Places carried along by rays of the collision world; two frames of the renderer.",
            .leaves_out =
                "Curved surfaces and edges: only places on flat surface count. Flicker is of a mean over 3 x 3 pixels. "
                "Ratios to the unfiltered map compare different amounts of ink, except for the hatch map.",
            .says =
                "Neighbouring frames along the level's tour, warped by the true motion of the surface: change of ink, "
                "of tone "
                "within 16 pixels, and the way of marks over the surface.",
            .arguments = {"coherence", level},
            .plots = {{.title = "Flicker against sliding",
                       .x_column = "flicker",
                       .x_label = "mean change of ink from frame to frame",
                       .y_column = "slide_px_median",
                       .y_label = "way of marks over the surface, pixels, median",
                       .series_columns = {"ink"}}}};
}

ReportSection lightmap_section()
{
    return {.name = "lightmap",
            .title = "Lightmaps",
            .judge = "Closed forms; the lit room by the same bake with more samples.",
            .leaves_out = "Bias of the lit room: noise alone is seen there.",
            .says =
                "Seconds and error of baked light against closed-form form factors and a converged reference, over "
                "the number of samples.",
            .arguments = {"lightmap"},
            .plots = {{.title = "Time against error",
                       .x_column = "seconds",
                       .x_label = "seconds",
                       .y_column = "rms",
                       .y_label = "relative RMS error",
                       .series_columns = {"case"},
                       .is_joined = true}}};
}

ReportSection walk_section(const std::string& hall, const fs::path& data)
{
    std::vector<std::string> arguments{"walk", hall};
    if (!data.empty())
        for (const char* name : {"scenes/dungeon_kaykit_9x7.glb", "scenes/oa_oa_dm1.glb"})
            arguments.push_back((data / name).string());
    return {
        .name = "walk",
        .title = "Walking",
        .judge = "measure/walk/walk_oracle: distances and crossings in closed form, no code of the walker.",
        .leaves_out = "Moving objects. Walkers from other places than the level's own and those that the judge chose.",
        .says =
            "Random inputs in each scene, frames of 1 to 100 ms, judged by distances and crossings that the walker "
            "does not use. All that is counted as wrong must be 0: bodies in walls, crossings, stuck walkers, who "
            "fell out of the world and was put back, who got on foot where nothing is below.",
        .arguments = joined(std::move(arguments), {"--inputs", "100000"}),
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
    return {.name = "scale",
            .title = "Size of levels",
            .judge = "The same frame without the PVS, for pixels; times have no judge.",
            .leaves_out =
                "Styles other than photoreal, and the memory of a walker. Visible work varies by a factor of three "
                "between sizes (column frame_triangles).",
            .says =
                "Rooms on a grid, from 64 to 500 of them, 10 objects each: what grows with the level, and a frame from "
                "the first room, which sees the same in all. The pixels that differ from a frame drawn without the PVS "
                "must be none.",
            .arguments = {"scale"},
            .plots = {plot("Compile time", "compile_s", "seconds"), plot("Memory", "resident_mib", "MiB"),
                      plot("A frame of equal visible work", "frame_ms", "median ms")}};
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
    return {silhouettes_section(models),
            silhouette_growth_section(),
            frame_section(hall),
            bsp_section(scenes),
            pvs_section(scenes),
            lightmap_section(),
            lines_section(models.front(), hall, data),
            hatch_section(),
            coherence_section(hall),
            ink_section(content / "maps" / "ink"),
            walk_section(hall, data),
            scale_section()};
}

}  // namespace hw
