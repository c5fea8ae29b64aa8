#pragma once

#include "hatchway/render/frame.hpp"

namespace hw {

/// What becomes of objects that are known to be hidden in the picture.
enum class Hidden : std::uint8_t { drawn, left_out };

/// Draws the faces of one call into the bound target.
void draw_faces(const Frame& frame, const FaceCall& call, const PipelineState& state, Hidden hidden = Hidden::drawn);

/// The same into a target with a clear depth: depth first, so that every pixel is shaded once.
void draw_faces_depth_first(const Frame& frame, const FaceCall& call);

/// The same after the depth of all visible opaque and masked objects: what they hide is left out.
void draw_faces_in_scene(const Frame& frame, const FaceCall& call);

/// Draws `frame.results.opaque_faces` into the picture, which is clear: depth of all of them first, so that every pixel
/// is shaded once, whichever style covers it. At equal depth the last call, and in it the last item, is seen.
void draw_opaque_faces(const Frame& frame);

/// Lays the depth of all opaque faces anew, behind the faces by the one polygon offset, into a texture of one sample
/// that lines look their visibility up in: frame.results.line_depth_texture. The picture's own depth stays as it is: an
/// offset that grows with the slope would let the upright side of a slab shine through the floor beside it.
void lay_line_depth(const Frame& frame);

}  // namespace hw
