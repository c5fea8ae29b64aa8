#pragma once

#include "program/command_line.hpp"

namespace hw {

// Each measurement is a file measure_NAME.cpp of this folder with one function add_measure_NAME(), which gives the
// command `hatchway measure NAME`. A measurement prints time and error against an independent reference, from one run.

void add_measure_bsp(CommandLine measure);
void add_measure_coherence(CommandLine measure);
void add_measure_edge_map(CommandLine measure);
void add_measure_frame(CommandLine measure);
void add_measure_hatch(CommandLine measure);
void add_measure_ids(CommandLine measure);
void add_measure_ink(CommandLine measure);
void add_measure_lightmap(CommandLine measure);
void add_measure_lines(CommandLine measure);
void add_measure_portals(CommandLine measure);
void add_measure_pvs(CommandLine measure);
void add_measure_scale(CommandLine measure);
void add_measure_silhouettes(CommandLine measure);
void add_measure_visibility(CommandLine measure);
void add_measure_visible_lines(CommandLine measure);
void add_measure_walk(CommandLine measure);

}  // namespace hw
