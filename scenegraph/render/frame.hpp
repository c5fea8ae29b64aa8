#pragma once

#include <map>
#include <optional>
#include <vector>

#include "hatchway/render/device/surface_drawer.hpp"
#include "hatchway/render/frame_plan.hpp"
#include "hatchway/render/image_plan.hpp"
#include "hatchway/render/loaded_scene.hpp"
#include "hatchway/render/render_device.hpp"
#include "hatchway/render/view/frame_options.hpp"

namespace hw {

/// One call of a style for faces, kept until all styles have said what they draw.
struct FaceCall {
    Program program;
    Uniforms uniforms;
    std::vector<DrawItem> items;
    const Needs* needs = nullptr;                        ///< Of the style, or of the image pass.
    const std::map<MapKind, int>* named_maps = nullptr;  ///< What `needs` name.
};

/// What a mirror of a view shows, in the picture where it stands.
struct Reflection {
    const Mirror* mirror = nullptr;
    Image picture;  ///< As large as the view's.
};

/// One view of a frame: what is seen from where, and the target that it is drawn into. A second view in the same frame,
/// such as that of a mirror, has another of these and other results; scene and device are shared.
struct FrameView {
    const View& camera;
    const glm::dvec3& viewer_world;  ///< The eye of the frame, whichever mirror this view is of: shadows go by it.
    const FrameOptions& options;
    GpuTarget& picture;                ///< Size of the camera's; multisampled when the options say so.
    VisibleSet visible;                ///< What may be seen from the camera.
    FramePlan plan;                    ///< Which style draws what of `visible`.
    std::vector<WantedImage> images;   ///< What the styles of `visible` need, in the order of making.
    std::optional<PixelRect> scissor;  ///< The part of the picture that is drawn; none: all of it.
    bool is_deep = false;              ///< So many faces lie over each other that it pays to ask which are seen.
};

/// What the phases leave for those after them. Textures belong to the device's pool and live as long as the frame.
struct FrameResults {
    std::vector<Reflection> reflections;   ///< Drawn before the view is.
    std::map<ImageKey, Images> images;     ///< Made by image passes.
    std::vector<FaceCall> opaque_faces;    ///< Of first styles, in the order of the calls.
    std::optional<VisibleSet> seen;        ///< What of `visible` no other face hides, when that was asked.
    std::uint32_t line_depth_texture = 0;  ///< The depth that lines are tested against: see lay_line_depth().
    bool reads_clock = false;              ///< Something visible needs it.
    int transient_targets = 0;             ///< Made by Pass::render and Pass::filter.
};

/// What is handed through the phases of a frame.
struct Frame {
    FrameView& view;
    LoadedScene& scene;
    RenderDevice& device;
    FrameResults& results;

    SurfaceDrawer faces() const { return {device.programs, device.state, scene.gpu}; }
    const WholeItems& whole() const { return whole_items(view.plan, scene.input, view.visible); }
};

}  // namespace hw
