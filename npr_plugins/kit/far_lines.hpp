#pragma once

#include "hatchway/style/style.hpp"

namespace hw {

/// The parameters of a FarPolicy, the same in every style in ink.
inline void visit_far_lines(ParamVisitor& visitor, FarPolicy& far)
{
    visitor.flag({"far_thinning", "Thins crowded lines of far objects, so that they do not turn black."}, far.is_on);
    visitor.real({"far_spacing_px", "Lines of an object that come closer together than this are thinned."},
                 far.full_spacing_px, 1.0f, 40.0f);
}

}  // namespace hw
