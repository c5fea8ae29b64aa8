#pragma once

#include <string>

#include "hatchway/io/json/out.hpp"
#include "hatchway/render/view/frame_stats.hpp"

namespace hw {

/// The statistics of a frame, for --stats: some lines of text.
std::string stats_text(const FrameStats& stats);

/// The same as a JSON object, every member of FrameStats by its name.
JsonValue stats_json(const FrameStats& stats);

}  // namespace hw
