#include "report/edge_sections.hpp"

#include "report/section_arguments.hpp"

namespace hw {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> files_of(const std::string& measure, const fs::path& data,
                                  const std::vector<const char*>& names, const std::string& hall)
{
    std::vector<std::string> arguments{measure};
    if (!data.empty())
        for (const char* name : names) arguments.push_back((data / name).string());
    arguments.push_back(hall);
    return arguments;
}

ReportSection edge_map_section(const std::string& hall, const fs::path& data)
{
    return {
        .name = "edge_map",
        .title = "Lines from images and from meshes",
        .judge =
            "The engine's own exact visible lines; which of them are profiles, creases or flush is decided anew, by "
            "facing and by rays. Of the named cases, the lines that a draughtsman would draw, by hand.",
        .leaves_out =
            "What the exact lines have wrong: the section on visible lines has a judge of its own. A GPU. Objects of "
            "blended materials. Other views than one of each model and of each scene. Lines of meshes are judged "
            "outside of objects, too, where the others cannot be; they are one pixel wide, without samples.",
        .says =
            "Against the exact lines at 1400 x 900: the share of profiles without a mark within a pixel "
            "(profile_missed) and of marks without a profile within a pixel (profile_extra), creases the same (inner), "
            "and profiles close in front of something (flush), which count apart. The papers' operators stand at the "
            "threshold that is best for them in that file, ours at the one that has no parameter; all are in the "
            "curve. In ms is all that a frame of plain faces does not have: the image of normals and depths or of "
            "numbers, and the edges; of meshes the silhouettes and the lines. Not in it is what is made once of a "
            "mesh, which the row \"object, made anew\" adds, as where a mesh changes in each frame. The cases are "
            "scenes that edge maps are known to fail on: where all its lines are flush or missing, a share of false "
            "pixels is all that can be told.",
        .arguments =
            joined(files_of("edge-map", data,
                            {"models/teapot_bezier_n20.glb", "models/bunny_69k.glb", "models/dragon_res2_202k.glb",
                             "scenes/dungeon_kaykit_9x7.glb", "scenes/city_kaykit_9x9.glb"},
                            hall),
                   {"--views", "1", "--operators", "second,diagonal,c1,ids,ids_2011,object"}),
        .more = {"cases", "curve"},
        .plots = {{.title = "Time against error of profiles",
                   .x_column = "ms",
                   .x_label = "ms that a frame takes more",
                   .y_column = "profile_missed+profile_extra",
                   .y_label = "(1 - recall) + (1 - precision)",
                   .series_columns = {"variant", "normal"},
                   .per_column = "model"},
                  {.title = "Recall against precision, all thresholds",
                   .x_column = "profile_extra",
                   .x_label = "1 - precision",
                   .y_column = "profile_missed",
                   .y_label = "1 - recall",
                   .series_columns = {"variant", "normal"},
                   .is_joined = true,
                   .list = "curve",
                   .per_column = "model"}}};
}

ReportSection ids_section(const std::string& hall, const fs::path& data)
{
    return {
        .name = "ids",
        .title = "Outlines by numbers of triangles",
        .judge =
            "The same rule on the processor, given the image of numbers that the device made (differing_pixels): it "
            "shares the rule, not the code. Errors of edges: as above.",
        .leaves_out =
            "Whether the device put the right number into a pixel. A GPU: the paper's own figures are of a graphics "
            "card, at the same size. Sending a mesh to the device, which the paper's times hold and ours do not. "
            "Creases: this rule has none. The paper's kitchen, which is not to be had; a hall stands in its place.",
        .says =
            "Laid out as table 1 of the paper, with errors: frames in a second by the device (a plain pass, the image "
            "of numbers, the edges), and by lines of the mesh that begin with the imported triangles in each frame "
            "(object_fps), as for a mesh that changes; object_prepare_ms is what of that is welding, adjacency and "
            "edge table. One view of each. Storage vertices compares corners in the shader, lists reads which "
            "triangles are around a corner. Cases: as above. The fan is the cylinder of the paper's figure 2, whose "
            "walls are all neighbours of each other.",
        .arguments = joined(
            files_of("ids", data,
                     {"models/bunny_69k.glb", "scenes/city_kaykit_9x9.glb", "models/dragon_res2_202k.glb",
                      "models/teapot_bezier_n10.glb", "models/teapot_bezier_n20.glb", "models/teapot_bezier_n31.glb"},
                     hall),
            {"--views", "1"}),
        .more = {"cases", "fan"},
        .plots = {{.title = "Time of the edges against their error",
                   .x_column = "ids_ms+resolve_ms",
                   .x_label = "ms of numbers and edges",
                   .y_column = "profile_extra",
                   .y_label = "1 - precision of profiles",
                   .series_columns = {"operator", "storage"}},
                  {.title = "The fan around one edge",
                   .x_column = "sides",
                   .x_label = "walls",
                   .y_column = "resolve_ms",
                   .y_label = "ms of the edges",
                   .series_columns = {"storage"},
                   .is_joined = true,
                   .list = "fan"}}};
}

}  // namespace

std::vector<ReportSection> edge_sections(const std::string& hall, const fs::path& data)
{
    return {edge_map_section(hall, data), ids_section(hall, data)};
}

}  // namespace hw
