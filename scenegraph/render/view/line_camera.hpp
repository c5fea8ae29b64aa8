#pragma once

#include "hatchway/geometry/lines/visible_lines.hpp"
#include "hatchway/render/view/camera_view.hpp"

namespace hw {

/// The camera whose line drawing lies over the picture of a view: camera_view() of the same place.
LineCamera line_camera(const CameraPlace& place, const View& view);

}  // namespace hw
