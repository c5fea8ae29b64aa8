#include "hatchway/stage/stage.hpp"

#include <algorithm>
#include <utility>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/io/compiled/lightmap_file.hpp"
#include "hatchway/stage/level_styles.hpp"

namespace hw {
namespace {

bool have_common(const std::vector<std::filesystem::path>& paths, const std::vector<std::filesystem::path>& others)
{
    return std::any_of(paths.begin(), paths.end(), [&](const std::filesystem::path& path) {
        return std::find(others.begin(), others.end(), path) != others.end();
    });
}

}  // namespace

Stage::Stage(Context& context, StageOptions options)
    : options_(std::move(options)),
      plugins_({.folders = options_.plugin_dirs}),
      renderer_(context),
      styles_(plugins_,
              [this](const std::filesystem::path& folder) -> ProgramCache& { return renderer_.program_cache(folder); })
{
    // Styles first: a wrong name in the level shows at once, not after the model has been loaded.
    Level level = read_level_with(options_.file, options_.style_overrides);
    styles_.set_level(level);
    auto world = world_of(level);
    shown_ = with_looks(std::move(level), std::move(world), {});
    load();
    watch_files();
}

Stage::~Stage() = default;

std::shared_ptr<const LevelWorld> Stage::world_of(const Level& level) const
{
    return open_world(level, options_.has_visibility ? &options_.visibility : nullptr, options_.baked_light,
                      options_.cache ? &*options_.cache : nullptr);
}

Stage::Shown Stage::with_looks(Level level, std::shared_ptr<const LevelWorld> world,
                               const std::vector<AssignRule>& extra_rules)
{
    Level with_extra = level;
    with_extra.assign.insert(with_extra.assign.end(), extra_rules.begin(), extra_rules.end());
    require_maps(with_extra);
    Shown shown{std::move(level), std::move(world), {}, {}};
    shown.looks = resolve_looks(with_extra, shown.world->scene, kFallbackStyle);
    shown.objects = styled_objects(shown.looks, styles_);
    for (ObjectId id = 0; id < shown.objects.size(); ++id) {
        for (const auto& [kind, name] : shown.looks[id].maps)
            shown.objects[id].maps[kind] = maps_.use(shown.level, kind, name, "/assign");  // known: required above
    }
    return shown;
}

void Stage::require_maps(const Level& level)
{
    for (const AssignRule& rule : level.assign)
        for (const auto& [kind, name] : rule.maps)
            maps_.use(level, kind, name, place_in(rule, "maps/" + std::string(facts_of(kind).name)));
    for (const StatedMap& map : maps_of_styles(plugins_, level)) maps_.use(level, map.kind, map.name, map.pointer);
}

NamedMaps Stage::named_maps()
{
    NamedMaps named;
    for (const NamedStyle& style : styles_.styles())
        for (const auto& [kind, name] : style.style->needs().maps)
            if (!name.value.empty())
                named[{kind, name.value}] = maps_.use(shown_.level, kind, name.value, "/styles/" + style.name);
    return named;
}

void Stage::show(Shown next, bool has_new_looks_only)
{
    // The renderer points into what it shows until the next load(): both live until that succeeded.
    std::swap(shown_, next);
    try {
        // Maps that a style brings on its first use reach the renderer by load() alone.
        if (has_new_looks_only && named_maps() == named_maps_ && maps_.maps().size() == loaded_map_count_)
            renderer_.set_looks(styles_.styles(), shown_.objects);
        else
            load();
    } catch (...) {
        std::swap(shown_, next);
        load();
        throw;
    }
}

void Stage::load()
{
    const LevelWorld& world = *shown_.world;
    SceneInput input;
    input.scene = &world.scene;
    input.styles = styles_.styles();
    input.objects = shown_.objects;
    input.visibility = world.visibility.get();
    input.chunks = world.chunks;
    input.lightmap = world.lightmap ? &*world.lightmap : nullptr;
    input.named_maps = named_maps_ = named_maps();
    input.maps = maps_.maps();
    loaded_map_count_ = input.maps.size();
    input.lights = lights_of(shown_.level, world.scene);
    input.exposure_ev = static_cast<float>(exposure_ev_of(shown_.level, world.scene, input.lights));
    if (shown_.level.background) input.background_srgb = *shown_.level.background;
    input.image_passes = styles_.image_passes();
    renderer_.load(std::move(input));
}

void Stage::set_extra_rules(std::vector<AssignRule> rules)
{
    show(with_looks(shown_.level, shown_.world, rules), true);
    extra_rules_ = std::move(rules);
}

void Stage::watch_files()
{
    std::vector<std::filesystem::path> paths = maps_.folders();
    paths.push_back(options_.file);
    paths.push_back(shown_.level.scene_file);
    if (options_.baked_light == BakedLight::if_there) paths.push_back(lightmap_path(options_.file));
    for (const std::filesystem::path& folder : shader_folders()) paths.push_back(folder);
    watch_.watch(paths);
}

std::vector<std::filesystem::path> Stage::shader_folders() const
{
    const std::filesystem::path share = installation_prefix() / "share" / "hatchway";
    std::vector<std::filesystem::path> folders{share / "shaders", share / "kit"};
    for (const Plugin& plugin : plugins_.plugins()) folders.push_back(plugin.shader_folder);
    return folders;
}

Reload Stage::reload_changed()
{
    const std::vector<std::filesystem::path> changed = watch_.changed();
    if (changed.empty()) return Reload::nothing;

    const bool is_model_changed = have_common(changed, {shown_.level.scene_file, lightmap_path(options_.file)});
    const bool is_level_changed = is_model_changed || have_common(changed, {options_.file});
    Reload result = is_level_changed ? reload_level(is_model_changed) : Reload::looks;
    if (have_common(changed, shader_folders())) reload_shaders();
    if (have_common(changed, maps_.folders())) reload_maps();
    watch_files();
    return result;
}

Reload Stage::reload_level(bool is_model_changed)
{
    std::vector<std::string>& problems = problems_[Part::level];
    problems.clear();
    try {
        Level level = read_level_with(options_.file, options_.style_overrides);
        styles_.set_level(level);
        const bool is_new_world = is_model_changed || !same_world(shown_.level, level);
        auto world = is_new_world ? world_of(level) : shown_.world;
        show(with_looks(std::move(level), std::move(world), extra_rules_), false);
        return is_new_world ? Reload::world : Reload::looks;
    } catch (const Error& error) {
        problems.emplace_back(error.what());
    }
    try {
        styles_.set_level(shown_.level);
    } catch (const Error& error) {
        problems.emplace_back(error.what());
    }
    return Reload::nothing;
}

void Stage::reload_shaders()
{
    std::vector<std::string>& problems = problems_[Part::shaders];
    problems.clear();
    try {
        renderer_.reload_shaders();
    } catch (const Error& error) {
        problems.emplace_back(error.what());
    }
    const std::vector<std::string> failed = styles_.prepare_again();
    problems.insert(problems.end(), failed.begin(), failed.end());
    renderer_.set_looks(styles_.styles(), shown_.objects);
}

void Stage::reload_maps()
{
    problems_[Part::maps] = maps_.read_again();
    load();
}

std::vector<std::string> Stage::messages() const
{
    std::vector<std::string> result;
    for (const auto& [part, texts] : problems_) result.insert(result.end(), texts.begin(), texts.end());
    const std::vector<std::string> failures = styles_.failures();
    result.insert(result.end(), failures.begin(), failures.end());
    return result;
}

}  // namespace hw
