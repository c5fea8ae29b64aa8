#include "measure/exact_lines.hpp"

#include <algorithm>
#include <glm/trigonometric.hpp>

#include "walk/whole_scene.hpp"
#include "world/camera_path.hpp"

namespace hw {
namespace {

std::vector<ObjectInk> all_inked(const Scene& scene, double crease_deg)
{
    const auto crease_rad = static_cast<float>(glm::radians(crease_deg));
    const ObjectInk ink{.is_used = true, .crease_rad = crease_rad, .has_intersections = true, .looks = {{}}};
    std::vector<ObjectInk> inks(scene.objects.size(), ink);
    for (ObjectInk& object : inks) object.looks[0].look.crease_rad = crease_rad;
    return inks;
}

}  // namespace

ExactLines::ExactLines(const std::filesystem::path& file, double crease_deg)
    : level_(read_level_with(file, {})),
      world_(open_world(level_, nullptr)),
      lines_(world_->scene, all_inked(world_->scene, crease_deg), {}),
      cuts_(&lines_.intersections())
{
}

std::vector<CameraPlace> ExactLines::cameras(int count, double aspect) const
{
    std::vector<CameraPlace> places;
    const auto add = [&](const Camera& c) { places.push_back({c.eye_world, c.target_world, c.fov_deg}); };
    for (const auto& [name, camera] : level_.cameras)
        if (static_cast<int>(places.size()) < count) add(camera);
    if (!places.empty()) return places;
    const CameraPath around = turntable(scene(), aspect);
    for (int i = 0; i < count; ++i) add(camera_at(around, around.keys.back().t_s * (i + 0.15) / count));
    return places;
}

std::vector<VisibleLine> ExactLines::find(const CameraPlace& camera, glm::ivec2 size_px, double* seconds) const
{
    const LineCamera line_camera{.eye_world = camera.eye_world,
                                 .target_world = camera.target_world,
                                 .fov_rad = glm::radians(camera.fov_deg),
                                 .size_px = size_px};
    const VisibleLineOptions options{.intersections = *cuts_};
    return seconds == nullptr ? find_visible_lines(lines_.objects(), line_camera, options)
                              : timed_visible_lines(lines_.objects(), line_camera, options, 5, *seconds);
}

}  // namespace hw
