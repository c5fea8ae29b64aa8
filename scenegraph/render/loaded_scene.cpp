#include "hatchway/render/loaded_scene.hpp"

#include <algorithm>
#include <future>
#include <glm/geometric.hpp>

#include "hatchway/core/error.hpp"
#include "hatchway/render/repeats.hpp"

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

double area_of(const MeshData& mesh)
{
    double area = 0.0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                         c = mesh.positions[mesh.indices[i + 2]];
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return area;
}

/// Notes a style at all images that it needs, those that they read included.
void note_style(int style, const Needs& by, std::map<ImageKey, NeededImage>& images)
{
    for (const ImageKey& key : by.images) {
        const auto image = images.find(key);  // not there: more images read each other than may
        if (image != images.end() && image->second.styles.insert(style).second)
            note_style(style, image->second.needs, images);
    }
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
        mesh_areas.push_back(area_of(mesh));
    }
    for (ObjectId id = 0; id < input.scene->objects.size(); ++id) is_all_baked &= lightmap.feature(id) != 0;
    set_looks(std::move(input.styles), std::move(input.objects));
}

std::map<MapKind, int> LoadedScene::maps_of(const Needs& by) const
{
    std::map<MapKind, int> maps;
    for (const auto& [kind, name] : by.maps) {
        const auto found = input.named_maps.find({kind, name.value});
        if (found != input.named_maps.end()) maps[kind] = found->second;
    }
    return maps;
}

void LoadedScene::make_images(const Needs& by, int depth, std::map<ImageKey, NeededImage>& made) const
{
    for (const ImageKey& key : by.images) {
        if (made.contains(key) || depth > kMaxImageDepth) continue;
        NeededImage image{input.image_passes ? input.image_passes(key) : nullptr, {}, {}};
        if (image.pass == nullptr)
            throw Error({.what = "no image pass \"" + key.pass + "\"",
                         .expected =
                             "an image pass plugin, normal_depth, object_ids, triangle_ids, triangle_corners or "
                             "triangle_stars"});
        image.needs = image.pass->needs();
        image.maps = maps_of(image.needs);
        make_images(image.needs, depth + 1, made);
        made[key] = std::move(image);
    }
}

void LoadedScene::require_image(const ImageKey& key)
{
    std::map<ImageKey, NeededImage> with_it = images;
    make_images({.images = {key}}, 0, with_it);
    images = std::move(with_it);
}

void LoadedScene::set_looks(std::vector<NamedStyle> styles, std::vector<StyledObject> objects)
{
    std::vector<Needs> new_needs;
    std::vector<std::map<MapKind, int>> new_maps;
    std::map<ImageKey, NeededImage> new_images = images;
    for (const NamedStyle& style : styles) {
        new_needs.push_back(style.style->needs());
        new_maps.push_back(maps_of(new_needs.back()));
        make_images(new_needs.back(), 0, new_images);
    }
    for (auto& [key, image] : new_images) image.styles.clear();
    for (std::size_t i = 0; i < new_needs.size(); ++i) note_style(static_cast<int>(i), new_needs[i], new_images);
    std::vector<StreamUse> streams;
    for (ObjectId object = 0; object < objects.size(); ++object)
        for (const int style : {objects[object].style, objects[object].over})
            if (style != kNone) streams.push_back({object, new_needs[style].streams});
    std::future<void> coordinates = std::async(std::launch::async, [&] { gpu.prepare(streams); });
    edges.prepare(edge_demands(objects, new_needs));
    coordinates.get();
    for (const StreamUse& use : streams) gpu.mesh_of(use.object, use.streams);
    std::vector<std::uint8_t> new_repeats = find_repeats(*input.scene, objects);
    // Nothing below throws.
    repeats = std::move(new_repeats);
    needs = std::move(new_needs);
    style_maps = std::move(new_maps);
    images = std::move(new_images);
    input.styles = std::move(styles);
    input.objects = std::move(objects);
}

}  // namespace hw
