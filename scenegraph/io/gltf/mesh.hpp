#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "hatchway/core/budget.hpp"
#include "hatchway/geometry/mesh_data.hpp"
#include "hatchway/io/gltf/model.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// What an import may still store, and what it skipped so far. Private to io.
struct ImportTotals {
    Budget& budget;
    std::uint64_t unpacked_vertices = 0;   ///< As stored in the scene.
    std::uint64_t skipped_primitives = 0;  ///< Lines and points.
    std::uint64_t bent_primitives = 0;     ///< With morph targets, shown in their base shape.
};

/// One primitive of one mesh of the model.
struct PrimitiveId {
    std::size_t mesh = 0;
    std::size_t primitive = 0;

    std::string pointer() const;
};

/// Converts a primitive of triangles, strips or fans: indices checked, unused vertices dropped, flat normals made where
/// the model has none. Nothing for lines, points and primitives without a triangle. Throws hw::Error for indices out of
/// range, positions that are not finite or over limits::kMaxCoordinate, and totals over the limits.
std::optional<MeshData> convert_primitive(const GltfModel& model, const PrimitiveId& id, ImportTotals& totals);

}  // namespace hw
