#pragma once

#include <map>
#include <memory>
#include <set>
#include <vector>

#include "hatchway/render/device/gpu_lightmap.hpp"
#include "hatchway/render/device/gpu_scene.hpp"
#include "hatchway/render/lines/edge_store.hpp"
#include "hatchway/render/products/shadow_map.hpp"
#include "hatchway/render/view/scene_input.hpp"

namespace hw {

/// An image pass that is prepared, and what it reads itself.
struct NeededImage {
    std::shared_ptr<ImagePass> pass;
    Needs needs;
    std::map<MapKind, int> maps;  ///< What its needs name.
    std::set<int> styles = {};    ///< Those that need it, themselves or by another image.
};

/// Everything of one loaded scene: what was given, and what was made of it.
struct LoadedScene {
    /// Throws hw::Error when the device cannot hold it, or a style asks for an image that nobody makes.
    LoadedScene(SceneInput taken, LineIndices& line_indices, FilterMode texture_filter);

    /// Makes an image of this key be made in every frame that asks for it, needed or not. Throws hw::Error when nobody
    /// makes it.
    void require_image(const ImageKey& key);
    /// Takes other looks and builds what they need and is not there yet. When it throws, all stays as it was.
    void set_looks(std::vector<NamedStyle> styles, std::vector<StyledObject> objects);

    SceneInput input;
    GpuScene gpu;
    GpuLightmap lightmap;
    EdgeStore edges;
    ShadowMap shadow;
    SceneLight light;
    SurfaceFeatures light_features = 0;              ///< What programs are compiled for in this scene.
    bool is_all_baked = true;                        ///< Every object has baked light.
    std::vector<Box> mesh_bounds;                    ///< Object space.
    std::vector<double> mesh_areas;                  ///< Object space.
    std::vector<std::uint8_t> repeats;               ///< Objects that are not drawn: find_repeats().
    std::vector<Needs> needs;                        ///< Of each style.
    std::vector<std::map<MapKind, int>> style_maps;  ///< Of each style: what its needs name.
    Program mirror_program;                          ///< Invalid in a scene without mirrors.
    std::map<ImageKey, NeededImage> images;          ///< What styles need, directly or by another image's needs.

 private:
    std::map<MapKind, int> maps_of(const Needs& by) const;
    /// Adds to `made` the images that are needed and not in it yet.
    void make_images(const Needs& by, int depth, std::map<ImageKey, NeededImage>& made) const;
};

}  // namespace hw
