#pragma once

#include <span>

#include "hatchway/param/param_visitor.hpp"
#include "hatchway/style/colour.hpp"
#include "hatchway/style/ink_look.hpp"
#include "hatchway/style/needs.hpp"
#include "hatchway/style/pass.hpp"
#include "hatchway/style/plugin.hpp"

namespace hw {

/// A way of drawing objects. One instance for each named style of a level. The host makes a fresh instance, visits its
/// parameters, calls prepare(), and keeps the old instance when any of that throws.
///
/// Drawing never throws, keeps no clock of its own (view().time_s) and no history: the same view gives the same bytes
/// whatever was drawn before.
class Style {
 public:
    virtual ~Style() = default;

    virtual void visit_params(ParamVisitor&) {}
    virtual Needs needs() const = 0;
    virtual void prepare(ProgramCache&) = 0;

    /// Called in this order, each once a frame and layer, with the style's visible objects.
    virtual void images(Pass&, std::span<const DrawItem>) {}
    virtual void surfaces(Pass&, Layer, std::span<const DrawItem>) {}
    virtual void lines(Pass&, std::span<const DrawItem>) {}
};

/// The second kind of plugin: makes one full-screen image from products, for any style (edge map, id mask, distance to
/// lines). Its parameters are those of the ImageKey that asks for it.
class ImagePass {
 public:
    virtual ~ImagePass() = default;

    virtual void visit_params(ParamVisitor&) {}
    virtual Needs needs() const = 0;
    virtual void prepare(ProgramCache&) = 0;
    virtual Image make(Pass&) = 0;
};

}  // namespace hw
