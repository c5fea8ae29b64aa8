#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/pixels.hpp"
#include "geometry/mesh_chunks.hpp"
#include "render/frame_stats.hpp"
#include "render/overlay.hpp"
#include "style/style.hpp"
#include "world/map_levels.hpp"

namespace hw {

class Context;
struct Lightmap;    // world/lightmap.hpp
struct Visibility;  // world/visibility.hpp

/// How one object is drawn. Indices point into SceneInput::styles and SceneInput::maps.
struct StyledObject {
    int style = kNone;       ///< kNone: the object is not drawn.
    int over = kNone;        ///< A second style, drawn over the first with `presence`.
    PresenceField presence;  ///< Of `over`; the first style keeps the rest.
    float certainty = 1.0f;
    std::map<MapKind, int> maps;
};

/// A prepared style. The owner keeps it alive while the renderer may draw with it.
struct NamedStyle {
    std::string name;
    Style* style = nullptr;
};

/// Makes, sets and prepares the image pass that a key names; null when there is none of that name.
using ImagePassSource = std::function<std::unique_ptr<ImagePass>(const ImageKey&)>;

/// Everything a level shows. Pointers stay the caller's and must live until the next load().
struct SceneInput {
    const Scene* scene = nullptr;
    std::vector<NamedStyle> styles;
    std::vector<StyledObject> objects;       ///< One for each of scene->objects.
    const Visibility* visibility = nullptr;  ///< Null: everything is visible.
    std::span<const MeshChunks> chunks;      ///< One for each mesh; empty: meshes are drawn whole.
    const Lightmap* lightmap = nullptr;      ///< Baked light; its stream has been added to the scene's meshes.
    std::vector<const MapLevels*> maps;      ///< What StyledObject::maps points at.
    std::map<std::string, int> named_maps;   ///< Needs::maps: a map's name -> index into `maps`.
    std::vector<Light> lights;
    float exposure_ev = 0.0f;  ///< EV 100; the picture is scaled by 1 / (1.2 * 2^EV).
    glm::vec3 background_srgb{1.0f};
    ImagePassSource image_passes;
};

enum class LinePath : unsigned char { automatic, native, quads };

/// How far the depth that lines are tested against lies behind the faces, as a polygon offset.
struct FaceOffset {
    float factor = 0.75f;
    float units = 4.0f;
};

struct FrameOptions {
    int samples = 4;  ///< 1 or 4.
    bool use_pvs = true;
    bool skips_hidden = true;  ///< Leaves objects unshaded that others hide, where that pays. Never changes a pixel.
    LinePath line_path = LinePath::automatic;
    FaceOffset line_offset;
    bool is_timed = false;  ///< Wait for the device after each phase, so that phases can be told apart.
    Overlay overlay;
};

/// Draws frames of one scene into a picture of its own. Needs its context to be current in every call.
class Renderer {
 public:
    explicit Renderer(Context& context);
    ~Renderer();

    /// The cache to prepare styles with. `style_folder` holds the style's own shaders.
    ProgramCache& program_cache(const std::filesystem::path& style_folder);
    /// Compiles all programs anew from their files. Throws hw::Error for the first that fails; each keeps its last good
    /// text.
    void reload_shaders();

    /// Takes a scene: uploads what its styles need. Throws hw::Error when the device cannot hold it.
    void load(SceneInput input);
    /// Changes the looks alone (a style swapped, an object's style cycled); meshes, textures and shadows stay.
    void set_looks(std::vector<NamedStyle> styles, std::vector<StyledObject> objects);

    /// Draws a frame. Deterministic: depends on the scene and these arguments alone. Never throws for a style's fault.
    FrameStats draw(const View& view, const FrameOptions& options);

    /// The last picture, RGB, sRGB, top row first.
    Pixels read_picture();
    /// Shows the last picture in the context's window, scaled to fit, and over it words in the window's own pixels:
    /// they stay sharp where the picture is drawn smaller, and are no part of it. `px_scale`: device pixels for a
    /// logical one.
    void present(const Overlay& overlay = {}, float px_scale = 1.0f);

 private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace hw
