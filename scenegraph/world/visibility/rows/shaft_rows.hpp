#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "hatchway/core/box.hpp"
#include "hatchway/world/visibility/rows/sight_slices.hpp"
#include "hatchway/world/visibility/rows/slot_rows.hpp"

namespace hw {

struct ShaftOptions {
    std::int64_t most_shafts = 32;  ///< For each pair of a cell and a slot; what is not proven stays visible.
    std::int64_t most_shafts_in_all =
        600'000;                        ///< Shared out evenly: a count, not a clock, so that rows stay the same.
    std::int64_t most_pairs = 250'000;  ///< Past this only some of the cells are tried.
    int threads = 0;                    ///< 0: as many as the machine has.
    std::function<void(double share)> progress;  ///< Told from any thread how much is done, 0 to 1; may be empty.
};

/// Takes out of the rows the slots that no sight line from a cell reaches. Cells and slots are halved until every pair
/// of halves is hidden by a slice or looks away. `leaf_boxes`: metres from the grid's origin. The same for any number
/// of threads.
void hide_behind_slices(const SlotPlaces& places, const SightSlices& slices, std::span<const Box> leaf_boxes,
                        const ShaftOptions& options, LeafRows& slot_rows);

}  // namespace hw
