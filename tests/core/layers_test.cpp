// Reads every #include line of the engine, the styles and the tools, and fails on one that looks upwards, that uses a
// third party outside of its one layer, or that shows a third party to another layer through a header.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {
namespace fs = std::filesystem;

const fs::path kRoot = HATCHWAY_SOURCE_DIR;

/// What each layer may include beside itself.
const std::map<std::string, std::set<std::string>> kAllowed{
    {"core", {}},
    {"param", {"core"}},
    {"geometry", {"core"}},
    {"world", {"core", "param", "geometry"}},
    {"maps", {"core", "param", "geometry"}},
    {"io", {"core", "param", "geometry", "world", "maps"}},
    {"gl", {"core"}},
    {"style", {"core", "param", "geometry", "world"}},
    {"drawing", {"core", "param", "geometry", "world", "maps", "style"}},
    {"render", {"core", "param", "geometry", "world", "maps", "style", "gl", "drawing"}},
    {"plugin_host", {"core", "param", "geometry", "world", "maps", "style", "gl", "drawing", "render"}},
    {"stage", {"core", "param", "geometry", "world", "maps", "io", "style", "gl", "drawing", "render", "plugin_host"}},
    {"walk",
     {"core", "param", "geometry", "world", "maps", "io", "style", "gl", "drawing", "render", "plugin_host", "stage"}},
};

/// The rooms of a layer and what each may include of the layer beside itself; "" is the layer's own folder. A layer
/// that is not named here has no rooms.
const std::map<std::string, std::map<std::string, std::set<std::string>>> kRooms{
    {"core", {{"", {}}, {"files", {""}}}},
    {"geometry",
     {{"", {}},
      {"exact", {""}},
      {"topology", {"", "exact"}},
      {"surface", {"", "exact", "topology"}},
      {"silhouettes", {"", "exact", "topology", "surface"}},
      {"hatching", {"", "exact", "topology", "surface"}},
      {"lines", {"", "exact", "topology", "surface", "silhouettes"}}}},
    {"world",
     {{"", {}},
      {"light", {""}},
      {"collision", {""}},
      {"visibility/tree", {""}},
      {"visibility/rows", {"", "visibility/tree"}},
      {"visibility", {"", "visibility/tree", "visibility/rows"}}}},
    {"io",
     {{"json", {}},
      {"images", {"json"}},
      {"drawings", {}},
      {"gltf/check", {"json"}},
      {"gltf", {"json", "images", "gltf/check"}},
      {"meshes", {"images"}},
      {"model", {"gltf", "meshes"}},
      {"level", {"json", "model"}},
      {"compiled", {"level"}}}},
    {"plugin_host", {{"trial", {}}, {"", {"trial"}}}},
    {"render",
     {{"view", {}},
      {"device", {"view"}},
      {"lines", {"view", "device"}},
      {"overlay", {"view", "device"}},
      {"products", {"view", "device", "lines"}},
      {"", {"view", "device", "lines", "overlay", "products"}}}},
};

/// Made by CMake: the hash over the headers that a style sees.
const std::string kMadeHeader = "hatchway/header_hash.hpp";

/// A third party and the files that may include it: of OpenMesh, JSON, tinygltf and FlatBuffers sources alone, no
/// header.
struct ThirdParty {
    std::string include_starts_with;
    std::regex allowed_in;
};
const std::vector<ThirdParty> kThirdParties{
    {"tiny_gltf", std::regex(R"(scenegraph/io/.*\.cpp)")},
    {"nlohmann/json.hpp", std::regex(R"(scenegraph/io/.*\.cpp|tests/.*)")},
    {"nlohmann/json_fwd.hpp", std::regex(R"(scenegraph/io/json/fwd\.hpp)")},
    {"flatbuffers/", std::regex(R"(scenegraph/io/.*\.cpp)")},
    {"compiled_level_generated.h", std::regex(R"(scenegraph/io/.*\.cpp)")},
    {"cairo", std::regex(R"(scenegraph/io/.*)")},
    {"png.h", std::regex(R"((scenegraph|tests)/io/.*)")},
    {"jpeglib.h", std::regex(R"((scenegraph|tests)/io/.*)")},
    {"OpenMesh/", std::regex(R"((scenegraph/io/meshes|editor_tools/measure|tests/measure)/.*\.cpp)")},
    {"GLFW/", std::regex(R"(scenegraph/gl/.*)")},
    {"EGL/", std::regex(R"(scenegraph/gl/.*)")},
    {"epoxy/", std::regex(R"(scenegraph/gl/.*)")},
    {"GL/", std::regex("none")},
    {"spdlog/", std::regex(R"(scenegraph/core/.*)")},
    {"dlfcn.h", std::regex(R"(scenegraph/(core|plugin_host)/.*|tests/.*)")},
    {"embree", std::regex(R"(scenegraph/world/.*|editor_tools/measure/.*|tests/.*)")},
    {"tbb/", std::regex(R"((scenegraph|tests)/.*)")},
    {"fmt/", std::regex(R"((scenegraph|editor_tools|tests)/.*)")},
    {"CLI/", std::regex(R"(editor_tools/program/command_line\.cpp)")},
    {"gmp", std::regex(R"(tests/.*|editor_tools/measure/.*)")},
};

struct Include {
    std::string file;  ///< Of the including file, relative to the source folder.
    std::string name;
    bool is_ours = false;  ///< In quotation marks.
};

std::vector<Include> includes_of(const fs::path& file)
{
    static const std::regex include_line(R"re(^\s*#\s*include\s*(["<])([^">]+)[">].*)re");
    std::vector<Include> found;
    std::ifstream stream(kRoot / file);
    std::smatch match;
    for (std::string line; std::getline(stream, line);)
        if (std::regex_match(line, match, include_line)) found.push_back({file.string(), match[2], match[1] == "\""});
    return found;
}

std::vector<Include> includes_below(const std::vector<std::string>& folders)
{
    static const std::set<std::string> extensions{".hpp", ".cpp", ".h"};
    std::vector<Include> found;
    for (const std::string& folder : folders) {
        if (!fs::exists(kRoot / folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
            if (!entry.is_regular_file() || !extensions.contains(entry.path().extension())) continue;
            const std::vector<Include> more = includes_of(fs::relative(entry.path(), kRoot));
            found.insert(found.end(), more.begin(), more.end());
        }
    }
    return found;
}

/// "world/scene.hpp" of "hatchway/world/scene.hpp"; empty for what is no header of the engine.
std::string path_in_engine(const std::string& include_name)
{
    static const std::string prefix = "hatchway/";
    return include_name.starts_with(prefix) ? include_name.substr(prefix.size()) : "";
}

/// What a style may see: style/style.hpp and everything that it includes.
std::set<std::string> style_headers()
{
    std::set<std::string> seen;
    std::vector<std::string> open{"hatchway/style/style.hpp"};
    while (!open.empty()) {
        const std::string header = open.back();
        open.pop_back();
        if (!seen.insert(header).second) continue;
        for (const Include& include : includes_of("scenegraph/" + path_in_engine(header)))
            if (include.is_ours) open.push_back(include.name);
    }
    return seen;
}

bool is_header(const std::string& file)
{
    return file.ends_with(".hpp") || file.ends_with(".h");
}

/// The standard library and GLM: what every header may show.
bool is_public_library(const std::string& name)
{
    return name.find('.') == std::string::npos || name.starts_with("glm/");
}

std::string first_folder(const std::string& path)
{
    return path.substr(0, path.find('/'));
}

/// Headers that show a third party, themselves or through another header: their own layer may include them, no other.
std::set<std::string> private_headers(const std::vector<Include>& includes)
{
    std::set<std::string> found;
    std::size_t known = 0;
    do {
        known = found.size();
        for (const Include& include : includes) {
            if (!is_header(include.file) || !include.file.starts_with("scenegraph/")) continue;
            const bool shows = include.is_ours ? found.contains(include.name) : !is_public_library(include.name);
            if (shows) found.insert("hatchway/" + include.file.substr(std::string("scenegraph/").size()));
        }
    } while (found.size() != known);
    return found;
}

/// "visibility/rows" of "world/visibility/rows/pvs.hpp".
std::string room_of(const std::string& file)
{
    const std::size_t layer_end = file.find('/');
    const std::size_t room_end = file.rfind('/');
    return room_end > layer_end ? file.substr(layer_end + 1, room_end - layer_end - 1) : "";
}

/// Why a room of a layer may not look into another; empty when it may.
std::string objection_of_rooms(const std::string& layer, const std::string& room, const std::string& other)
{
    if (room == other) return {};
    const auto rooms = kRooms.find(layer);
    if (rooms == kRooms.end()) return layer + " has no rooms";
    const auto found = rooms->second.find(room);
    if (found == rooms->second.end()) return layer + "/" + room + " is no room";
    return found->second.contains(other) ? "" : layer + "/" + room + " may not look at " + layer + "/" + other;
}

/// Why the include is forbidden; empty when it is allowed.
std::string objection_to(const Include& include, const std::set<std::string>& privates)
{
    const auto refuse = [&](const std::string& why) { return include.file + " includes " + include.name + ": " + why; };
    for (const ThirdParty& party : kThirdParties)
        if (include.name.starts_with(party.include_starts_with) && !std::regex_match(include.file, party.allowed_in))
            return refuse("that library stays in its place");

    const std::string top = first_folder(include.file);
    const std::string file = include.file.substr(top.size() + 1);
    const std::string layer = first_folder(file);
    const std::string other_file = path_in_engine(include.name);
    const std::string other = first_folder(other_file);
    if (include.is_ours && privates.contains(include.name) && (top != "scenegraph" || other != layer))
        return refuse("that header shows a third party, which is its own layer's affair");
    if (top == "npr_plugins" && include.is_ours) {
        static const std::set<std::string> seen = style_headers();
        const bool is_kit = include.name.starts_with("hatchway/kit/");
        if (!include.name.ends_with(".glsl") && !is_kit && !seen.contains(include.name))
            return refuse("a style sees style/style.hpp and what it includes, and the kit");
    }
    if (top != "scenegraph") return {};

    const auto allowed = kAllowed.find(layer);
    if (allowed == kAllowed.end()) return refuse(layer + " is no layer");
    if (include.is_ours) {
        if (include.name == kMadeHeader && layer == "style") return {};
        if (other_file.empty()) return refuse("the engine includes \"hatchway/...\" alone");
        if (other != layer && !allowed->second.contains(other)) return refuse(layer + " may not look at " + other);
        if (other == layer)
            if (const std::string why = objection_of_rooms(layer, room_of(file), room_of(other_file)); !why.empty())
                return refuse(why);
    }
    const bool touches_files = include.name.starts_with("hatchway/core/files/") || include.name == "fstream";
    if (touches_files && (layer == "geometry" || layer == "world" || layer == "maps"))
        return refuse(layer + " reads no files");
    return {};
}

std::string objections_below(const std::vector<std::string>& folders)
{
    const std::set<std::string> privates = private_headers(includes_below({"scenegraph"}));
    std::string all;
    for (const Include& include : includes_below(folders))
        if (const std::string objection = objection_to(include, privates); !objection.empty()) all += objection + '\n';
    return all;
}

/// The text of the files from which entry points are called by name.
std::string text_of(const fs::path& file)
{
    std::ifstream stream(kRoot / file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Types that a header defines in its outermost namespace: they begin a line.
std::vector<std::string> types_of(const std::string& text)
{
    static const std::regex type(R"((?:^|\n)(?:struct|class|enum class) (\w+)[^;\n]*\{)");
    std::vector<std::string> types;
    for (std::sregex_iterator found(text.begin(), text.end(), type), end; found != end; ++found)
        types.push_back((*found)[1]);
    return types;
}

/// Sources that nobody includes by name: a program's main(), a command that a list names, what makes a plugin.
bool is_entry_point(const fs::path& source)
{
    if (source.filename() == "main.cpp") return true;
    const std::string adder = "add_" + source.stem().string() + '(';
    for (const char* list : {"editor_tools/program/commands.hpp", "editor_tools/measure/measures.hpp"})
        if (source.string().starts_with("editor_tools/") && text_of(list).find(adder) != std::string::npos) return true;
    static const std::regex plugin(R"(\n(HW_STYLE|HW_IMAGE_PASS)\()");
    return source.string().starts_with("npr_plugins/") && std::regex_search(text_of(source), plugin);
}

std::string sources_without_header(const std::string& top)
{
    std::string orphans;
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / top)) {
        const fs::path source = fs::relative(entry.path(), kRoot);
        if (source.extension() != ".cpp" || is_entry_point(source)) continue;
        const std::string header = fs::path(source).replace_extension(".hpp").string();
        if (!fs::exists(kRoot / header)) orphans += source.string() + " has no header of its name\n";
    }
    return orphans;
}

}  // namespace

TEST(layers, no_file_of_the_engine_looks_upwards)
{
    EXPECT_EQ(objections_below({"scenegraph"}), "");
}

TEST(layers, styles_see_the_style_interface_only)
{
    EXPECT_EQ(objections_below({"npr_plugins"}), "");
}

TEST(layers, tools_and_tests_leave_third_parties_in_their_places)
{
    EXPECT_EQ(objections_below({"editor_tools", "tests"}), "");
}

TEST(layers, the_check_reads_includes_at_all)
{
    const std::vector<Include> found = includes_below({"scenegraph"});
    EXPECT_GT(found.size(), 100u);
    EXPECT_TRUE(std::any_of(found.begin(), found.end(), [](const Include& include) { return include.is_ours; }));
    EXPECT_TRUE(style_headers().contains("hatchway/param/param_visitor.hpp"));
}

TEST(layers, no_folder_holds_more_than_sixteen_concepts)
{
    // Inputs of fuzzers, and what measurements wrote.
    const auto is_data = [](const fs::path& file) {
        return file.parent_path().parent_path().filename() == "corpus" || file.parent_path().filename() == "results";
    };
    for (const std::string top : {"scenegraph", "npr_plugins", "editor_tools", "tests", "docs", "content/source"}) {
        std::map<std::string, std::set<std::string>> concepts;
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / top))
            if (entry.is_regular_file() && entry.path().filename() != "CMakeLists.txt" && !is_data(entry.path()))
                concepts[fs::relative(entry.path().parent_path(), kRoot).string()].insert(entry.path().stem().string());
        EXPECT_FALSE(concepts.empty()) << top;
        for (const auto& [folder, names] : concepts) EXPECT_LE(names.size(), 16u) << folder;
    }
}

TEST(layers, every_source_has_the_header_of_its_name)
{
    for (const char* top : {"scenegraph", "editor_tools", "npr_plugins"}) EXPECT_EQ(sources_without_header(top), "");
}

TEST(layers, types_are_found_in_the_text_of_a_header)
{
    EXPECT_EQ(
        types_of("struct A {\n    struct Inner {};\n};\nstruct B;\nclass C final : public A {\nenum class D : int {"),
        (std::vector<std::string>{"A", "C", "D"}));
}

// Two types of one name in one namespace are one to the linker, whichever it takes, without a word.
TEST(layers, no_two_headers_define_a_type_of_the_same_name)
{
    std::map<std::string, fs::path> homes;
    for (const char* top : {"scenegraph", "editor_tools"}) {
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / top)) {
            if (entry.path().extension() != ".hpp") continue;
            for (const std::string& type : types_of(text_of(entry.path()))) {
                const auto [home, is_new] = homes.emplace(type, entry.path());
                EXPECT_TRUE(is_new) << type << ": " << home->second << " and " << entry.path();
            }
        }
    }
    EXPECT_GT(homes.size(), 200u);
}

TEST(layers, only_commands_that_a_list_names_and_plugins_are_entry_points)
{
    EXPECT_TRUE(is_entry_point("editor_tools/program/pictures/walk_command.cpp"));
    EXPECT_TRUE(is_entry_point("editor_tools/measure/lines/measure_lines.cpp"));
    EXPECT_TRUE(is_entry_point("npr_plugins/hybrid/hybrid.cpp"));
    EXPECT_FALSE(is_entry_point("editor_tools/program/pictures/run_command.cpp"));
    EXPECT_FALSE(is_entry_point("scenegraph/io/walk_command.cpp"));
    EXPECT_FALSE(is_entry_point("npr_plugins/CMakeLists.txt"));
}

TEST(layers, files_are_written_and_results_printed_in_one_place)
{
    // Words that stand for a second way: of writing a file, of walking a tree, of printing a name from a file.
    static const std::regex forbidden(
        R"(std::ofstream|std::fstream|\bfopen\(|create_director|std::filesystem::rename|\bfs::rename|copy_file|)"
        R"(recursive_directory_iterator|std::cout|std::cerr|fmt::print|\bprintf\(|\bfputs\(|\bfprintf\(|\bputs\()");
    std::string found;
    int count = 0;
    for (const std::string top : {"scenegraph", "npr_plugins", "editor_tools"})
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / top)) {
            const std::string name = fs::relative(entry.path(), kRoot).string();
            const std::string extension = entry.path().extension().string();
            if (!entry.is_regular_file() || (extension != ".cpp" && extension != ".hpp")) continue;
            if (name.starts_with("scenegraph/core/")) continue;
            ++count;
            std::ifstream stream(entry.path());
            std::smatch match;
            for (std::string line; std::getline(stream, line);)
                if (std::regex_search(line, match, forbidden)) found += name + ": " + match.str() + '\n';
        }
    EXPECT_EQ(found, "");
    EXPECT_GT(count, 200);
}

TEST(layers, each_forbidden_include_is_refused)
{
    const std::set<std::string> privates{"hatchway/io/json/text.hpp", "hatchway/gl/gl_api.hpp"};
    const std::vector<Include> forbidden{
        {"scenegraph/world/visibility/tree/bsp.cpp", "hatchway/io/level/file.hpp", true},
        {"scenegraph/style/pass.hpp", "hatchway/render/renderer.hpp", true},
        {"scenegraph/gl/context.hpp", "hatchway/world/scene.hpp", true},
        {"scenegraph/render/renderer.cpp", "epoxy/gl.h", false},
        {"scenegraph/render/renderer.cpp", "hatchway/gl/gl_api.hpp", true},
        {"scenegraph/io/meshes/raw_mesh.hpp", "OpenMesh/Core/IO/reader/PLYReader.hh", false},
        {"editor_tools/measure/silhouettes/half_edge_mesh.hpp", "OpenMesh/Core/Mesh/Traits.hh", false},
        {"scenegraph/io/level/reader.hpp", "nlohmann/json.hpp", false},
        {"scenegraph/io/level/reader.hpp", "nlohmann/json_fwd.hpp", false},
        {"scenegraph/io/gltf/model.hpp", "tiny_gltf.h", false},
        {"scenegraph/io/compiled/read.hpp", "flatbuffers/flatbuffers.h", false},
        {"scenegraph/io/compiled/read.hpp", "compiled_level_generated.h", true},
        {"scenegraph/io/gltf/import.cpp", "OpenMesh/Core/IO/reader/PLYReader.hh", false},
        {"scenegraph/io/meshes/import.cpp", "hatchway/io/level/file.hpp", true},
        {"scenegraph/stage/stage.cpp", "hatchway/io/json/text.hpp", true},
        {"scenegraph/stage/stage.cpp", "nlohmann/json.hpp", false},
        {"scenegraph/stage/stage.cpp", "hatchway/walk/player.hpp", true},
        {"scenegraph/world/light/lightmap.cpp", "hatchway/core/files/files.hpp", true},
        {"scenegraph/extra/a.cpp", "hatchway/core/box.hpp", true},
        {"scenegraph/world/visibility/visibility.cpp", "hatchway/world/light/lightmap.hpp", true},
        {"scenegraph/world/scene.cpp", "hatchway/world/visibility/visibility.hpp", true},
        {"scenegraph/world/visibility/tree/bsp.cpp", "hatchway/world/visibility/rows/pvs.hpp", true},
        {"scenegraph/geometry/surface/weld.cpp", "hatchway/geometry/lines/seams.hpp", true},
        {"scenegraph/geometry/hidden/weld.cpp", "hatchway/geometry/mesh_data.hpp", true},
        {"scenegraph/render/lines/line_drawer.cpp", "hatchway/render/renderer.hpp", true},
        {"scenegraph/drawing/line_looks.cpp", "hatchway/plugin_host/style_set.hpp", true},
        {"scenegraph/world/scene.cpp", "world/scene.hpp", true},
        {"npr_plugins/hybrid/hybrid.cpp", "hatchway/gl/context.hpp", true},
        {"npr_plugins/kit/ink_look.hpp", "hatchway/render/renderer.hpp", true},
        {"scenegraph/render/renderer.cpp", "hatchway/kit/ink_look.hpp", true},
        {"scenegraph/core/log.cpp", "hatchway/header_hash.hpp", true},
        {"npr_plugins/hybrid/hybrid.cpp", "GLFW/glfw3.h", false},
        {"editor_tools/program/main.cpp", "nlohmann/json.hpp", false},
        {"editor_tools/program/main.cpp", "hatchway/io/json/text.hpp", true},
    };
    for (const Include& include : forbidden)
        EXPECT_NE(objection_to(include, privates), "") << include.file << ' ' << include.name;
}

TEST(layers, each_allowed_include_is_accepted)
{
    const std::set<std::string> privates{"hatchway/io/json/text.hpp", "hatchway/gl/gl_api.hpp"};
    const std::vector<Include> allowed{
        {"scenegraph/io/level/file.cpp", "nlohmann/json.hpp", false},
        {"scenegraph/io/json/fwd.hpp", "nlohmann/json_fwd.hpp", false},
        {"scenegraph/io/meshes/raw_mesh.cpp", "OpenMesh/Core/IO/reader/PLYReader.hh", false},
        {"scenegraph/io/level/file.cpp", "hatchway/io/json/text.hpp", true},
        {"scenegraph/gl/window.cpp", "GLFW/glfw3.h", false},
        {"scenegraph/gl/gpu_buffer.cpp", "hatchway/gl/gl_api.hpp", true},
        {"scenegraph/stage/stage.cpp", "hatchway/io/level/file.hpp", true},
        {"scenegraph/world/visibility/rows/pvs.cpp", "hatchway/world/visibility/tree/bsp.hpp", true},
        {"scenegraph/render/renderer.hpp", "hatchway/style/style.hpp", true},
        {"npr_plugins/hybrid/hybrid.cpp", "hatchway/style/style.hpp", true},
        {"npr_plugins/hybrid/hybrid.cpp", "hatchway/kit/ink_look.hpp", true},
        {"editor_tools/program/command_line.cpp", "CLI/CLI.hpp", false},
    };
    for (const Include& include : allowed) EXPECT_EQ(objection_to(include, privates), "");
}

TEST(layers, a_header_that_shows_a_third_party_is_private_and_so_is_one_that_includes_it)
{
    const std::vector<Include> includes{{"scenegraph/io/text.hpp", "nlohmann/json.hpp", false},
                                        {"scenegraph/io/reader.hpp", "hatchway/io/text.hpp", true},
                                        {"scenegraph/io/open.hpp", "glm/vec3.hpp", false},
                                        {"scenegraph/io/open.cpp", "hatchway/io/text.hpp", true}};
    EXPECT_EQ(private_headers(includes), (std::set<std::string>{"hatchway/io/text.hpp", "hatchway/io/reader.hpp"}));
}
