#include "hatchway/stage/stage.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/io/compiled/lightmap_file.hpp"
#include "hatchway/io/images/images.hpp"
#include "hatchway/stage/level_styles.hpp"
#include "hatchway/world/hidden_objects.hpp"
#include "hatchway/world/mirrors.hpp"

namespace hw {
namespace {

/// Whether the file lies in one of the folders or below, links followed: a folder may be named by one.
bool is_below(const std::filesystem::path& file, const std::vector<std::filesystem::path>& folders)
{
    std::error_code failed;
    const std::filesystem::path place = std::filesystem::weakly_canonical(file, failed);
    return std::ranges::any_of(folders, [&](const std::filesystem::path& folder) {
        const std::filesystem::path root = std::filesystem::weakly_canonical(folder, failed);
        return std::mismatch(root.begin(), root.end(), place.begin(), place.end()).first == root.end();
    });
}

}  // namespace

Stage::Stage(Context& context, StageOptions options)
    : options_(std::move(options)),
      plugins_({.folders = options_.plugin_dirs, .trial = options_.plugin_trial}),
      renderer_(context, read_image),
      styles_(plugins_,
              [this](const std::filesystem::path& folder) -> ProgramCache& { return renderer_.program_cache(folder); })
{
    styles_.set_object_namer([this](ObjectId object) {
        return shown_.world ? scene().nodes[scene().objects[object].node].path : std::string();
    });
    // Styles first: a wrong name in the level shows at once, not after the model has been loaded.
    Level level = read_level_with(options_.file, options_.style_overrides);
    styles_.set_level(level);
    shown_ = with_looks(opened(std::move(level)), {});
    load();
    compile_beside();
    watch_files();
}

Stage::~Stage() = default;

Stage::Shown Stage::opened(Level level) const
{
    Shown shown;
    shown.world = open_world(level, options_.baked_light);
    forget_unknown_styles(level, plugins_, shown.world->scene);
    for (const std::string& doubt : shown.world->scene.doubts) log_warning(doubt);
    const CompiledCache* cache = options_.cache ? &*options_.cache : nullptr;
    std::optional<CompiledLevel> compiled;
    if (options_.visibility_use == VisibilityUse::compiled)
        compiled = find_or_compile_world(level, *shown.world, options_.visibility, cache);
    else if (options_.visibility_use != VisibilityUse::none && cache != nullptr)
        compiled = find_compiled_world(level, *shown.world, options_.visibility, *cache);
    if (compiled)
        shown.made = {std::make_shared<Visibility>(std::move(compiled->visibility)), shown.world->hidden,
                      compiled->is_from_cache};
    shown.level = std::move(level);
    return shown;
}

void Stage::compile_beside()
{
    if (options_.visibility_use != VisibilityUse::in_background || visibility() || visibility_job_) return;
    // What is hidden for a while must not take the place of what the level says.
    const bool is_as_opened = hidden_objects(scene()) == shown_.world->hidden;
    visibility_job_ = std::make_unique<VisibilityJob>(shown_.level, shown_.world, options_.visibility,
                                                      is_as_opened ? options_.cache : std::nullopt);
}

const Visibility* Stage::visibility() const
{
    return shown_.made.hidden == hidden_objects(scene()) ? shown_.made.visibility.get() : nullptr;
}

bool Stage::follow_looks()
{
    LevelWorld& world = *shown_.world;
    if (!would_change(world.scene, shown_.looks)) return false;
    visibility_job_.reset();  // it reads the scene
    hide_objects(world.scene, shown_.looks);
    world.chunks.resize(world.scene.meshes.size());
    world.places = find_places(world.scene);
    return true;
}

void Stage::take_visibility()
{
    if (!visibility_job_ || !visibility_job_->is_done()) return;
    const std::unique_ptr<VisibilityJob> job = std::move(visibility_job_);
    try {
        shown_.made = {job->take(), hidden_objects(scene())};
        renderer_.set_visibility(visibility());
    } catch (const std::exception& error) {
        log_warning(std::string("no visibility, everything in the frustum is drawn: ") + error.what());
    }
}

std::string Stage::activity() const
{
    if (!visibility_job_) return {};
    return "Compiling what is seen from where, " + std::to_string(static_cast<int>(100 * visibility_job_->share())) +
           " %";
}

Stage::Shown Stage::with_looks(Shown shown, const std::vector<AssignRule>& extra_rules)
{
    Level with_extra = shown.level;
    with_extra.assign.insert(with_extra.assign.end(), extra_rules.begin(), extra_rules.end());
    require_maps(with_extra);
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
        const bool is_scene_changed = follow_looks();
        // Maps that a style brings on its first use reach the renderer by load() alone.
        if (has_new_looks_only && !is_scene_changed && named_maps() == named_maps_ &&
            maps_.maps().size() == loaded_map_count_)
            renderer_.set_looks(styles_.styles(), shown_.objects);
        else
            load();
    } catch (...) {
        std::swap(shown_, next);
        follow_looks();
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
    input.visibility = visibility();
    input.chunks = world.chunks;
    const bool is_as_baked = hidden_objects(world.scene) == world.hidden;
    input.lightmap = world.lightmap && is_as_baked ? &*world.lightmap : nullptr;
    input.named_maps = named_maps_ = named_maps();
    input.maps = maps_.maps();
    loaded_map_count_ = input.maps.size();
    input.lights = lights_of(shown_.level, world.scene);
    input.exposure_ev = static_cast<float>(exposure_ev_of(shown_.level, world.scene, input.lights));
    input.mirrors = find_mirrors(shown_.level, world.scene);
    input.mirror_depth = shown_.level.mirror_depth;
    if (shown_.level.background) input.background_srgb = *shown_.level.background;
    input.image_passes = styles_.image_passes();
    renderer_.load(std::move(input));
}

void Stage::set_extra_rules(std::vector<AssignRule> rules)
{
    show(with_looks({shown_.level, shown_.world, shown_.made, {}, {}}, rules), true);
    extra_rules_ = std::move(rules);
    compile_beside();
}

void Stage::watch_files()
{
    watched_.clear();
    for (const std::filesystem::path& file : files_read())
        if (const std::optional<Part> part = part_of(file)) watched_[file] = *part;
    // Files may be missing now, and found in a folder later.
    for (const std::filesystem::path& folder : maps_.folders()) watched_[folder] = Part::maps;
    for (const std::filesystem::path& folder : shader_folders()) watched_[folder] = Part::shaders;
    watched_[options_.file] = Part::level;
    watched_[shown_.level.scene_file] = Part::model;
    if (options_.baked_light == BakedLight::if_there) watched_[lightmap_path(options_.file)] = Part::model;
    std::vector<std::filesystem::path> paths;
    for (const auto& [path, part] : watched_) paths.push_back(path);
    watch_.watch(paths);
}

std::optional<Stage::Part> Stage::part_of(const std::filesystem::path& file_read) const
{
    if (is_below(file_read, {options_.file})) return Part::level;
    if (is_below(file_read, maps_.folders())) return Part::maps;
    if (is_below(file_read, shader_folders())) return Part::shaders;
    if (is_below(file_read, {lightmap_path(options_.file)})) return std::nullopt;  // watched only if it is wanted
    return is_below(file_read, {shown_.level.project_root}) ? std::optional(Part::model) : std::nullopt;
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
    take_visibility();
    std::set<Part> changed;
    for (const std::filesystem::path& path : watch_.changed()) changed.insert(watched_.at(path));
    if (changed.empty()) return Reload::nothing;

    const bool is_model_changed = changed.contains(Part::model);
    const bool is_look_changed = changed.contains(Part::shaders) || changed.contains(Part::maps);
    Reload result = is_look_changed ? Reload::looks : Reload::nothing;
    if (is_model_changed || changed.contains(Part::level)) result = std::max(result, reload_level(is_model_changed));
    if (changed.contains(Part::shaders)) reload_shaders();
    if (changed.contains(Part::maps)) reload_maps();
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
        Shown next =
            is_new_world ? opened(std::move(level)) : Shown{std::move(level), shown_.world, shown_.made, {}, {}};
        show(with_looks(std::move(next), extra_rules_), false);
        if (is_new_world) visibility_job_.reset();
        compile_beside();
        return is_new_world ? Reload::world : Reload::looks;
    } catch (const std::exception& error) {
        problems.emplace_back(error.what());
    }
    try {
        styles_.set_level(shown_.level);
    } catch (const std::exception& error) {
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
    } catch (const std::exception& error) {
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
