#include "hatchway/render/mirror_views.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "hatchway/render/opaque_faces.hpp"

namespace hw {
namespace {

/// The plane as the view sees it; none where it is seen from a side from which it is not drawn, or on edge.
std::optional<MirrorPlane> plane_before(const Mirror& mirror, const View& view)
{
    const double height = view.is_orthographic()
                              ? glm::dot(mirror.plane.normal_world, glm::normalize(view.to_viewer_world))
                              : mirror.plane.height(view.eye_world);
    if (height > 0.0) return mirror.plane;
    if (height < 0.0 && mirror.is_two_sided) return mirror.plane.turned();
    return {};
}

}  // namespace

std::vector<MirrorInView> mirrors_in(const SceneInput& input, const VisibleSet& visible, const View& view,
                                     const PictureWindow& window)
{
    std::vector<MirrorInView> found;
    for (const VisibleObject& object : visible.objects) {
        const auto mirror = std::ranges::lower_bound(input.mirrors, object.object, {}, &Mirror::object);
        if (mirror == input.mirrors.end() || mirror->object != object.object) continue;
        if (input.objects[object.object].style == kNone) continue;
        const std::optional<MirrorPlane> plane = plane_before(*mirror, view);
        const std::optional<PictureWindow> seen_in = window_of(mirror->outline_world, view, window);
        if (plane && seen_in) found.push_back({&*mirror, *plane, with_room(*seen_in, view)});
    }
    return found;
}

void draw_reflections(const Frame& frame)
{
    static const Needs kNoNeeds;
    static const std::map<MapKind, int> kNoMaps;
    frame.view.picture.bind();
    for (const Reflection& reflection : frame.results.reflections) {
        FaceCall call{.program = frame.scene.mirror_program, .needs = &kNoNeeds, .named_maps = &kNoMaps};
        call.uniforms.set("reflection", reflection.picture)
            .set("tint", reflection.mirror->tint_linear)
            .set("reflectance", reflection.mirror->reflectance);
        for (const std::vector<DrawItem>* items : {&frame.whole().opaque, &frame.whole().blended})
            for (const DrawItem& item : *items)
                if (item.object() == reflection.mirror->object) call.items.push_back(item);
        draw_faces(frame, call,
                   {.depth_test = DepthTest::less_equal, .writes_depth = false, .blending = Blending::over});
    }
    frame.device.state.apply({});
}

}  // namespace hw
