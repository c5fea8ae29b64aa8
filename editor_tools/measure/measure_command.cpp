
#include "measure/measures.hpp"
#include "program/commands.hpp"

namespace hw {

void add_measure_command(CommandLine app)
{
    CommandLine measure = app.add_subcommand("measure", "Measures what an algorithm costs, and its error");
    measure.require_subcommand();
    add_measure_bsp(measure);
    add_measure_coherence(measure);
    add_measure_edge_map(measure);
    add_measure_frame(measure);
    add_measure_hatch(measure);
    add_measure_ids(measure);
    add_measure_ink(measure);
    add_measure_lightmap(measure);
    add_measure_lines(measure);
    add_measure_portals(measure);
    add_measure_pvs(measure);
    add_measure_scale(measure);
    add_measure_silhouettes(measure);
    add_measure_visibility(measure);
    add_measure_visible_lines(measure);
    add_measure_walk(measure);
}

}  // namespace hw
