#include "hatchway/io/gltf/check/motion.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "hatchway/io/gltf/check/meshes.hpp"
#include "hatchway/io/json/text.hpp"

namespace hw {
namespace {

using nlohmann::json;

constexpr int kFloat = 5126;

void check_skin(const GltfChecked& gltf, const json& skin, const std::string& pointer)
{
    if (!skin.contains("inverseBindMatrices")) return;
    const json& matrices = gltf.accessor(skin.at("inverseBindMatrices"));
    if (matrices.at("type") != "MAT4" || matrices.at("componentType") != kFloat)
        gltf.refuse(pointer + "/inverseBindMatrices", "the matrices are not MAT4 of floats");
    if (gltf.whole(matrices, "count", 0) < skin.at("joints").size())
        gltf.refuse(pointer + "/inverseBindMatrices", fmt::format("there are {} matrices", matrices.at("count").dump()),
                    fmt::format("one for each of {} joints", skin.at("joints").size()));
}

/// Keys that a sampler must give for each key time.
std::size_t values_per_key(const GltfChecked& gltf, const json& channel, const json& sampler)
{
    std::size_t count = sampler.value("interpolation", "LINEAR") == "CUBICSPLINE" ? 3 : 1;
    const json& target = channel.at("target");
    const auto node = gltf.index(target, "node");
    if (target.at("path") != "weights" || !node) return count;
    const auto mesh = gltf.index(gltf.list("nodes")[*node], "mesh");
    return mesh ? count * target_count(gltf.list("meshes")[*mesh]) : count;
}

void check_channel(const GltfChecked& gltf, const json& animation, const json& channel, const std::string& pointer)
{
    const auto index = channel.at("sampler").get<std::size_t>();
    const json& samplers = animation.at("samplers");
    if (index >= samplers.size())
        gltf.refuse(pointer + "/sampler", fmt::format("stands the number {}", index),
                    fmt::format("an index below {}", samplers.size()));
    if (channel.at("target").at("path") == "pointer") return;  // KHR_animation_pointer
    const json& sampler = samplers[index];
    const std::uint64_t keys = gltf.whole(gltf.accessor(sampler.at("input")), "count", 0);
    const std::uint64_t values = gltf.whole(gltf.accessor(sampler.at("output")), "count", 0);
    const std::uint64_t expected = keys * values_per_key(gltf, channel, sampler);
    if (values != expected)
        gltf.refuse(pointer + "/sampler", fmt::format("the sampler's output has {} elements", values),
                    fmt::format("{}", expected));
}

}  // namespace

void check_motion(const GltfChecked& gltf)
{
    const json& skins = gltf.list("skins");
    for (std::size_t i = 0; i < skins.size(); ++i) check_skin(gltf, skins[i], pointer_to("/skins", i));
    const json& animations = gltf.list("animations");
    for (std::size_t i = 0; i < animations.size(); ++i) {
        const json& channels = animations[i].at("channels");
        for (std::size_t k = 0; k < channels.size(); ++k)
            check_channel(gltf, animations[i], channels[k], pointer_to(pointer_to("/animations", i) + "/channels", k));
    }
}

}  // namespace hw
