#include "measure/lines/exact_lines.hpp"

#include <algorithm>

#include "hatchway/render/view/line_camera.hpp"
#include "hatchway/stage/whole_scene.hpp"
#include "hatchway/world/camera_path.hpp"
#include "measure/lines/timed_lines.hpp"

namespace hw {
namespace {

std::vector<ObjectPens> all_in(const Scene& scene, const NamedStyle& style)
{
    const std::vector<StyledObject> objects(scene.objects.size(), StyledObject{.style = 0});
    return object_pens(scene, {&style, 1}, objects, View());
}

}  // namespace

ExactLines::ExactLines(const std::filesystem::path& file, const NamedStyle& style)
    : level_(read_level_with(file, {})), world_(open_world(level_)), lines_(world_->scene, all_in(world_->scene, style))
{
    prepare_s_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

std::vector<CameraPlace> ExactLines::cameras(int count, double aspect) const
{
    std::vector<CameraPlace> places;
    const auto add = [&](const Camera& c) { places.push_back(camera_place(c)); };
    for (const Camera& camera : level_.cameras)
        if (static_cast<int>(places.size()) < count) add(camera);
    if (!places.empty()) return places;
    const CameraPath around = turntable(scene(), aspect);
    for (int i = 0; i < count; ++i) add(camera_at(around, around.keys.back().t_s * (i + 0.15) / count));
    return places;
}

std::vector<VisibleLine> ExactLines::find(const CameraPlace& camera, glm::ivec2 size_px, double* seconds) const
{
    const VisibleLineOptions options{.intersections = lines_.intersections()};
    const LineCamera place = line_camera(camera, camera_view(camera, size_px, scene().bounds_world));
    return seconds == nullptr ? find_visible_lines(lines_.objects(), place, options)
                              : timed_visible_lines(lines_.objects(), place, options, 5, *seconds);
}

std::vector<VectorLine> ExactLines::drawn(const CameraPlace& camera, glm::ivec2 size_px, double* seconds)
{
    const LineCamera place = line_camera(camera, camera_view(camera, size_px, scene().bounds_world));
    std::vector<VectorLine> lines;
    for (VectorObject& object : lines_.drawing(find(camera, size_px, seconds), place).objects)
        for (VectorGroup& group : object.groups)
            for (VectorLine& line : group.lines) lines.push_back(std::move(line));
    return lines;
}

}  // namespace hw
