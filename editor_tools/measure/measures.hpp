#pragma once

namespace CLI {
class App;
}

namespace hw {

// Each measurement is a file measure_NAME.cpp of this folder with one function add_measure_NAME(), which gives the
// command `hatchway measure NAME`. A measurement prints time and error against an independent reference, from one run.

void add_measure_bsp(CLI::App& measure);
void add_measure_coherence(CLI::App& measure);
void add_measure_frame(CLI::App& measure);
void add_measure_hatch(CLI::App& measure);
void add_measure_ink(CLI::App& measure);
void add_measure_lightmap(CLI::App& measure);
void add_measure_lines(CLI::App& measure);
void add_measure_pvs(CLI::App& measure);
void add_measure_scale(CLI::App& measure);
void add_measure_silhouettes(CLI::App& measure);
void add_measure_walk(CLI::App& measure);

}  // namespace hw
