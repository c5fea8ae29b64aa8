#include <fmt/format.h>

#include <numbers>

#include "hatchway/core/error.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/drawing/scene_surfaces.hpp"
#include "hatchway/geometry/silhouettes/silhouettes.hpp"
#include "hatchway/io/json/out.hpp"
#include "hatchway/io/level/file.hpp"
#include "hatchway/stage/level_world.hpp"
#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

struct SilhouetteArguments {
    std::filesystem::path file;
    std::string eye;
    std::string direction;
    std::string method = "auto";
    double crease_deg = 40.0;
    std::filesystem::path json;
    std::filesystem::path dump_mesh;
};

/// Sums over the objects of a scene. Edges in world space.
struct SilhouetteResult {
    std::uint64_t faces = 0;
    std::uint64_t edges = 0;
    std::uint64_t creases = 0;  ///< Folded edges and those that the artist marked: both are always drawn.
    std::uint64_t candidates = 0;
    std::uint64_t silent = 0;
    std::uint64_t borders = 0;
    std::uint64_t silhouette_count = 0;
    std::uint64_t drawn_count = 0;
    JsonValue silhouettes = JsonValue::array();
    JsonValue drawn = JsonValue::array();
};

JsonValue edge_json(const Surface& surface, std::uint32_t edge, const glm::dmat4& world_from_object)
{
    JsonValue ends = JsonValue::array();
    for (const std::uint32_t vertex : edge_vertices(surface, edge)) {
        const glm::dvec4 p = world_from_object * glm::dvec4(glm::dvec3(surface.positions[vertex]), 1.0);
        ends.push(p.x).push(p.y).push(p.z);
    }
    return ends;
}

/// How one object is searched.
struct ObjectSearch {
    const Surface& surface;
    glm::dmat4 world_from_object;
    Viewpoint viewpoint_world;
    SilhouetteOptions options;
    bool is_all;  ///< Not only among candidates.
};

SilhouetteMethod method_named(const std::string& name)
{
    if (name == "auto") return SilhouetteMethod::automatic;
    return name == "hierarchy" ? SilhouetteMethod::hierarchy : SilhouetteMethod::brute;
}

void add_object(const ObjectSearch& search, SilhouetteScratch& scratch, SilhouetteResult& result)
{
    const auto& [surface, world_from_object, viewpoint_world, options, is_all] = search;
    const EdgeClasses classes = classes_at(surface, options.crease_rad);
    result.faces += surface.faces.size();
    result.edges += surface.edges.size();
    result.creases += classes.crease_count();
    result.candidates += classes.candidate_count();
    result.silent += classes.silent.size();
    result.borders += classes.borders.size();

    const Viewpoint viewpoint = in_object(viewpoint_world, world_from_object);
    const auto find = is_all ? all_silhouettes : drawn_contours;
    for (const std::uint32_t edge : find(surface, viewpoint, options, scratch)) {
        result.silhouettes.push(edge_json(surface, edge, world_from_object));
        ++result.silhouette_count;
    }
    for (const std::uint32_t edge : drawn_contours(surface, viewpoint, options, scratch)) {
        result.drawn.push(edge_json(surface, edge, world_from_object));
        ++result.drawn_count;
    }
}

JsonValue exact_vector(const glm::dvec3& v)
{
    return JsonValue::array().push(JsonValue::exact(v.x)).push(JsonValue::exact(v.y)).push(JsonValue::exact(v.z));
}

JsonValue mesh_json(const Scene& scene, ObjectId id, const Surface& surface, const Viewpoint& viewpoint_world)
{
    JsonValue positions = JsonValue::array();
    for (const glm::vec3& position : surface.positions) positions.push(exact_vector(glm::dvec3(position)));
    JsonValue faces = JsonValue::array();
    for (const auto& face : surface.faces) faces.push(JsonValue::array().push(face[0]).push(face[1]).push(face[2]));
    JsonValue matrix = JsonValue::array();
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) matrix.push(JsonValue::exact(scene.world_from_object(id)[column][row]));

    JsonValue json = JsonValue::object();
    json.set("object", id).set("node", scene.nodes[scene.objects[id].node].path);
    json.set(viewpoint_world.is_orthographic ? "to_viewer_object" : "eye_object",
             exact_vector(in_object(viewpoint_world, scene.world_from_object(id)).eye));
    json.set("world_from_object", std::move(matrix));
    json.set("positions", std::move(positions)).set("faces", std::move(faces));
    return json;
}

JsonValue result_json(const SilhouetteResult& result)
{
    JsonValue json = JsonValue::object();
    json.set("faces", result.faces).set("edges", result.edges).set("creases", result.creases);
    json.set("candidates", result.candidates).set("silent", result.silent).set("borders", result.borders);
    json.set("silhouettes", result.silhouettes).set("drawn", result.drawn);
    return json;
}

/// An eye, or a direction of sight for a parallel projection: facing is decided by it alone.
Viewpoint viewpoint_of(const SilhouetteArguments& arguments)
{
    if (arguments.eye.empty() == arguments.direction.empty())
        throw Error({.what = arguments.eye.empty() ? "neither --eye nor --direction" : "both --eye and --direction",
                     .expected = "one of them"});
    if (!arguments.eye.empty()) return {parse_vector(arguments.eye, "--eye"), false};
    const glm::dvec3 direction = parse_vector(arguments.direction, "--direction");
    if (direction == glm::dvec3(0.0))
        throw Error({.what = "--direction " + arguments.direction, .expected = "a vector with a length"});
    return {-direction, true};
}

void find_silhouettes(const SilhouetteArguments& arguments)
{
    const Viewpoint viewpoint_world = viewpoint_of(arguments);
    if (!(arguments.crease_deg > 0.0 && arguments.crease_deg <= 180.0))
        throw Error({.what = fmt::format("--crease-deg {}", arguments.crease_deg), .expected = "above 0, at most 180"});
    const std::vector<OutputFile> outputs{{"--json", arguments.json}, {"--dump-mesh", arguments.dump_mesh}};
    require_outputs(outputs, {arguments.file});

    const Level level = read_level(arguments.file);
    const Scene scene = open_scene(level);
    require_unread(outputs);
    const SilhouetteOptions options{.crease_rad = static_cast<float>(arguments.crease_deg * std::numbers::pi / 180.0),
                                    .method = method_named(arguments.method)};
    SurfaceOptions defaults;
    if (options.method == SilhouetteMethod::hierarchy) defaults.cluster_from_faces = 1;
    SceneSurfaces surfaces(scene, defaults);
    SilhouetteResult result;
    SilhouetteScratch scratch;
    JsonValue meshes = JsonValue::array();
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const Surface& surface = surfaces.of(id);
        const bool is_all = arguments.method != "candidates";
        add_object({surface, scene.world_from_object(id), viewpoint_world, options, is_all}, scratch, result);
        if (!arguments.dump_mesh.empty()) meshes.push(mesh_json(scene, id, surface, viewpoint_world));
    }
    if (!arguments.json.empty()) write_json(arguments.json, result_json(result));
    if (!arguments.dump_mesh.empty())
        write_json(arguments.dump_mesh, JsonValue::object().set("objects", std::move(meshes)));
    print_line(
        fmt::format("{} faces, {} edges: {} creases, {} candidates, {} silent, {} borders; {} silhouettes, {} "
                    "drawn contours",
                    result.faces, result.edges, result.creases, result.candidates, result.silent, result.borders,
                    result.silhouette_count, result.drawn_count));
}

}  // namespace

void add_silhouettes_command(CommandLine app)
{
    auto arguments = std::make_shared<SilhouetteArguments>();
    CommandLine command =
        app.add_subcommand("silhouettes", "Finds the silhouette edges of a model as seen from an eye");
    command.add_option("level", arguments->file, "A bare model or a level").required().option_text("MODEL|LEVEL");
    command.add_option("--eye", arguments->eye, "The eye, world space, metres").option_text("X,Y,Z");
    command
        .add_option("--direction", arguments->direction,
                    "In place of an eye: the direction of sight of a parallel projection")
        .option_text("X,Y,Z");
    command
        .add_option("--method", arguments->method,
                    "brute (all edges), candidates (only edges that can be a contour), hierarchy (only clusters of "
                    "faces near the contour), auto (the fastest for each object); all are exact; auto")
        .check(one_of({"brute", "candidates", "hierarchy", "auto"}));
    command.add_option("--crease-deg", arguments->crease_deg, "Edges folded by more are creases; 40").option_text("F");
    command.add_option("--dump-mesh", arguments->dump_mesh, "Write welded positions, faces and eye of each object")
        .option_text("FILE.json");
    add_json_argument(command, arguments->json);
    command.callback([arguments] { find_silhouettes(*arguments); });
}

}  // namespace hw
