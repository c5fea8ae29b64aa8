// Portal files. What is read can be written, and rows of small ones can be made.
#include "hatchway/io/compiled/portal_file.hpp"
#include "tests/fuzz/target.hpp"

void hw::fuzz::try_bytes(std::string_view bytes)
{
    constexpr std::size_t kSmall = 64;
    const PortalFile file = parse_portals(bytes, "fuzz.prt");
    const PortalFile again = parse_portals(portals_text(file.graph), "again.prt");
    require(again.graph.leaf_count == file.graph.leaf_count);
    if (file.graph.leaf_count > static_cast<int>(kSmall) || file.graph.portals.size() > kSmall) return;
    const PvsResult pvs = build_pvs(file.graph, {.seconds = 1.0, .threads = 1});
    for (int leaf = 0; leaf < file.graph.leaf_count; ++leaf) require(pvs.rows.sees(leaf, leaf));
}
