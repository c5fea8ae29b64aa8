#include "measure/hatching/inked_level.hpp"

#include "hatchway/core/files/files.hpp"
#include "hatchway/plugin_host/make_style.hpp"
#include "hatchway/render/view/camera_view.hpp"

namespace hw {
namespace {

constexpr int kOrdinary = 1 << 20;  // the number of the map that no store has

}  // namespace

InkedLevel::InkedLevel(Context& context, const std::filesystem::path& file)
    : renderer_(context),
      level_(read_level_with(file, {})),
      world_(open_world(level_, BakedLight::if_there)),
      looks_(resolve_looks(level_, world_->scene, kFallbackStyle))
{
    const int fine = maps_.use(level_, MapKind::hatch, "fine", "");
    ordinary_ = ordinary_levels(*maps_.maps()[fine]);
    for (const bool is_cost : {false, true}) {
        if (is_cost) add_ink("without hatching", "none", {}, true);
        add_ink("hatch map", "plain", {}, is_cost);
        add_ink("strokes", "shaded", {}, is_cost);
        add_ink("tonal map", "shaded", "strokes", is_cost);
        add_ink("ink map", "none", {}, is_cost).has_ink_maps = true;
    }
    add_probe("ordinary mips", LevelChoice::ordinary_mips, kOrdinary);
    add_probe(kUnfiltered, LevelChoice::no_mips, fine);
}

void InkedLevel::show(const InkKind& kind)
{
    SceneInput input;
    input.scene = &world_->scene;
    input.styles = {{kind.name, kind.style.get()}};
    for (const auto& [map_kind, name] : kind.style->needs().maps)
        if (!name.value.empty()) input.named_maps[{map_kind, name.value}] = maps_.use(level_, map_kind, name.value, "");
    for (const ObjectLook& look : looks_) {
        StyledObject object;
        object.style = 0;
        if (const auto ink = look.maps.find(MapKind::ink); kind.has_ink_maps && ink != look.maps.end())
            object.maps[MapKind::ink] = maps_.use(level_, MapKind::ink, ink->second, "/assign");
        if (kind.hatch_map >= 0) object.maps[MapKind::hatch] = kind.hatch_map;
        input.objects.push_back(std::move(object));
    }
    input.maps = maps_.maps();
    if (kind.hatch_map == kOrdinary)
        for (StyledObject& object : input.objects) object.maps[MapKind::hatch] = static_cast<int>(input.maps.size());
    input.maps.push_back(&ordinary_);
    input.chunks = world_->chunks;
    input.lightmap = world_->lightmap ? &*world_->lightmap : nullptr;
    input.lights = lights_of(level_, world_->scene);
    input.exposure_ev = static_cast<float>(exposure_ev_of(level_, world_->scene, input.lights));
    renderer_.load(std::move(input));
}

FrameStats InkedLevel::draw(const Camera& camera, glm::ivec2 size_px, int samples)
{
    const View view = camera_view(camera_place(camera), size_px, world_->scene.bounds_world);
    return renderer_.draw(view, {.samples = samples, .use_pvs = false, .is_timed = true});
}

InkPicture InkedLevel::picture(const Camera& camera, glm::ivec2 size_px)
{
    draw(camera, size_px, 1);
    const Pixels pixels = renderer_.read_picture();
    std::vector<std::vector<double>> columns;
    for (int x = 0; x < size_px.x; ++x) columns.push_back(column_ink(pixels, x));
    InkPicture ink{.width = size_px.x, .height = size_px.y, .ink = {}};
    for (int y = 0; y < size_px.y; ++y)
        for (int x = 0; x < size_px.x; ++x) ink.ink.push_back(static_cast<float>(columns[x][y]));
    return ink;
}

InkKind& InkedLevel::add_ink(const std::string& name, const std::string& tone, const std::string& tonal, bool has_lines)
{
    const StyleSource source{"measure coherence", ""};
    const Plugin& plugin = require_plugin(plugins_, "pen_and_ink", PluginKind::style, source);
    ParamSettings params;
    const auto set = [&](const char* key, ParamValue value) { params[key] = {std::move(value), key}; };
    set("tone", tone);
    set("hatch_colour", std::string("#000000"));
    if (!tonal.empty()) set("tonal", tonal);
    if (!has_lines)
        for (const char* width :
             {"line_width_px", "silhouette_width_px", "border_width_px", "valley_width_px", "intersection_width_px"})
            set(width, 0.0);
    InkKind kind{.name = name, .style = make_style(plugin, params, source), .is_cost = has_lines};
    kind.style->prepare(renderer_.program_cache(plugin.shader_folder));
    return kinds_.emplace_back(std::move(kind));
}

void InkedLevel::add_probe(const std::string& name, LevelChoice choice, int map)
{
    InkKind kind{.name = name, .style = make_probe_style(choice), .hatch_map = map};
    kind.style->prepare(renderer_.program_cache(installation_prefix() / "share" / "hatchway" / "shaders"));
    kinds_.push_back(std::move(kind));
}

}  // namespace hw
