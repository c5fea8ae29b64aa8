// Milliseconds and errors of every way to find silhouettes, over the same views in one run. The reference computes with
// rational numbers and shares no code with what it judges.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <numbers>
#include <optional>
#include <random>

#include "hatchway/core/error.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/core/progress.hpp"
#include "hatchway/geometry/silhouettes/silhouettes.hpp"
#include "hatchway/io/json/out.hpp"
#include "hatchway/io/level/file.hpp"
#include "hatchway/io/model/import.hpp"
#include "measure/measures.hpp"
#include "measure/silhouettes/half_edge_mesh.hpp"
#include "measure/silhouettes/silhouette_oracle.hpp"
#include "measure/silhouettes/smooth_mesh.hpp"
#include "program/arguments.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

constexpr int kRounds = 3;
constexpr int kTrials = 1000;  // random views among which the worst are looked for
constexpr std::size_t kWorst = 5;
constexpr float kNoCreases = 3.2f;
constexpr double kLeastFaces = 0.9;  // of the model: where float positions collapse to less, nothing is measured

struct SilhouetteMeasureArguments {
    std::vector<std::filesystem::path> files;
    std::vector<int> smooth;
    int views = 26;
    int random_views = 0;
    bool is_orthographic = false;
    std::vector<double> offsets{0.0, 1e3, 1e5, 1e6};
    std::vector<double> scales{1.0};
    std::filesystem::path json;
};

/// One mesh placed for one row, with the views that all methods get.
struct Subject {
    Surface surface;
    std::unique_ptr<HalfEdgeMesh> half_edges;
    std::unique_ptr<SilhouetteOracle> oracle;
    std::vector<Viewpoint> views;
    std::vector<std::vector<OracleEdge>> expected;  ///< For each view.
    double preprocess_s = 0.0;                      ///< Without clusters.
    double cluster_s = 0.0;
};

enum class Method { brute, candidates, hierarchy, automatic, openmesh };

struct Variant {
    Method method;
    FacingPrecision precision;
    const char* method_name;
    const char* precision_name;
};
constexpr std::array<Variant, 7> kVariants{{{Method::brute, FacingPrecision::exact, "brute", "exact"},
                                            {Method::candidates, FacingPrecision::exact, "candidates", "exact"},
                                            {Method::hierarchy, FacingPrecision::exact, "hierarchy", "exact"},
                                            {Method::automatic, FacingPrecision::exact, "auto", "exact"},
                                            {Method::brute, FacingPrecision::double_only, "brute", "double"},
                                            {Method::brute, FacingPrecision::single_only, "brute", "float"},
                                            {Method::openmesh, FacingPrecision::single_only, "openmesh", "float"}}};

struct Row {
    std::string model;
    Variant variant;
    double offset = 0.0;
    double scale = 1.0;
    std::vector<double> ms;
    std::uint64_t faces = 0;
    double faces_left = 1.0;  ///< Share of the model's faces before it was moved and scaled.
    std::uint64_t edges = 0;
    SilhouetteErrors errors;
    SilhouetteCounters counters;
    std::uint64_t bytes = 0;
    double preprocess_s = 0.0;
};

double seconds_since(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double quantile(std::vector<double> values, double share)
{
    if (values.empty()) return 0.0;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// Views evenly around the mesh, random ones, and of more random ones those from which the filter left most faces open.
std::vector<Viewpoint> views_of(const Surface& surface, const SilhouetteMeasureArguments& arguments)
{
    Box box;
    for (const glm::vec3& p : surface.positions) box.add(glm::dvec3(p));
    const double reach = 0.5 * glm::length(box.size());
    const auto view = [&](double x, double y, double z) {
        const glm::dvec3 direction(x, y, z);
        return Viewpoint{arguments.is_orthographic ? direction : box.centre() + 3.0 * reach * direction,
                         arguments.is_orthographic};
    };
    std::vector<Viewpoint> views;
    for (int i = 0; i < arguments.views; ++i) {
        const double y = 1.0 - 2.0 * (i + 0.5) / arguments.views,
                     around = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
        const double r = std::sqrt(1.0 - y * y);
        views.push_back(view(r * std::cos(around), y, r * std::sin(around)));
    }
    std::mt19937 random(20011);
    const auto part = [&] { return 2.0 * (static_cast<double>(random()) / 4294967295.0) - 1.0; };
    const auto random_view = [&] {
        const double x = part(), y = part(), z = part();
        return view(x, y, z);
    };
    for (int i = 0; i < arguments.random_views; ++i) views.push_back(random_view());
    std::vector<std::pair<std::uint64_t, Viewpoint>> trials;
    SilhouetteScratch scratch;
    for (int i = 0; i < kTrials; ++i) {
        const Viewpoint trial = random_view();
        scratch.counters = {};
        find_facing(surface, trial, FacingPrecision::exact, scratch);
        trials.emplace_back(scratch.counters.double_stage, trial);
    }
    std::stable_sort(trials.begin(), trials.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    for (std::size_t i = 0; i < kWorst; ++i) views.push_back(trials[i].second);
    return views;
}

/// Positions and faces as the model has them: what a program that loads it into OpenMesh goes through. Our surfaces put
/// faces that lie close together side by side.
Surface in_model_order(const Surface& surface)
{
    std::vector<std::uint32_t> order(surface.faces.size());
    for (std::uint32_t face = 0; face < order.size(); ++face) order[face] = face;
    std::sort(order.begin(), order.end(),
              [&](auto a, auto b) { return surface.face_triangle[a] < surface.face_triangle[b]; });
    Surface plain;
    plain.positions = surface.positions;
    for (const std::uint32_t face : order) plain.faces.push_back(surface.faces[face]);
    return plain;
}

constexpr SurfaceOptions kWithoutClusters{.cluster_from_faces = std::numeric_limits<std::uint32_t>::max()};

/// Null where less than kLeastFaces of `whole_faces` is left: such a mesh is another one, and an empty one cannot be
/// wrong.
std::optional<Subject> subject_of(MeshData mesh, double offset, double scale, std::size_t whole_faces,
                                  const SilhouetteMeasureArguments& arguments)
{
    for (glm::vec3& p : mesh.positions) p = glm::vec3(glm::dvec3(p) * scale + offset);
    Subject subject;
    const auto start = std::chrono::steady_clock::now();
    subject.surface = build_surface(mesh, kWithoutClusters);
    subject.preprocess_s = seconds_since(start);
    if (subject.surface.faces.empty() ||
        static_cast<double>(subject.surface.faces.size()) < kLeastFaces * static_cast<double>(whole_faces)) {
        log_warning(fmt::format("moved by {:g} and scaled by {:g}, {} of {} faces are left: not measured", offset,
                                scale, subject.surface.faces.size(), whole_faces));
        return std::nullopt;
    }
    const auto cluster_start = std::chrono::steady_clock::now();
    subject.surface.clusters.prepare(subject.surface);
    subject.cluster_s = seconds_since(cluster_start);
    subject.half_edges = std::make_unique<HalfEdgeMesh>(in_model_order(subject.surface));
    subject.oracle = std::make_unique<SilhouetteOracle>(subject.surface.positions, subject.surface.faces);
    subject.views = views_of(subject.surface, arguments);
    for (const Viewpoint& view : subject.views)
        subject.expected.push_back(subject.oracle->silhouettes(view.eye, view.is_orthographic ? 0.0 : 1.0));
    return subject;
}

bool takes_clusters(const Subject& subject, Method method)
{
    const bool pays = subject.surface.faces.size() >= SurfaceOptions{}.cluster_from_faces;
    return method == Method::hierarchy || (method == Method::automatic && pays);
}

std::vector<OracleEdge> run_once(const Subject& subject, const Variant& variant, const Viewpoint& view,
                                 SilhouetteScratch& scratch, std::vector<int>& openmesh_edges, double& ms)
{
    const SilhouetteOptions options{
        .crease_rad = kNoCreases,
        .precision = variant.precision,
        .method = takes_clusters(subject, variant.method) ? SilhouetteMethod::hierarchy : SilhouetteMethod::brute};
    std::span<const std::uint32_t> edges;
    const auto start = std::chrono::steady_clock::now();
    if (variant.method == Method::openmesh) {
        subject.half_edges->plain_silhouettes(view, openmesh_edges);
    } else {
        const auto find = variant.method == Method::candidates ? drawn_contours : all_silhouettes;
        edges = find(subject.surface, view, options, scratch);
    }
    ms = 1e3 * seconds_since(start);

    std::vector<OracleEdge> found;
    const auto add = [&](const std::array<std::uint32_t, 2>& ends) {
        found.push_back({std::min(ends[0], ends[1]), std::max(ends[0], ends[1])});
    };
    if (variant.method == Method::openmesh) {
        for (const int edge : openmesh_edges) add(subject.half_edges->edge_ends(edge));
    } else {
        for (const std::uint32_t edge : edges) add(edge_vertices(subject.surface, edge));
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

/// What a method is to find: candidates leave out what is drawn anyway and what the reflex rule hides, and so make no
/// closed loops.
std::vector<OracleEdge> expected_of(const Subject& subject, const Variant& variant, std::size_t view)
{
    if (variant.method != Method::candidates) return subject.expected[view];
    const EdgeClasses classes = classes_at(subject.surface, kNoCreases);
    std::vector<OracleEdge> candidates;
    for (const EdgeRange range : classes.candidates) {
        for (std::uint32_t edge = range.begin; edge < range.end; ++edge) {
            const auto [a, b] = edge_vertices(subject.surface, edge);
            candidates.push_back({std::min(a, b), std::max(a, b)});
        }
    }
    std::sort(candidates.begin(), candidates.end());
    std::vector<OracleEdge> expected;
    std::set_intersection(candidates.begin(), candidates.end(), subject.expected[view].begin(),
                          subject.expected[view].end(), std::back_inserter(expected));
    return expected;
}

void measure_subject(const Subject& subject, Row& row)
{
    SilhouetteScratch scratch;
    std::vector<int> openmesh_edges;
    for (int round = 0; round < kRounds; ++round) {
        for (std::size_t view = 0; view < subject.views.size(); ++view) {
            double ms = 0.0;
            const auto found = run_once(subject, row.variant, subject.views[view], scratch, openmesh_edges, ms);
            row.ms.push_back(ms);
            if (round > 0) continue;
            const SilhouetteErrors errors = subject.oracle->judge(found, expected_of(subject, row.variant, view));
            row.errors.false_positives += errors.false_positives;
            row.errors.false_negatives += errors.false_negatives;
            if (row.variant.method != Method::candidates) row.errors.odd_vertices += errors.odd_vertices;
        }
    }
    row.faces = subject.surface.faces.size();
    row.edges = subject.surface.edges.size();
    row.counters = scratch.counters;
    const OutlineBytes bytes = outline_bytes(subject.surface);
    const bool has_clusters = takes_clusters(subject, row.variant.method);
    row.bytes = bytes.edges + bytes.planes + (has_clusters ? bytes.clusters : 0);
    row.preprocess_s = subject.preprocess_s + (has_clusters ? subject.cluster_s : 0.0);
}

double share(std::uint64_t part, std::uint64_t whole)
{
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

JsonValue row_json(const Row& row)
{
    const double median = quantile(row.ms, 0.5);
    const double calls = static_cast<double>(row.ms.size());
    JsonValue json = JsonValue::object();
    json.set("model", row.model).set("method", row.variant.method_name).set("precision", row.variant.precision_name);
    json.set("offset", row.offset).set("scale", row.scale).set("faces", row.faces);
    json.set("faces_left", row.faces_left);
    json.set("ms_median", median).set("ms_p95", quantile(row.ms, 0.95));
    json.set("ns_per_edge", 1e6 * median / static_cast<double>(std::max<std::uint64_t>(row.edges, 1)));
    json.set("fp", std::uint64_t{row.errors.false_positives}).set("fn", std::uint64_t{row.errors.false_negatives});
    json.set("odd", std::uint64_t{row.errors.odd_vertices});
    json.set("fallback", share(row.counters.exact_stage, row.counters.faces_tested));
    json.set("double_stage", share(row.counters.double_stage, row.counters.faces_tested));
    json.set("tested_share", static_cast<double>(row.counters.edges_tested) / calls /
                                 static_cast<double>(std::max<std::uint64_t>(row.edges, 1)));
    json.set("bytes", row.bytes).set("preprocess_s", row.preprocess_s);
    return json;
}

std::string row_text(const Row& row)
{
    return fmt::format("{:<24} {:<10} {:<6} {:>8.0e} {:>8.0e} {:>9.3f} {:>9.3f} {:>6} {:>6} {:>5} {:>9.5f}\n",
                       row.model, row.variant.method_name, row.variant.precision_name, row.offset, row.scale,
                       quantile(row.ms, 0.5), quantile(row.ms, 0.95), row.errors.false_positives,
                       row.errors.false_negatives, row.errors.odd_vertices,
                       share(row.counters.double_stage, row.counters.faces_tested));
}

/// All primitives of a model as one mesh of bare triangles, object space.
MeshData merged_mesh(const std::filesystem::path& file)
{
    const Level level = read_level(file);
    const Scene scene = import_model(level.scene_file, level.project_root);
    MeshData merged;
    for (const MeshData& mesh : scene.meshes) {
        const auto first = static_cast<std::uint32_t>(merged.positions.size());
        merged.positions.insert(merged.positions.end(), mesh.positions.begin(), mesh.positions.end());
        for (const std::uint32_t index : mesh.indices) merged.indices.push_back(first + index);
    }
    return merged;
}

struct NamedMesh {
    std::string name;
    MeshData mesh;
};

std::vector<NamedMesh> meshes_of(const SilhouetteMeasureArguments& arguments)
{
    std::vector<NamedMesh> meshes;
    for (const auto& file : arguments.files) meshes.push_back({file.stem().string(), merged_mesh(file)});
    for (const int triangles : arguments.smooth) {
        meshes.push_back({fmt::format("smooth_{}", triangles), smooth_mesh(static_cast<std::uint32_t>(triangles))});
    }
    if (meshes.empty()) throw Error({.what = "no model to measure", .expected = "models, or sizes for --smooth"});
    return meshes;
}

void measure_silhouettes(const SilhouetteMeasureArguments& arguments)
{
    require_outputs({{"--json", arguments.json}}, arguments.files);
    JsonValue rows = JsonValue::array();
    bool is_empty = true;
    const std::vector<NamedMesh> meshes = meshes_of(arguments);
    Progress progress("Measuring silhouettes", meshes.size() * arguments.offsets.size() * arguments.scales.size());
    print_line(fmt::format("{:<24} {:<10} {:<6} {:>8} {:>8} {:>9} {:>9} {:>6} {:>6} {:>5} {:>9}", "model", "method",
                           "number", "offset", "scale", "median ms", "p95 ms", "false+", "false-", "odd", "doubles"));
    for (const NamedMesh& named : meshes) {
        const std::size_t whole_faces = build_surface(named.mesh, kWithoutClusters).faces.size();
        for (const double offset : arguments.offsets) {
            for (const double scale : arguments.scales) {
                progress.advance();
                const std::optional<Subject> subject = subject_of(named.mesh, offset, scale, whole_faces, arguments);
                if (!subject) continue;
                for (const Variant& variant : kVariants) {
                    Row row{.model = named.name, .variant = variant, .offset = offset, .scale = scale};
                    measure_subject(*subject, row);
                    row.faces_left = static_cast<double>(row.faces) / static_cast<double>(whole_faces);
                    rows.push(row_json(row));
                    is_empty = false;
                    print_lines(row_text(row));
                }
            }
        }
    }
    if (is_empty)
        throw Error({.what = "no model keeps its faces there", .expected = "a smaller --offset or a larger --scale"});
    if (!arguments.json.empty()) write_json(arguments.json, JsonValue::object().set("rows", std::move(rows)));
}

}  // namespace

void add_measure_silhouettes(CommandLine measure)
{
    auto arguments = std::make_shared<SilhouetteMeasureArguments>();
    CommandLine command =
        measure.add_subcommand("silhouettes", "Time and errors of every way to find silhouette edges");
    command.add_option("models", arguments->files, "Models or levels").option_text("MODEL...");
    command.add_option("--smooth", arguments->smooth, "Add bumpy spheres of so many triangles, to see how a cost grows")
        .delimiter(',')
        .option_text("LIST")
        .check(whole_number_in(64, 10'000'000));
    command.add_option("--views", arguments->views, "Views around the model; 26")
        .option_text("N")
        .check(whole_number_in(1, 100'000));
    command.add_option("--random", arguments->random_views, "Random views in addition, the same in each run; 0")
        .option_text("N")
        .check(whole_number_in(0, 1'000'000));
    command.add_flag("--orthographic", arguments->is_orthographic, "Look from directions, not from eyes");
    command.add_option("--offset", arguments->offsets, "Move the model; 0,1e3,1e5,1e6")
        .delimiter(',')
        .option_text("LIST")
        .check(number_in(0.0, limits::kMaxCoordinate));
    command.add_option("--scale", arguments->scales, "Scale the model first; 1")
        .delimiter(',')
        .option_text("LIST")
        .check(number_in(1e-9, 1e9));
    add_json_argument(command, arguments->json);
    command.callback([arguments] { measure_silhouettes(*arguments); });
}

}  // namespace hw
