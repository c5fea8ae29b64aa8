#include "hatchway/io/level/file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "hatchway/io/level/schema.hpp"
#include "tests/io/expect_error.hpp"
#include "tests/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;

/// A project with a model and a level beside it.
class Project {
 public:
    Project()
    {
        folder_.write("project/models/hall.glb", "not opened");
        folder_.write("outside.glb", "not opened");
        fs::create_directories(folder_.path() / "project/levels");
    }
    fs::path write(const std::string& text, const std::string& name = "hall.level.json") const
    {
        return folder_.write("project/levels/" + name, text);
    }
    hw::Level read(const std::string& text) const { return hw::read_level(write(text)); }
    fs::path path() const { return fs::canonical(folder_.path() / "project"); }

 private:
    TemporaryFolder folder_;
};

/// A level with these keys beside the required ones.
std::string level_with(const std::string& keys)
{
    return R"({"format": "hatchway-level/1", "scene": "../models/hall.glb")" + (keys.empty() ? "" : ", " + keys) + "}";
}

hw::Level level_of(const std::string& keys)
{
    return Project().read(level_with(keys));
}

hw::ErrorParts error_of_level(const std::string& keys)
{
    const Project project;
    const fs::path file = project.write(level_with(keys));
    const hw::ErrorParts parts = error_of([&] { hw::read_level(file); });
    EXPECT_EQ(parts.file, file.string());
    EXPECT_FALSE(parts.what.empty());
    return parts;
}

}  // namespace

TEST(level_file, the_smallest_level_has_a_format_and_a_scene)
{
    const Project project;
    const hw::Level level = project.read(level_with(""));
    EXPECT_EQ(level.scene_file, project.path() / "models/hall.glb");
    EXPECT_EQ(fs::canonical(level.project_root), project.path());
    EXPECT_FALSE(level.start || level.exposure_ev || level.background || level.structure);
    EXPECT_TRUE(level.styles.empty() && level.assign.empty());
}

TEST(level_file, comments_are_allowed)
{
    EXPECT_NO_THROW(level_of("/* a */ \"exposure_ev\": 12 // b\n"));
}

TEST(level_file, every_key_is_read)
{
    const hw::Level level = level_of(R"(
        "$schema": "../level.schema.json",
        "start": {"position": [1, 2, 3], "look_at": [4, 5, 6]},
        "exposure_ev": 12.5,
        "background": "#ff8000",
        "sealed": true,
        "structure": ["Wall*", "Floor*"],
        "styles": {"assumed": {"plugin": "pen_and_ink", "crease_deg": 40, "shade": true, "paper": "#ffffff"}},
        "assign": [
            {"nodes": "*", "style": "assumed"},
            {"nodes": "#12", "materials": "Plank*", "maps": {"ink": "maps/ink/plank"}, "certainty": 0.4,
             "over": "photoreal", "collides": false, "visible": false,
             "presence": {"constant": 0.5, "height": {"from_m": 3, "to_m": 1}, "time": {"from_s": 1, "to_s": 2}}}
        ],
        "certainty_styles": [{"from": 0.5, "style": "assumed"}],
        "cameras": {"door": {"position": [0, 1.7, 8], "look_at": [0, 1.5, 0], "fov_deg": 75},
                    "plan": {"position": [0, 9, 0], "look_at": [0, 0, 0], "orthographic": {"height_m": 6}, "roll_deg": 30}},
        "paths": {"tour": {"fps": 30, "keys": [{"t_s": 0, "position": [0, 0, 0], "look_at": [1, 0, 0]},
                                               {"t_s": 2, "position": [1, 0, 0], "look_at": [2, 0, 0]}]}},
        "lights": [{"type": "sun", "direction": [0, -2, 0], "illuminance_lux": 50000, "colour": "#ff0000"},
                   {"type": "spot", "direction": [1, 0, 0], "position": [0, 3, 0], "intensity_cd": 100,
                    "inner_cone_deg": 30, "outer_cone_deg": 60, "range_m": 9}]
    )");
    EXPECT_EQ(level.start->look_at, glm::dvec3(4, 5, 6));
    EXPECT_EQ(level.exposure_ev, 12.5);
    EXPECT_EQ(level.background->y, 128.0f / 255.0f);
    EXPECT_TRUE(level.is_sealed);
    EXPECT_EQ(level.structure->at(1), "Floor*");
    const hw::StyleDesc& style = level.styles.at("assumed");
    EXPECT_EQ(style.plugin, "pen_and_ink");
    EXPECT_EQ(style.pointer, "/styles/assumed");
    EXPECT_EQ(std::get<double>(style.params.at("crease_deg").value), 40.0);
    EXPECT_EQ(style.params.at("crease_deg").pointer, "/styles/assumed/crease_deg");
    EXPECT_EQ(std::get<bool>(style.params.at("shade").value), true);
    EXPECT_EQ(style.params.count("plugin"), 0u);
    const hw::AssignRule& rule = level.assign.at(1);
    EXPECT_EQ(rule.pointer, "/assign/1");
    EXPECT_EQ(rule.nodes, "#12");
    EXPECT_EQ(rule.materials, "Plank*");
    EXPECT_EQ(rule.maps.at(hw::MapKind::ink), "maps/ink/plank");
    EXPECT_EQ(rule.maps.size(), 1u);
    EXPECT_FALSE(rule.style);
    EXPECT_EQ(rule.over, "photoreal");
    EXPECT_EQ(rule.certainty, 0.4);
    EXPECT_EQ(rule.collides, false);
    EXPECT_EQ(rule.visible, false);
    EXPECT_FALSE(level.assign.at(0).visible);
    EXPECT_EQ(rule.presence, (hw::PresenceField{0.5f, hw::Ramp{3.0f, 1.0f}, hw::Ramp{1.0f, 2.0f}}));
    EXPECT_FALSE(level.assign.at(0).presence || level.assign.at(0).certainty || level.assign.at(0).collides);
    EXPECT_EQ(level.certainty_styles.at(0).from, 0.5);
    EXPECT_EQ(level.cameras.at(0).name, "door");
    EXPECT_EQ(level.cameras.at(0).fov_deg, 75.0);
    EXPECT_FALSE(level.cameras.at(0).orthographic_height_m);
    EXPECT_EQ(level.cameras.at(1).orthographic_height_m, 6.0);
    EXPECT_EQ(level.cameras.at(0).roll_deg, 0.0);
    EXPECT_EQ(level.cameras.at(1).roll_deg, 30.0);
    EXPECT_EQ(level.paths.at(0).fps, 30.0);
    EXPECT_EQ(level.paths.at(0).keys.at(1).t_s, 2.0);
    EXPECT_EQ(level.lights.at(0).direction_world, glm::dvec3(0, -1, 0)) << "made unit";
    EXPECT_EQ(level.lights.at(0).colour, glm::vec3(1, 0, 0));
    EXPECT_EQ(level.lights.at(0).intensity, 50000.0f);
    EXPECT_EQ(level.lights.at(1).type, hw::LightType::spot);
    EXPECT_NEAR(level.lights.at(1).outer_cone_rad, 1.0471975, 1e-6);
    EXPECT_EQ(level.lights.at(1).range_m, 9.0f);
}

TEST(level_file, cameras_and_paths_keep_the_order_of_the_file)
{
    const auto camera = [](const std::string& name) {
        return '"' + name + R"(": {"position": [0, 0, 0], "look_at": [1, 0, 0]})";
    };
    const auto path = [](const std::string& name) {
        return '"' + name + R"(": {"keys": [{"t_s": 0, "position": [0, 0, 0], "look_at": [1, 0, 0]}]})";
    };
    const hw::Level level = level_of("\"cameras\": {" + camera("well") + ", /* \"no\": */ " + camera("\\u0061 b") +
                                     "," + camera("door") + "}, \"paths\": {" + path("z") + "," + path("a") + '}');
    ASSERT_EQ(level.cameras.size(), 3u);
    EXPECT_EQ(level.cameras[0].name, "well");
    EXPECT_EQ(level.cameras[1].name, "a b");
    EXPECT_EQ(level.cameras[2].name, "door");
    EXPECT_EQ(level.paths.at(0).name, "z");
    EXPECT_EQ(level.paths.at(1).name, "a");
}

TEST(level_file, an_unknown_key_is_named_with_those_that_exist)
{
    const auto parts = error_of_level(R"("assign": [{"nodes": "*", "styel": "x"}])");
    EXPECT_EQ(parts.pointer, "/assign/0/styel");
    EXPECT_THAT(parts.expected, testing::HasSubstr("nodes, materials, style, over"));
}

TEST(level_file, every_wrong_value_is_named_by_its_pointer)
{
    const std::pair<const char*, const char*> cases[] = {
        {R"("exposure_ev": "bright")", "/exposure_ev"},
        {R"("exposure_ev": 1000)", "/exposure_ev"},
        {R"("exposure_ev": null)", "/exposure_ev"},
        {R"("sealed": 1)", "/sealed"},
        {R"("background": "red")", "/background"},
        {R"("background": "#12345")", "/background"},
        {R"("structure": "Wall*")", "/structure"},
        {R"("structure": ["Wall*", 3])", "/structure/1"},
        {R"("start": {"position": [0, 0], "look_at": [1, 0, 0]})", "/start/position"},
        {R"("start": {"position": [0, "0", 0], "look_at": [1, 0, 0]})", "/start/position/1"},
        {R"("start": {"position": [0, 1e300, 0], "look_at": [1, 0, 0]})", "/start/position/1"},
        {R"("start": {"position": [0, 0, 0]})", "/start"},
        {R"("start": {"position": [0, 0, 0], "look_at": [0, 0, 0]})", "/start/look_at"},
        {R"("start": [])", "/start"},
        {R"("styles": [])", "/styles"},
        {R"("styles": {"": {"plugin": "ink"}})", "/styles"},
        {R"("styles": {"a/b": {}})", "/styles/a~1b"},
        {R"("styles": {"a": {"plugin": "../ink"}})", "/styles/a/plugin"},
        {R"("styles": {"a": {"plugin": "Ink"}})", "/styles/a/plugin"},
        {R"("styles": {"a": {"plugin": "ink", "width_px": [1]}})", "/styles/a/width_px"},
        {R"("assign": {})", "/assign"},
        {R"("assign": [7])", "/assign/0"},
        {R"("assign": [{"nodes": ""}])", "/assign/0/nodes"},
        {R"("assign": [{"certainty": 1.5}])", "/assign/0/certainty"},
        {R"("assign": [{"maps": {"inc": "a"}}])", "/assign/0/maps/inc"},
        {R"("assign": [{"presence": {"height": {"from_m": 1}}}])", "/assign/0/presence/height"},
        {R"("assign": [{"presence": {"constant": -1}}])", "/assign/0/presence/constant"},
        {R"("assign": [{"presence": {"constant": 1}}])", "/assign/0/presence"},
        {R"("certainty_styles": [{"from": 0.5}])", "/certainty_styles/0"},
        {R"("cameras": {"a": {"position": [0, 0, 0], "look_at": [1, 0, 0], "fov_deg": 0}})", "/cameras/a/fov_deg"},
        {R"("cameras": {"a": {"position": [0, 0, 0], "look_at": [1, 0, 0], "orthographic": {}}})",
         "/cameras/a/orthographic"},
        {R"("cameras": {"a": {"position": [0, 0, 0], "look_at": [1, 0, 0], "orthographic": {"height_m": 0}}})",
         "/cameras/a/orthographic/height_m"},
        {R"("cameras": {"a": {"position": [0, 0, 0], "look_at": [1, 0, 0], "orthographic": {"height_m": 6},
                              "fov_deg": 60}})",
         "/cameras/a/orthographic"},
        {R"("paths": {"a": {"keys": []}})", "/paths/a/keys"},
        {R"("paths": {"a": {"keys": [{"t_s": 1, "position": [0,0,0], "look_at": [1,0,0]},
                                     {"t_s": 1, "position": [0,0,0], "look_at": [1,0,0]}]}})",
         "/paths/a/keys/1/t_s"},
        {R"("lights": [{"type": "moon"}])", "/lights/0/type"},
        {R"("lights": [{"type": "sun", "direction": [0, -1, 0]}])", "/lights/0"},
        {R"("lights": [{"type": "sun", "direction": [0, 0, 0], "illuminance_lux": 1}])", "/lights/0/direction"},
        {R"("lights": [{"type": "sun", "direction": [0, 1, 0], "illuminance_lux": 1, "position": [0, 0, 0]}])",
         "/lights/0/position"},
        {R"("lights": [{"type": "point", "position": [0, 0, 0], "illuminance_lux": 1}])", "/lights/0/illuminance_lux"},
        {R"("lights": [{"type": "spot", "position": [0, 0, 0], "direction": [1, 0, 0], "intensity_cd": 1,
                        "inner_cone_deg": 50}])",
         "/lights/0/inner_cone_deg"},
        {R"("mirrors": {"nodes": "*"})", "/mirrors"},
        {R"("mirrors": [{"reflectance": 0.5}])", "/mirrors/0"},
        {R"("mirrors": [{"nodes": "*", "reflectance": 1.5}])", "/mirrors/0/reflectance"},
        {R"("mirrors": [{"nodes": "*", "tint": "red"}])", "/mirrors/0/tint"},
        {R"("mirrors": [{"nodes": "*", "colour": "#ffffff"}])", "/mirrors/0/colour"},
        {R"("mirror_depth": 0)", "/mirror_depth"},
        {R"("mirror_depth": 5)", "/mirror_depth"},
        {R"("mirror_depth": 1.5)", "/mirror_depth"},
        {R"("mirror_depth": "2")", "/mirror_depth"},
    };
    for (const auto& [keys, pointer] : cases) {
        SCOPED_TRACE(keys);
        const auto parts = error_of_level(keys);
        EXPECT_EQ(parts.pointer, pointer);
        EXPECT_FALSE(parts.expected.empty());
    }
}

TEST(level_file, mirrors_have_nodes_a_share_and_a_tint)
{
    EXPECT_EQ(level_of("").mirror_depth, 2);
    const hw::Level level = level_of(R"("mirror_depth": 4, "mirrors": [
        {"nodes": "Hall/Mirror_*"}, {"nodes": "#3", "reflectance": 0.25, "tint": "#ff0000"}])");
    EXPECT_EQ(level.mirror_depth, 4);
    ASSERT_EQ(level.mirrors.size(), 2u);
    EXPECT_EQ(level.mirrors[0].nodes, "Hall/Mirror_*");
    EXPECT_EQ(level.mirrors[0].reflectance, 0.9);
    EXPECT_EQ(level.mirrors[0].tint_linear, glm::vec3(1.0f));
    EXPECT_EQ(level.mirrors[1].pointer, "/mirrors/1");
    EXPECT_EQ(level.mirrors[1].reflectance, 0.25);
    EXPECT_EQ(level.mirrors[1].tint_linear, glm::vec3(1.0f, 0.0f, 0.0f));
}

TEST(level_file, a_style_that_is_like_another_has_its_plugin_and_what_it_does_not_state_itself)
{
    const hw::Level level = level_of(R"("styles": {
        "b": {"plugin": "pen_and_ink", "crease_deg": 40, "tone": "plain", "shade": 0.5},
        "a": {"like": "c", "tone": "shaded"},
        "c": {"like": "b", "crease_deg": 60, "hatch_deg": 90}})");
    const hw::StyleDesc& style = level.styles.at("a");
    EXPECT_EQ(style.plugin, "pen_and_ink");
    EXPECT_EQ(style.like, "c");
    EXPECT_EQ(style.pointer, "/styles/a");
    EXPECT_EQ(std::get<std::string>(style.params.at("tone").value), "shaded");
    EXPECT_EQ(std::get<double>(style.params.at("crease_deg").value), 60.0);
    EXPECT_EQ(style.params.at("crease_deg").pointer, "/styles/c/crease_deg");
    EXPECT_EQ(std::get<double>(style.params.at("shade").value), 0.5);
    EXPECT_EQ(style.params.at("shade").pointer, "/styles/b/shade");
    EXPECT_EQ(style.params.size(), 4u);
    EXPECT_EQ(level.styles.at("c").params.size(), 4u);
    EXPECT_EQ(level.styles.at("b").params.size(), 3u);
}

TEST(level_file, styles_that_are_like_each_other_in_a_circle_are_refused)
{
    const auto parts = error_of_level(R"("styles": {"a": {"like": "b"}, "b": {"like": "c"}, "c": {"like": "b"}})");
    EXPECT_EQ(parts.pointer, "/styles/c/like");
    EXPECT_THAT(parts.what, testing::HasSubstr("\"b\" is like itself"));
    EXPECT_EQ(error_of_level(R"("styles": {"a": {"like": "a"}})").pointer, "/styles/a/like");
}

TEST(level_file, a_style_is_like_a_style_of_this_level_and_names_no_plugin_beside)
{
    const auto unknown = error_of_level(R"("styles": {"a": {"like": "pen_and_ink"}, "b": {"plugin": "pen_and_ink"}})");
    EXPECT_EQ(unknown.pointer, "/styles/a/like");
    EXPECT_EQ(unknown.expected, "one of: a, b");
    const auto both = error_of_level(R"("styles": {"a": {"plugin": "ink", "like": "b"}, "b": {"plugin": "ink"}})");
    EXPECT_EQ(both.pointer, "/styles/a/like");
    EXPECT_EQ(both.expected, "either \"plugin\" or \"like\"");
    EXPECT_EQ(error_of_level(R"("styles": {"a": {"crease_deg": 40}})").pointer, "/styles/a");
}

TEST(level_file, a_chain_of_styles_may_have_sixteen_links)
{
    const auto chain = [](int links) {
        std::string styles = R"("styles": {"0": {"plugin": "ink"})";
        for (int i = 1; i < links; ++i) styles += fmt::format(R"(, "{}": {{"like": "{}"}})", i, i - 1);
        return styles + "}";
    };
    EXPECT_EQ(level_of(chain(16)).styles.at("15").plugin, "ink");
    EXPECT_THAT(error_of_level(chain(17)).what, testing::HasSubstr("chain of more than 16 styles"));
}

TEST(level_file, a_repeated_key_is_refused)
{
    const auto parts = error_of_level(R"("cameras": {"a": {}, "a": {}})");
    EXPECT_EQ(parts.pointer, "/cameras/a");
    EXPECT_THAT(parts.what, testing::HasSubstr("twice"));
}

TEST(level_file, text_that_is_no_json_is_refused_with_its_line)
{
    const Project project;
    const auto parts = error_of([&] { project.read("{\n  \"format\": \"hatchway-level/1\",\n  oops\n}"); });
    EXPECT_THAT(parts.what, testing::HasSubstr("line 3"));
    EXPECT_THAT(error_of([&] { project.read(""); }).what, testing::HasSubstr("no JSON"));
    EXPECT_EQ(error_of([&] { project.read("[]"); }).expected, "an object");
    EXPECT_THAT(error_of([&] { project.read(std::string(100'000, '[')); }).what, testing::HasSubstr("nested"));
}

TEST(level_file, format_and_scene_are_required)
{
    const Project project;
    EXPECT_THAT(error_of([&] { project.read("{}"); }).what, testing::HasSubstr("\"format\" is missing"));
    EXPECT_EQ(error_of([&] { project.read(R"({"format": "hatchway-level/2"})"); }).pointer, "/format");
    EXPECT_THAT(error_of([&] { project.read(R"({"format": "hatchway-level/1"})"); }).what,
                testing::HasSubstr("\"scene\" is missing"));
}

TEST(level_file, a_scene_outside_of_the_project_is_refused)
{
    const Project project;
    fs::create_symlink(project.path().parent_path() / "outside.glb", project.path() / "levels/link.glb");
    for (const std::string scene : {"../../outside.glb", "link.glb", "/etc/passwd", "missing.glb", "../models"}) {
        const auto parts =
            error_of([&] { project.read(R"({"format": "hatchway-level/1", "scene": ")" + scene + "\"}"); });
        EXPECT_EQ(parts.pointer, "/scene") << scene;
    }
}

TEST(level_file, the_project_is_what_a_marker_says)
{
    const TemporaryFolder folder;
    const fs::path root = folder.path();
    EXPECT_EQ(hw::find_project_root(root / "a/levels/x.json"), root / "a");
    EXPECT_EQ(hw::find_project_root(root / "a/rooms/x.json"), root / "a/rooms");
    folder.write("hatchway.project", "");
    EXPECT_EQ(hw::find_project_root(root / "a/levels/x.json"), root);
    fs::create_directories(root / "a/.git");
    EXPECT_EQ(hw::find_project_root(root / "a/levels/x.json"), root / "a") << "the nearest wins";
}

TEST(level_file, a_bare_model_opens_with_defaults)
{
    const TemporaryFolder folder;
    const fs::path file = folder.write("models/hall.GLB", "not opened");
    const hw::Level level = hw::read_level(file);
    EXPECT_EQ(level.scene_file, file);
    EXPECT_EQ(level.project_root, file.parent_path());
    EXPECT_TRUE(level.styles.empty());
}

TEST(level_file, what_is_no_file_is_refused_at_once)
{
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "folder.glb");
    fs::create_directories(folder.path() / "folder.json");
    ASSERT_EQ(::mkfifo((folder.path() / "pipe.json").c_str(), 0600), 0);
    ASSERT_EQ(::mkfifo((folder.path() / "pipe.glb").c_str(), 0600), 0);
    for (const char* name :
         {"missing.glb", "missing.json", "folder.glb", "folder.json", "pipe.json", "pipe.glb", "a.txt"})
        EXPECT_EQ(error_of([&] { hw::read_level(folder.path() / name); }).file, (folder.path() / name).string());
}

TEST(level_file, the_levels_of_the_project_can_be_read)
{
    const fs::path levels = fs::path(HATCHWAY_SOURCE_DIR) / "content/levels";
    int count = 0;
    for (const auto& entry : fs::directory_iterator(levels)) {
        if (entry.path().extension() != ".json") continue;
        EXPECT_NO_THROW(hw::read_level(entry.path())) << entry.path();
        ++count;
    }
    EXPECT_GT(count, 0);
}

namespace {

/// As much of JSON schema as level_schema() uses; tells whether `value` obeys `schema`.
bool obeys(const nlohmann::json& value, const nlohmann::json& schema)
{
    if (schema.contains("const") && value != schema.at("const")) return false;
    if (schema.contains("enum") && std::ranges::find(schema.at("enum"), value) == schema.at("enum").end()) return false;
    const std::string type = schema.value("type", "");
    if (type == "object" && !value.is_object()) return false;
    if (type == "array" && !value.is_array()) return false;
    if (type == "string" && !value.is_string()) return false;
    if (type == "boolean" && !value.is_boolean()) return false;
    if ((type == "number" || type == "integer") && !value.is_number()) return false;
    if (schema.contains("minimum") && value < schema.at("minimum")) return false;
    if (schema.contains("maximum") && value > schema.at("maximum")) return false;
    for (const auto& name : schema.value("required", nlohmann::json::array()))
        if (!value.contains(name)) return false;
    if (schema.contains("oneOf") &&
        std::ranges::count_if(schema.at("oneOf"), [&](const auto& one) { return obeys(value, one); }) != 1)
        return false;
    for (const auto& part : schema.value("allOf", nlohmann::json::array()))
        if (obeys(value, part.at("if")) && !obeys(value, part.at("then"))) return false;
    const nlohmann::json members = value.is_object() ? value : nlohmann::json::object();
    for (const auto& [name, member] : members.items()) {
        const auto properties = schema.value("properties", nlohmann::json::object());
        const auto others = schema.value("additionalProperties", nlohmann::json(true));
        if (properties.contains(name) && !obeys(member, properties.at(name))) return false;
        if (!properties.contains(name) && others == nlohmann::json(false)) return false;
        if (!properties.contains(name) && others.is_object() && !obeys(member, others)) return false;
    }
    if (value.is_array() && schema.contains("items"))
        for (const auto& element : value)
            if (!obeys(element, schema.at("items"))) return false;
    return true;
}

std::vector<hw::StyleSchema> two_plugins()
{
    return {{.name = "photoreal", .summary = "Photographs.", .params = {}},
            {.name = "pen_and_ink",
             .summary = "Ink.",
             .params = {{.name = "width_px",
                         .help = "How wide.",
                         .type = hw::ParamType::real,
                         .min = 0.1,
                         .max = 8.0,
                         .default_value = 1.5}}}};
}

}  // namespace

TEST(level_schema, says_what_the_reader_says)
{
    const auto schema = nlohmann::json::parse(hw::level_schema(two_plugins()));
    const std::pair<const char*, bool> cases[] = {
        {R"("exposure_ev": 12)", true},
        {R"("exposure_ev": 1000)", false},
        {R"("exposure": 12)", false},
        {R"("styles": {"a": {"plugin": "pen_and_ink", "width_px": 2}})", true},
        {R"("styles": {"a": {"plugin": "pen_and_ink"}, "b": {"like": "a", "width_px": 2}})", true},
        {R"("styles": {"a": {"plugin": "pen_and_ink"}, "b": {"like": "a", "plugin": "photoreal"}})", false},
        {R"("styles": {"a": {"width_px": 2}})", false},
        {R"("assign": [{"nodes": "*", "style": "a", "maps": {"ink": "x"}}])", true},
        {R"("assign": [{"node": "*"}])", false},
        {R"("cameras": {"a": {"position": [0, 0, 0], "look_at": [0, 0, 1]}})", true},
        {R"("cameras": {"a": {"position": [0, 0, 0]}})", false},
        {R"("lights": [{"type": "moon"}])", false},
    };
    for (const auto& [keys, is_right] : cases) {
        SCOPED_TRACE(keys);
        EXPECT_EQ(obeys(nlohmann::json::parse(level_with(keys)), schema), is_right);
        if (is_right)
            EXPECT_NO_THROW(level_of(keys));
        else
            error_of_level(keys);
    }
}

TEST(level_schema, knows_the_parameters_of_plugins)
{
    const auto schema = nlohmann::json::parse(hw::level_schema(two_plugins()));
    const auto level = [](const char* style) {
        return nlohmann::json::parse(level_with(std::string(R"("styles": {"a": )") + style + "}"));
    };
    EXPECT_FALSE(obeys(level(R"({"plugin": "pen_and_ink", "width_px": 80})"), schema));
    EXPECT_FALSE(obeys(level(R"({"plugin": "photoreal", "width_px": 2})"), schema));
    EXPECT_TRUE(obeys(level(R"({"plugin": "somebody_elses", "anything": 2})"), schema));
}

TEST(level_schema, collects_parameters_in_order_with_their_defaults)
{
    hw::SchemaCollector collector;
    float width = 1.5f;
    glm::vec3 colour(1.0f, 0.5f, 0.0f);
    enum class Tip { round, square } tip = Tip::square;
    const std::string_view names[] = {"round", "square"};
    collector.real({"width_px", "How wide."}, width, 0.1f, 8.0f);
    collector.colour({"ink", "Its colour."}, colour);
    collector.choice({"tip", "Its shape.", hw::ParamChange::rebuild}, tip, names);
    ASSERT_EQ(collector.params().size(), 3u);
    EXPECT_EQ(std::get<std::string>(collector.params()[1].default_value), "#ff8000");
    EXPECT_EQ(std::get<std::string>(collector.params()[2].default_value), "square");
    EXPECT_EQ(collector.params()[2].change, hw::ParamChange::rebuild);
}

TEST(level_file, a_missing_format_says_which_is_expected)
{
    const Project project;
    const fs::path file = project.write(R"({"scene": "../models/hall.glb"})");
    const auto parts = error_of([&] { hw::read_level(file); });
    EXPECT_EQ(parts.what, "the key \"format\" is missing");
    EXPECT_EQ(parts.expected, "\"hatchway-level/1\"");
}
