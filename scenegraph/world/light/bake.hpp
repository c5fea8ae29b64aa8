#pragma once

#include <functional>

#include "hatchway/world/light/lightmap.hpp"
#include "hatchway/world/light/transport.hpp"

namespace hw {

struct BakeOptions {
    double luxels_per_m = 8.0;
    std::uint32_t samples = 512;                ///< Of each luxel; rounded up to a power of two.
    std::uint32_t seed = 0;                     ///< Of all that is random: another one gives other noise.
    std::uint64_t budget = 8ull << 20;          ///< Luxels.
    std::uint64_t ray_budget = 20'000'000'000;  ///< Where it takes more, about, there are fewer samples.
    std::vector<ObjectId> receivers;  ///< Objects that get baked light; empty: all. Others still cast and send light.
};

enum class BakeQuality : unsigned char { draft, final };

/// draft: coarse and grainy, to see where light goes, within half a minute of one processor. final: what is shipped.
BakeOptions bake_options(BakeQuality quality);

struct BakeState {
    const Lightmap& lightmap;   ///< As it is by now, filled and ready to be shown.
    std::uint32_t samples = 0;  ///< Of each luxel, so far.
    std::uint32_t luxels = 0;   ///< That lie on surfaces.
    std::uint32_t buried = 0;   ///< Of these, inside of solids.
    double seconds = 0.0;       ///< Since the start, calls of the observer left out.
};

/// Called after each pass; each takes as many samples as all before it together.
using BakeObserver = std::function<void(const BakeState&)>;

/// Bakes the light of a scene's static, opaque or masked objects. Parallel; the result depends on the arguments alone,
/// not on the number of threads. Says so when a budget makes it coarser. The key is lightmap_key(). Throws hw::Error if
/// the budget is too small.
Lightmap bake_lightmap(const Scene& scene, const LightSources& sources, const BakeOptions& options,
                       const BakeObserver& observer = {});

/// A hash of the state of a level that a lightmap is made for: meshes, materials, images, placed objects, lights, and
/// the rooms that only an eye makes rooms.
std::uint64_t lightmap_key(const Scene& scene, const LightSources& sources);

}  // namespace hw
