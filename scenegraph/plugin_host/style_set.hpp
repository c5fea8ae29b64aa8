#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "hatchway/drawing/styled_object.hpp"
#include "hatchway/plugin_host/guarded_style.hpp"
#include "hatchway/plugin_host/make_style.hpp"
#include "hatchway/render/renderer.hpp"

namespace hw {

/// Gives the cache that prepares the shaders of one folder: Renderer::program_cache.
using ProgramSource = std::function<ProgramCache&(const std::filesystem::path& style_folder)>;

/// The prepared styles of a level, by name. An instance exists from its first use on; its place never changes.
class StyleSet {
 public:
    /// `registry` must outlive this. Throws hw::Error when the shared shaders do not compile.
    StyleSet(const PluginRegistry& registry, ProgramSource programs);

    /// Takes the named styles of a level. Instances in use whose plugin or parameters changed are made and prepared
    /// anew. Throws hw::Error for the first style that is wrong, used or not; everything then stays as it was. Needs
    /// may have changed: tell the renderer by set_looks().
    void set_level(const Level& level);

    /// The index into styles() of a style of the level, or of a plugin with its defaults. Prepares it on first use.
    /// Throws hw::Error that lists what there is; `pointer` says where the name stands.
    int use(const std::string& name, const std::string& pointer);

    /// What use() takes: the level's styles, then the plugins that no style of the level hides.
    std::vector<std::string> names() const;

    /// How messages call an object; until then they do not.
    void set_object_namer(ObjectNamer object_name) { object_name_ = std::move(object_name); }

    /// For SceneInput::styles. The pointers stay valid as long as the set lives.
    const std::vector<NamedStyle>& styles() const { return styles_; }

    /// Makes and prepares a fresh instance of every style in use, for shaders or maps that changed. A style that fails
    /// keeps its last good instance; its message is returned.
    std::vector<std::string> prepare_again();

    /// Why styles stopped drawing and image passes made nothing, one message for each that did.
    std::vector<std::string> failures() const;

    /// For SceneInput::image_passes. A pass that is missing or fails is logged and gives null. Valid as long as the
    /// set.
    ImagePassSource image_passes();

 private:
    struct Wanted {
        std::string plugin;
        ParamSettings params;
        StyleSource source;
    };
    struct Instance {
        std::string name;
        Wanted wanted;
        std::unique_ptr<GuardedStyle> style;
    };
    struct Change {
        std::size_t index = 0;
        Wanted wanted;
        std::unique_ptr<Style> style;
    };

    Wanted wanted(const std::string& name, const std::string& pointer) const;
    /// A fresh instance whose prepare() and needs() did not throw.
    std::unique_ptr<Style> prepared(const Wanted& wanted);
    std::vector<Change> changes_of_level();
    std::unique_ptr<ImagePass> image_pass(const ImageKey& key);

    const PluginRegistry& registry_;
    ProgramSource programs_;
    PlainStyle plain_;
    ObjectNamer object_name_;
    std::vector<std::string> image_failures_;
    std::map<std::string, StyleDesc> level_styles_;
    StyleSource level_;  ///< Its file and root.
    std::vector<Instance> instances_;
    std::vector<NamedStyle> styles_;
};

}  // namespace hw
