#include "hatchway/world/light/bake.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <glm/gtc/packing.hpp>

#include "hatchway/core/hash.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/core/progress.hpp"
#include "hatchway/world/light/fill.hpp"
#include "hatchway/world/light/layout.hpp"
#include "hatchway/world/light/random.hpp"
#include "hatchway/world/open_backs.hpp"

namespace hw {
namespace {

constexpr std::uint32_t kFirstPass = 8;  // samples
constexpr std::size_t kBlock = 64;       // luxels
constexpr std::size_t kProbed = 61;      // of so many luxels one shows what a sample costs
constexpr std::uint32_t kProbes = 4;     // samples of it
constexpr float kUnitsPerLux = 1e-3f;
constexpr float kMostUnits = 65000.0f;  // of half floats

class Bake {
 public:
    Bake(const Scene& scene, const LightSources& sources, const BakeOptions& options)
        : scene_(scene),
          sources_(sources),
          samples_(std::bit_ceil(std::max(1u, options.samples))),
          seed_(mixed(options.seed)),
          lightmap_(plan_lightmap(scene, options.luxels_per_m, options.budget, options.receivers, sources.lights,
                                  sources.eyes_world)),
          rays_(scene, sources.lights, sources.eyes_world),
          points_(scene, lightmap_, rays_),
          places_(points_.luxels().size()),
          sums_(places_.size(), glm::vec3(0.0f))
    {
        lightmap_.key = lightmap_key(scene, sources);
    }
    Lightmap run(std::uint64_t ray_budget, const BakeObserver& observer);

 private:
    void find_places();
    void gather(std::uint32_t first, std::uint32_t last, Progress& progress);
    void store(std::uint32_t samples);
    LightEstimate sampled(std::size_t luxel, std::uint32_t sample) const;
    double rays_of_sample() const;
    void keep_budget(std::uint64_t ray_budget);

    const Scene& scene_;
    const LightSources& sources_;
    std::uint32_t samples_;
    std::uint32_t seed_;
    Lightmap lightmap_;
    LightScene rays_;
    LuxelPoints points_;
    std::vector<LuxelPlace> places_;
    std::vector<glm::vec3> sums_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> parted_;
};

void Bake::find_places()
{
    tbb::parallel_for(std::size_t{0}, places_.size(),
                      [&](std::size_t i) { places_[i] = points_.place(points_.luxels()[i]); });
    parted_ = parted_luxels(points_, places_, lightmap_);
}

void Bake::gather(std::uint32_t first, std::uint32_t last, Progress& progress)
{
    const std::size_t blocks = (places_.size() + kBlock - 1) / kBlock;
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
        const std::size_t end = std::min(places_.size(), (block + 1) * kBlock);
        for (std::size_t i = block * kBlock; i < end; ++i) {
            if (places_[i].is_buried) continue;
            glm::vec3 sum(0.0f);
            for (std::uint32_t sample = first; sample < last; ++sample) sum += sampled(i, sample).illuminance;
            sums_[i] += sum;
        }
        progress.advance(last - first);
    });
}

LightEstimate Bake::sampled(std::size_t i, std::uint32_t sample) const
{
    const Luxel& luxel = points_.luxels()[i];
    const std::uint32_t seed = mixed(luxel.place + 1) + seed_;
    const LightReceiver receiver = points_.part(luxel, places_[i], sample_2d(sample, 0, seed));
    return sample_light(rays_, sources_, receiver, {sample, seed});
}

/// Of one sample of every luxel, about.
double Bake::rays_of_sample() const
{
    const std::size_t probes = (places_.size() + kProbed - 1) / kProbed;
    std::atomic<std::uint64_t> rays = 0;
    tbb::parallel_for(std::size_t{0}, probes, [&](std::size_t probe) {
        const std::size_t i = probe * kProbed;
        if (places_[i].is_buried) return;
        for (std::uint32_t sample = 0; sample < kProbes; ++sample) rays += sampled(i, sample).rays;
    });
    const auto samples = static_cast<double>(std::max<std::size_t>(probes, 1) * kProbes);
    return static_cast<double>(rays) / samples * static_cast<double>(places_.size());
}

/// Fewer samples, if as many as were asked for would take more rays than the budget has.
void Bake::keep_budget(std::uint64_t ray_budget)
{
    const double of_sample = rays_of_sample();
    std::uint32_t samples = samples_;
    while (samples > 1 && samples * of_sample > static_cast<double>(ray_budget)) samples /= 2;
    if (samples == samples_) return;
    log_warning(
        fmt::format("Lightmap: {} samples of each luxel instead of {}, to keep the budget of rays; "
                    "--budget-factor 2 doubles it, `--luxels-per-m` makes coarser luxels, "
                    "`--nodes GLOB` bakes fewer nodes",
                    samples, samples_));
    samples_ = samples;
}

void Bake::store(std::uint32_t samples)
{
    std::vector<glm::vec3> light;
    light.reserve(sums_.size());
    for (const glm::vec3& sum : sums_) light.push_back(sum / static_cast<float>(samples));
    light = filled_light({points_, places_, light}, scene_, lightmap_, parted_);
    for (std::size_t i = 0; i < light.size(); ++i) {
        auto& halves = lightmap_.luxels[points_.luxels()[i].place];
        for (int channel = 0; channel < 3; ++channel)
            halves[channel] = glm::packHalf1x16(std::clamp(light[i][channel] * kUnitsPerLux, 0.0f, kMostUnits));
    }
}

Lightmap Bake::run(std::uint64_t ray_budget, const BakeObserver& observer)
{
    auto start = std::chrono::steady_clock::now();
    find_places();
    keep_budget(ray_budget);
    const std::size_t blocks = (places_.size() + kBlock - 1) / kBlock;
    Progress progress("Baking light", blocks * samples_ + 1);
    const auto buried = std::count_if(places_.begin(), places_.end(), [](const LuxelPlace& p) { return p.is_buried; });
    for (std::uint32_t done = 0; done < samples_;) {
        const std::uint32_t next = std::min(samples_, std::max(kFirstPass, 2 * done));
        gather(done, next, progress);
        done = next;
        if (done < samples_ && !observer) continue;
        store(done);
        if (!observer) break;
        const auto now = std::chrono::steady_clock::now();
        observer({.lightmap = lightmap_,
                  .samples = done,
                  .luxels = static_cast<std::uint32_t>(places_.size()),
                  .buried = static_cast<std::uint32_t>(buried),
                  .seconds = std::chrono::duration<double>(now - start).count()});
        start += std::chrono::steady_clock::now() - now;
    }
    return std::move(lightmap_);
}

/// Takes in plain values one after the other.
class KeyHash {
 public:
    template <typename Value>
    void add(const Value& value)
    {
        static_assert(std::is_trivially_destructible_v<Value>);
        add_all(std::span(&value, 1));
    }
    template <typename Value, std::size_t extent>
    void add_all(std::span<const Value, extent> values)
    {
        const std::uint64_t count = values.size();
        value_ = hash_bytes(std::as_bytes(std::span(&count, 1)), value_);
        value_ = hash_bytes(std::as_bytes(values), value_);
    }
    std::uint64_t value() const { return value_; }

 private:
    std::uint64_t value_ = hash_bytes({});
};

void add_texture(KeyHash& hash, const TextureUse& use)
{
    hash.add(use.texture);
    hash.add(use.uv_set);
    hash.add(use.uv_transform);
}

void add_lights(KeyHash& hash, const LightSources& sources)
{
    for (const Light& light : sources.lights) {
        hash.add(light.type);
        hash.add(light.colour * light.intensity);
        hash.add(light.position_world);
        hash.add(light.direction_world);
        hash.add(glm::vec3(light.range_m, light.inner_cone_rad, light.outer_cone_rad));
    }
    hash.add(sources.sky_luminance);
    hash.add(sources.ground_luminance);
    hash.add(glm::vec3(sources.emission_luminance, sources.sun_radius_rad, sources.lamp_radius_m));
}

void add_materials(KeyHash& hash, const Scene& scene)
{
    for (const Material& material : scene.materials) {
        hash.add(material.base_colour);
        hash.add(material.emissive);
        hash.add(material.alpha_cutoff);
        hash.add(
            std::array{static_cast<int>(material.alpha_mode), int{material.is_double_sided}, int{material.is_unlit}});
        add_texture(hash, material.base_colour_texture);
        add_texture(hash, material.emissive_texture);
    }
    for (const Texture& texture : scene.textures)
        hash.add(std::array{texture.image, static_cast<int>(texture.wrap_u), static_cast<int>(texture.wrap_v)});
    for (const Pixels& image : scene.images) {
        hash.add(std::array{image.width, image.height, image.channels});
        hash.add_all(std::span(std::as_const(image.bytes)));
    }
}

}  // namespace

BakeOptions bake_options(BakeQuality quality)
{
    if (quality == BakeQuality::draft)
        return {.luxels_per_m = 2.0, .samples = 32, .budget = 512ull << 10, .ray_budget = 100'000'000};
    return {};
}

Lightmap bake_lightmap(const Scene& scene, const LightSources& sources, const BakeOptions& options,
                       const BakeObserver& observer)
{
    return Bake(scene, sources, options).run(options.ray_budget, observer);
}

std::uint64_t lightmap_key(const Scene& scene, const LightSources& sources)
{
    KeyHash hash;
    add_lights(hash, sources);
    add_materials(hash, scene);
    for (const MeshData& mesh : scene.meshes) {
        hash.add_all(std::span(mesh.positions));
        hash.add_all(std::span(mesh.normals));
        hash.add_all(std::span(mesh.uv0));
        hash.add_all(std::span(mesh.uv1));
        hash.add_all(std::span(mesh.colours));
        hash.add_all(std::span(mesh.indices));
    }
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        hash.add(std::array{scene.objects[id].mesh, scene.objects[id].material,
                            int{scene.nodes[scene.objects[id].node].is_animated}});
        hash.add(scene.world_from_object(id));
    }
    // Of the eyes only what they open counts: a camera may move about in its room.
    const std::vector<bool> open = find_open_backs(scene, sources.lights, sources.eyes_world);
    const std::vector<bool> lit = find_open_backs(scene, sources.lights);
    for (ObjectId id = 0; id < scene.objects.size(); ++id)
        if (open[id] != lit[id]) hash.add(id);
    return hash.value();
}

}  // namespace hw
