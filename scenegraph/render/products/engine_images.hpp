#pragma once

#include "hatchway/render/view/scene_input.hpp"

namespace hw {

/// The engine's own image passes, written with nothing but the plugin interface: "normal_depth", "object_ids" and
/// "triangle_ids", and the tables that triangle numbers lead into: "triangle_corners" and "triangle_stars". The first
/// three show visible opaque and masked faces, whatever their style: what hides an object is there, too. For these
/// names the result makes them with `programs`, a cache of the engine's shaders, of `scene`, which must outlive it;
/// `others` makes the rest. Throws hw::Error for a parameter that an image does not have.
ImagePassSource with_engine_images(ImagePassSource others, ProgramCache& programs, const Scene& scene);

}  // namespace hw
