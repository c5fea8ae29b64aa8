#pragma once

#include "hatchway/render/frame.hpp"

namespace hw {

/// The phases of a frame, in this order, each over the visible objects of `frame.view`.

/// Makes what is kept between frames and is not there yet (shadow map, baked light), and tells shaders of the view.
void draw_products(const Frame& frame);
/// Makes the images that styles need, each once, then lets styles draw into targets of their own.
void draw_images(const Frame& frame);
/// Draws opaque and masked faces, second styles over the first.
void draw_surfaces(const Frame& frame);
/// Draws the lines of opaque and masked objects.
void draw_lines(const Frame& frame);
/// Draws faces and lines of blended objects, back to front.
void draw_blended(const Frame& frame);
/// Draws an image of the frame over the picture: its first output.
void show_image(const Frame& frame, const ImageKey& key);

}  // namespace hw
