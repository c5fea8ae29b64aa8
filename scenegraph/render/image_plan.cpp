#include "hatchway/render/image_plan.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <map>

namespace hw {
namespace {

class ImagePlanner {
 public:
    explicit ImagePlanner(const LoadedScene& scene) : scene_(scene) {}

    void add(const std::vector<ImageKey>& keys, bool is_shown)
    {
        for (const ImageKey& key : keys) {
            const auto found = scene_.images.find(key);  // not there: more images read each other than may
            if (found == scene_.images.end()) continue;
            const auto [known, is_new] = is_shown_.try_emplace(key, is_shown);
            if (!is_new && known->second >= is_shown) continue;
            known->second = is_shown;
            add(found->second.needs.images, is_shown);
            if (is_new) order_.push_back(key);
        }
    }
    std::vector<WantedImage> images() const
    {
        std::vector<WantedImage> result;
        for (const ImageKey& key : order_) result.push_back({key, is_shown_.at(key)});
        return result;
    }

 private:
    const LoadedScene& scene_;
    std::map<ImageKey, bool> is_shown_;
    std::vector<ImageKey> order_;
};

bool is_needed(const NeededImage& image, const StyledObject& look)
{
    return image.styles.contains(look.style) || image.styles.contains(look.over);
}

}  // namespace

std::vector<WantedImage> plan_images(const LoadedScene& scene, const FramePlan& plan, const ImageKey* shown)
{
    ImagePlanner planner(scene);
    for (std::size_t i = 0; i < plan.styles.size(); ++i)
        if (!plan.styles[i].is_empty()) planner.add(scene.needs[i].images, false);
    if (shown != nullptr) planner.add({*shown}, true);
    return planner.images();
}

std::vector<DrawItem> items_of(const NeededImage& image, bool is_shown, const SceneInput& input,
                               const WholeItems& visible)
{
    std::vector<DrawItem> items;
    const auto belongs = [&](const DrawItem& item) {
        return is_shown || is_needed(image, input.objects[item.object()]);
    };
    std::copy_if(visible.opaque.begin(), visible.opaque.end(), std::back_inserter(items), belongs);
    std::copy_if(visible.blended.begin(), visible.blended.end(), std::back_inserter(items), belongs);
    return items;
}

DepthRange depth_range_of(const NeededImage& image, const SceneInput& input, const View& view)
{
    const glm::dmat4 to_view(view.view_from_world);
    const glm::dvec3 along = -glm::dvec3(to_view[0][2], to_view[1][2], to_view[2][2]);
    double nearest_m = INFINITY, farthest_m = 0.0;
    for (ObjectId id = 0; id < input.objects.size(); ++id) {
        const Box& bounds = input.scene->objects[id].bounds_world;
        if (bounds.is_empty() || (!image.styles.empty() && !is_needed(image, input.objects[id]))) continue;
        const double middle_m = glm::dot(bounds.centre() - view.eye_world, along);
        const double half_m = 0.5 * glm::dot(glm::abs(along), bounds.size());
        if (middle_m + half_m <= 0.0) continue;
        nearest_m = std::min(nearest_m, std::max(middle_m - half_m, 0.0));
        farthest_m = std::max(farthest_m, middle_m + half_m);
    }
    if (farthest_m <= 0.0) return {};
    // A little room: depths are interpolated in float.
    const double room_m = 1e-5 * farthest_m;
    return {static_cast<float>(std::max(nearest_m - room_m, 0.0)), static_cast<float>(farthest_m + room_m)};
}

}  // namespace hw
