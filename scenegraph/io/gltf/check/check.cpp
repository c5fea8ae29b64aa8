#include "hatchway/io/gltf/check/check.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "hatchway/io/gltf/check/buffers.hpp"
#include "hatchway/io/gltf/check/gltf_checked.hpp"
#include "hatchway/io/gltf/check/gltf_rules.hpp"
#include "hatchway/io/gltf/check/meshes.hpp"
#include "hatchway/io/gltf/check/motion.hpp"
#include "hatchway/io/gltf/check/nodes.hpp"
#include "hatchway/io/json/text.hpp"

namespace hw {
namespace {

using nlohmann::json;

constexpr std::string_view kKnownExtensions[] = {
    "EXT_mesh_gpu_instancing", "EXT_mesh_primitive_edge_visibility",
    "KHR_lights_punctual",     "KHR_materials_emissive_strength",
    "KHR_materials_unlit",     "KHR_mesh_quantization",
    "KHR_texture_transform",
};

void check_version(const GltfChecked& gltf)
{
    const json& asset = gltf.root.at("asset");
    const std::string key = asset.contains("minVersion") ? "minVersion" : "version";
    const std::string& version = asset.at(key).get_ref<const std::string&>();
    const bool is_read = key == "minVersion" ? version == "2.0" : version.starts_with("2.");
    if (!is_read)
        gltf.refuse("/asset/" + key, "stands \"" + version + '"', key == "minVersion" ? "2.0" : "2.0, 2.1, ...");
}

void check_extensions(const GltfChecked& gltf)
{
    const json& required = gltf.list("extensionsRequired");
    if (!required.is_array()) gltf.refuse("/extensionsRequired", "stands " + described(required), "an array");
    for (std::size_t i = 0; i < required.size(); ++i) {
        const std::string pointer = pointer_to("/extensionsRequired", i);
        if (!required[i].is_string()) gltf.refuse(pointer, "stands " + described(required[i]), "a text");
        const std::string& name = required[i].get_ref<const std::string&>();
        if (std::ranges::find(kKnownExtensions, name) == std::end(kKnownExtensions))
            gltf.refuse(pointer, "the model requires the extension \"" + name + '"',
                        fmt::format("one of: {}", fmt::join(kKnownExtensions, ", ")));
    }
}

void check_images(const GltfChecked& gltf)
{
    const json& images = gltf.list("images");
    for (std::size_t i = 0; i < images.size(); ++i)
        if (images[i].contains("uri") == images[i].contains("bufferView"))
            gltf.refuse(pointer_to("/images", i), "an image states both or neither of its sources",
                        "either uri or bufferView");
}

void check_cameras(const GltfChecked& gltf)
{
    const json& cameras = gltf.list("cameras");
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const std::string& type = cameras[i].at("type").get_ref<const std::string&>();
        if (!cameras[i].contains(type))
            gltf.refuse(pointer_to("/cameras", i), "\"" + type + "\" is missing", "an object of the camera's type");
    }
}

}  // namespace

void check_gltf(json& document, const std::string& file)
{
    const GltfChecked gltf{document, file};
    if (!document.is_object()) gltf.refuse("", "stands " + described(document), "an object");
    check_rules(document, gltf_rules(), file);
    check_version(gltf);
    check_extensions(gltf);
    check_images(gltf);
    check_cameras(gltf);
    check_buffers(gltf);
    check_meshes(gltf);
    check_nodes(gltf);
    check_motion(gltf);
}

}  // namespace hw
