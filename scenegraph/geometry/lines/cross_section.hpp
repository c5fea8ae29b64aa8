#pragma once

#include <span>

namespace hw {

/// A face that ends at a line, seen along the line.
struct FaceAtLine {
    double angle_rad = 0.0;  ///< Of the direction in which the face leaves the line.
    bool looks_ccw = false;  ///< Its front is on the side of rising angles.
    bool looks_cw = false;   ///< ... of falling angles; a double-sided face looks both ways.
};

/// Whether somebody outside of the solids sees no fold and no end of the surface at the line: every sector that is open
/// to the eye spans a straight angle within `flat_rad`. Two faces that coincide and look at each other's back are the
/// touching sides of two solids, or a sheet of paper: what lies around them tells which.
/// No face or one face is never flat, nor are faces with their backs to all sectors: how they wind says nothing.
bool is_flat_across(std::span<const FaceAtLine> faces, double flat_rad);

}  // namespace hw
