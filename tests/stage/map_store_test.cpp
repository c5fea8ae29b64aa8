#include "hatchway/stage/map_store.hpp"

#include "hatchway/core/budget.hpp"
#include "hatchway/core/limits.hpp"
#include "tests/io/expect_error.hpp"

namespace {

/// Of all budgets, for one test.
struct BudgetFactor {
    explicit BudgetFactor(double factor) { hw::Budget::factor() = factor; }
    ~BudgetFactor() { hw::Budget::factor() = 1.0; }
};

}  // namespace

TEST(map_store, counts_all_levels_of_all_maps_and_keeps_those_that_fit)
{
    hw::Level level;
    level.file = "/nowhere/a.level.json";
    hw::MapStore store;
    store.use(level, hw::MapKind::ink, "bricks", "/assign/0/maps/ink");
    double texels = 0.0;
    for (const hw::Pixels& pixels : store.maps()[0]->levels) texels += double(pixels.width) * pixels.height;

    const BudgetFactor factor(1.2 * texels / hw::limits::kMaxMapPixels);
    EXPECT_EQ(store.use(level, hw::MapKind::ink, "bricks", "/assign/1/maps/ink"), 0) << "it is read already";
    const hw::ErrorParts parts = error_of([&] { store.use(level, hw::MapKind::ink, "planks", "/assign/2/maps/ink"); });
    EXPECT_EQ(parts.what, "too many texels of maps");
    EXPECT_EQ(parts.pointer, "/assign/2/maps/ink");
    EXPECT_EQ(store.maps().size(), 1u);
}
