#include "report/silhouette_sections.hpp"

#include "report/section_arguments.hpp"

namespace hw {
namespace {

namespace fs = std::filesystem;

ReportSection silhouettes_section(const std::vector<std::string>& models)
{
    return {.name = "silhouettes",
            .title = "Silhouettes",
            .judge =
                "Rational arithmetic (measure/silhouettes/silhouette_oracle), which shares no code with the search. It "
                "starts from the imported triangles, equal positions made one, and of triangles with the same corners "
                "one. An edge of two triangles is a silhouette where both lie on the same side of it in the picture; "
                "edges of one or of more than two are drawn from everywhere and count nowhere; edges of a face in "
                "whose plane "
                "the eye lies are left open by a file (edge_on) and count in repaired_fp and repaired_fn alone. fp and "
                "fn are edges that "
                "repair left alone, changed_fp and changed_fn those that it changed (stitched, cut, of a needle that "
                "takes its neighbour's plane: changed_edges). repaired_fp and repaired_fn compare with our surface "
                "after repair; which of its faces take a neighbour's plane, the engine tells the judge there. Where a "
                "node is turned and moved, the judge computes in world space without rounding.",
            .leaves_out =
                "Preparing a surface (column preprocess_s). Which edges are candidates, for the row of that name: the "
                "engine says so, and none of them can be missing. Where OpenMesh refuses faces (refused_faces), its "
                "mesh is another one, and it has no errors. Where float positions collapse so that less than 90 % of "
                "the faces are left, there is no row.",
            .says =
                "Milliseconds to find the silhouette edges from one eye, and the wrong edges against rational "
                "arithmetic, for every method and precision, at growing offsets from the origin: of the vertices, in "
                "floats, and of the node, in doubles. OpenMesh goes two ways: a plain loop over edges, and one that "
                "keeps each face's facing. All have -O3; but our search holds planes of 16 bits and takes AVX2 where "
                "the processor has it, written by hand (rows \"brute, float\" and \"brute, double\" have neither), and "
                "OpenMesh's float loops are compiled for every x86-64.",
            .arguments = joined({"silhouettes"}, models,
                                {"--views", "10", "--offset", "0,1e3,1e5,1e6", "--node-offset", "1e3,1e5,1e7"}),
            .plots = {{.title = "Time against wrong edges (all models and offsets)",
                       .x_column = "ms_median",
                       .x_label = "median ms for a view",
                       .y_column = "fp+fn",
                       .y_label = "false + missing edges, all views",
                       .series_columns = {"method", "precision"}}}};
}

ReportSection random_silhouettes_section(const std::string& prism, const fs::path& data, bool is_orthographic)
{
    std::vector<std::string> arguments{"silhouettes", prism};
    if (!data.empty())
        for (const char* name : {"models/spot.glb", "models/suzanne.glb", "models/teapot_bezier_n20.glb"})
            arguments.push_back((data / name).string());
    arguments = joined(std::move(arguments), {"--views", "1", "--random", "1000", "--offset", "0"});
    if (is_orthographic) arguments.push_back("--orthographic");
    return {.name = is_orthographic ? "silhouettes_orthographic" : "silhouettes_random",
            .title = is_orthographic ? "Silhouettes from random directions" : "Silhouettes from random eyes",
            .judge = "As above.",
            .leaves_out = "Eyes exactly in the plane of a face: tests have those.",
            .says = "The same with a thousand random views, in small models also from inside.",
            .arguments = std::move(arguments),
            .plots = {}};
}

ReportSection silhouette_growth_section()
{
    return {.name = "silhouette_growth",
            .title = "Silhouettes of one smooth shape, ever finer",
            .judge = "As above.",
            .leaves_out = "Rough meshes, which gain less; preparing a surface. Times are good only of an idle machine.",
            .says =
                "Milliseconds of every method by the number of faces; wrong edges as above. The hierarchy's work grows "
                "with the contour, brute force with the mesh.",
            .arguments = {"silhouettes", "--smooth", "30000,125000,500000,2000000", "--views", "4", "--offset", "0"},
            .plots = {{.title = "Time by number of faces",
                       .x_column = "faces",
                       .x_label = "faces",
                       .y_column = "ms_median",
                       .y_label = "median ms for a view",
                       .series_columns = {"method", "precision"}}}};
}

ReportSection hard_silhouettes_section(const std::vector<std::string>& hard)
{
    return {.name = "silhouettes_hard",
            .title = "Silhouettes of hard meshes",
            .judge = "As above.",
            .leaves_out =
                "Whether the file or what repair made of it is what was meant: where repair changed edges, the file is "
                "the judge of changed_fp and changed_fn, and a stitched gap counts as two borders less. "
                "Meshes that have no silhouette from anywhere.",
            .says =
                "Meshes of the test data of other programs: nested and doubled shells, faces wound against each other, "
                "edges of many faces, needles, gaps. Wrong edges as above.",
            .arguments = joined({"silhouettes"}, hard, {"--views", "3", "--offset", "0"}),
            .plots = {}};
}

}  // namespace

std::vector<ReportSection> silhouette_sections(const std::vector<std::string>& models, const fs::path& data)
{
    const std::string& prism = models.front();
    std::vector<ReportSection> sections{silhouettes_section(models), random_silhouettes_section(prism, data, false),
                                        random_silhouettes_section(prism, data, true), silhouette_growth_section()};
    // With --reuse the folder need not be there any more.
    const std::vector<std::string> hard = models_in(data / "hard");
    if (!data.empty() && (!hard.empty() || !fs::exists(data))) sections.push_back(hard_silhouettes_section(hard));
    return sections;
}

}  // namespace hw
