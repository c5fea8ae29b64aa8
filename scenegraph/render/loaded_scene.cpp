#include "hatchway/render/loaded_scene.hpp"

#include <algorithm>

#include "hatchway/core/error.hpp"
#include "hatchway/render/products/shared_images.hpp"

namespace hw {
namespace {

constexpr int kMaxImageDepth = 16;

SurfaceFeatures features_of(const std::vector<Light>& lights)
{
    namespace f = surface_feature;
    SurfaceFeatures features = static_cast<SurfaceFeatures>(lights.size()) << f::kLightCountBit;
    for (const Light& light : lights) {
        if (light.type == LightType::sun) features += SurfaceFeatures(1) << f::kSunCountBit;
        if (light.type == LightType::spot) features |= f::kSpotLights;
        if (light.type != LightType::sun && light.range_m > 0.0f) features |= f::kLightRanges;
    }
    return features;
}

}  // namespace

LoadedScene::LoadedScene(SceneInput taken, LineIndices& line_indices, FilterMode texture_filter)
    : input(std::move(taken)),
      gpu(*input.scene, input.maps, texture_filter),
      lightmap(input.lightmap, *input.scene),
      edges(*input.scene, line_indices),
      light(choose_lights(input.lights, input.scene->bounds_world)),
      light_features(features_of(light.lights))
{
    light.exposure_ev = input.exposure_ev;
    light.background_linear = linear_from_srgb(input.background_srgb);
    for (const MeshData& mesh : input.scene->meshes) {
        mesh_bounds.emplace_back();
        for (const glm::vec3& position : mesh.positions) mesh_bounds.back().add(glm::dvec3(position));
    }
    for (ObjectId id = 0; id < input.scene->objects.size(); ++id) is_all_baked &= lightmap.feature(id) != 0;
    std::uint32_t first = 0;
    for (const Object& object : input.scene->objects) {
        first_triangle.push_back(first);
        first += static_cast<std::uint32_t>(input.scene->meshes[object.mesh].triangle_count());
    }
    set_looks(std::move(input.styles), std::move(input.objects));
}

void LoadedScene::make_images(const Needs& by, int depth, std::map<ImageKey, NeededImage>& made) const
{
    for (const ImageKey& key : by.images) {
        if (is_engine_image(key.pass) || made.contains(key) || depth > kMaxImageDepth) continue;
        NeededImage image{input.image_passes ? input.image_passes(key) : nullptr, {}};
        if (image.pass == nullptr)
            throw Error({.what = "no image pass \"" + key.pass + "\"",
                         .expected = "an image pass plugin, normal_depth, object_ids or triangle_ids"});
        image.needs = image.pass->needs();
        make_images(image.needs, depth + 1, made);
        made[key] = std::move(image);
    }
}

void LoadedScene::set_looks(std::vector<NamedStyle> styles, std::vector<StyledObject> objects)
{
    std::vector<Needs> new_needs;
    std::vector<std::map<MapKind, int>> new_maps(styles.size());
    std::map<ImageKey, NeededImage> new_images = images;
    for (std::size_t i = 0; i < styles.size(); ++i) {
        new_needs.push_back(styles[i].style->needs());
        make_images(new_needs[i], 0, new_images);
        for (const auto& [kind, name] : new_needs[i].maps) {
            const auto found = input.named_maps.find({kind, name.value});
            if (found != input.named_maps.end()) new_maps[i][kind] = found->second;
        }
    }
    for (ObjectId object = 0; object < objects.size(); ++object)
        for (const int style : {objects[object].style, objects[object].over})
            if (style != kNone) gpu.mesh_of(object, new_needs[style].streams);
    edges.prepare(edge_demands(objects, new_needs));
    // Nothing below throws.
    needs = std::move(new_needs);
    style_maps = std::move(new_maps);
    images = std::move(new_images);
    input.styles = std::move(styles);
    input.objects = std::move(objects);
}

}  // namespace hw
