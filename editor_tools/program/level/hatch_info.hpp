#pragma once

#include <string>

#include "hatchway/geometry/hatching/hatch_coordinates.hpp"
#include "hatchway/io/json/out.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// Hatch coordinates of all meshes of a scene, each once.
struct HatchTotals {
    std::string source;
    std::uint64_t meshes = 0;  ///< That got coordinates.
    std::uint64_t vertices_added = 0;
    HatchReport report;
    double seconds = 0.0;
};

inline constexpr const char* kModelHatching = "model";

/// `source` is model (box for meshes without texture coordinates, none for others), box, cylinder or principal.
HatchTotals hatch_totals(const Scene& scene, const std::string& source);

std::string hatch_text(const HatchTotals& totals);
void add_hatch_json(const HatchTotals& totals, JsonValue& json);

}  // namespace hw
