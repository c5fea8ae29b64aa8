#include "hatchway/render/image_plan.hpp"

#include <algorithm>
#include <iterator>
#include <map>

namespace hw {
namespace {

constexpr int kShown = -1;  ///< Beside the numbers of styles: who looks at an image.

class ImagePlanner {
 public:
    explicit ImagePlanner(const LoadedScene& scene) : scene_(scene) {}

    void add(const std::vector<ImageKey>& keys, int style)
    {
        for (const ImageKey& key : keys) {
            const auto found = scene_.images.find(key);  // not there: more images read each other than may
            if (found == scene_.images.end() || !users_[key].insert(style).second) continue;
            add(found->second.needs.images, style);
            if (std::find(order_.begin(), order_.end(), key) == order_.end()) order_.push_back(key);
        }
    }
    std::vector<WantedImage> images() const
    {
        std::vector<WantedImage> result;
        for (const ImageKey& key : order_) {
            WantedImage image{key, users_.at(key), false};
            image.is_shown = image.styles.erase(kShown) != 0;
            result.push_back(std::move(image));
        }
        return result;
    }

 private:
    const LoadedScene& scene_;
    std::map<ImageKey, std::set<int>> users_;
    std::vector<ImageKey> order_;
};

}  // namespace

std::vector<WantedImage> plan_images(const LoadedScene& scene, const FramePlan& plan, const ImageKey* shown)
{
    ImagePlanner planner(scene);
    for (std::size_t i = 0; i < plan.styles.size(); ++i)
        if (!plan.styles[i].is_empty()) planner.add(scene.needs[i].images, static_cast<int>(i));
    if (shown != nullptr) planner.add({*shown}, kShown);
    return planner.images();
}

std::vector<DrawItem> items_of(const WantedImage& image, const SceneInput& input, const WholeItems& visible)
{
    std::vector<DrawItem> items;
    const auto is_needed = [&](const DrawItem& item) {
        const StyledObject& look = input.objects[item.object()];
        return image.is_shown || image.styles.contains(look.style) || image.styles.contains(look.over);
    };
    std::copy_if(visible.opaque.begin(), visible.opaque.end(), std::back_inserter(items), is_needed);
    std::copy_if(visible.blended.begin(), visible.blended.end(), std::back_inserter(items), is_needed);
    return items;
}

}  // namespace hw
