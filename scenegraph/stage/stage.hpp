#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hatchway/plugin_host/style_set.hpp"
#include "hatchway/render/renderer.hpp"
#include "hatchway/stage/file_watch.hpp"
#include "hatchway/stage/level_world.hpp"
#include "hatchway/stage/map_store.hpp"
#include "hatchway/stage/visibility_job.hpp"
#include "hatchway/world/looks.hpp"

namespace hw {

class Context;

enum class VisibilityUse : unsigned char {
    none,           ///< Everything in the frustum is drawn.
    where_kept,     ///< As `none` where the cache holds no compiled level that fits.
    compiled,       ///< Opening waits until it is compiled.
    in_background,  ///< As `none` until it is compiled beside the drawing. Pictures are the same.
};

struct StageOptions {
    std::filesystem::path file;                      ///< A level file or a bare model.
    std::vector<std::string> style_overrides;        ///< "GLOB=STYLE", stronger than the level's own rules.
    std::vector<std::filesystem::path> plugin_dirs;  ///< Searched beside the installation.
    Trial plugin_trial = Trial::if_new;
    VisibilityUse visibility_use = VisibilityUse::compiled;
    VisibilityOptions visibility;
    BakedLight baked_light = BakedLight::if_there;
    std::optional<CompiledCache> cache;  ///< Absent: the visibility is compiled at every start and not kept.
};

/// What a reload changed.
enum class Reload : unsigned char { nothing, looks, world };

/// An opened level with its styles and maps in a renderer: everything that drawing needs. The context must be current
/// in every call and outlive the stage.
class Stage {
 public:
    /// Opens the level. Throws hw::Error for anything wrong with the level, its model, styles, plugins, maps or
    /// shaders.
    Stage(Context& context, StageOptions options);
    ~Stage();

    FrameStats draw(const View& view, const FrameOptions& options) { return renderer_.draw(view, options); }
    Renderer& renderer() { return renderer_; }
    const Renderer& renderer() const { return renderer_; }

    const Level& level() const { return shown_.level; }
    const LevelWorld& world() const { return *shown_.world; }
    const Scene& scene() const { return shown_.world->scene; }
    const std::vector<MeshChunks>& chunks() const { return shown_.world->chunks; }
    /// Null while there is none, or one that was made when other objects were hidden.
    const Visibility* visibility() const;
    /// Whether visibility() is that of a compiled level that was kept.
    bool is_compiled_level_used() const { return visibility() != nullptr && shown_.made.is_from_cache; }
    const std::vector<ObjectLook>& looks() const { return shown_.looks; }
    const PluginRegistry& plugins() const { return plugins_; }
    /// What an object may be styled with: the level's styles, then plugins with their defaults.
    std::vector<std::string> style_names() const { return styles_.names(); }

    /// Rules after all others, for looks that are tried out and not saved yet; replaces the last such rules. Throws
    /// hw::Error, and leaves everything as it was, when a rule names a style or map that does not work.
    void set_extra_rules(std::vector<AssignRule> rules);

    /// Takes up what was prepared beside the drawing, and what changed on disk: level, model, maps, shaders. Looks
    /// about four times a second, else returns at once. On an error the last good state stays, messages() tells, and
    /// watching goes on.
    Reload reload_changed();

    /// What is prepared beside the drawing, in words; empty: nothing.
    std::string activity() const;

    /// What is wrong now: of the last reload, and of styles that stopped drawing. Empty when all is well.
    std::vector<std::string> messages() const;
    /// Of these, the styles and image passes that stopped drawing.
    std::vector<std::string> style_failures() const { return styles_.failures(); }

 private:
    /// What a file on disk is to the level.
    enum class Part : unsigned char { level, model, maps, shaders };

    struct MadeVisibility {
        std::shared_ptr<const Visibility> visibility;
        std::vector<ObjectId> hidden;  ///< When it was made.
        bool is_from_cache = false;
    };

    /// What the renderer shows.
    struct Shown {
        Level level;
        std::shared_ptr<LevelWorld> world;  ///< Its scene is without what `looks` hide.
        MadeVisibility made;
        std::vector<ObjectLook> looks;
        std::vector<StyledObject> objects;
    };

    /// The level's world and visibility, without looks.
    Shown opened(Level level) const;
    Shown with_looks(Shown shown, const std::vector<AssignRule>& extra_rules);
    /// Compiles the visibility of the scene as it is now, where that is done beside and there is none.
    void compile_beside();
    /// Hides in the shown world what the shown looks hide. Tells whether that changed anything.
    bool follow_looks();
    void take_visibility();
    /// Reads every map that the level names, also where no object uses it, so that a wrong one is told with its place.
    void require_maps(const Level& level);
    NamedMaps named_maps();
    void show(Shown next, bool has_new_looks_only);
    void load();
    void watch_files();
    std::optional<Part> part_of(const std::filesystem::path& file_read) const;
    std::vector<std::filesystem::path> shader_folders() const;
    Reload reload_level(bool is_model_changed);
    void reload_maps();
    void reload_shaders();

    StageOptions options_;
    PluginRegistry plugins_;
    Renderer renderer_;
    StyleSet styles_;
    MapStore maps_;
    Shown shown_;
    NamedMaps named_maps_;  ///< What load() gave to the renderer.
    std::size_t loaded_map_count_ = 0;
    std::vector<AssignRule> extra_rules_;
    std::unique_ptr<VisibilityJob> visibility_job_;  ///< While one runs.
    FileWatch watch_;
    std::map<std::filesystem::path, Part> watched_;
    std::map<Part, std::vector<std::string>> problems_;
};

}  // namespace hw
