#pragma once

#include "hatchway/param/param_visitor.hpp"
#include "hatchway/style/colour.hpp"
#include "hatchway/style/needs.hpp"
#include "hatchway/style/pass.hpp"
#include "hatchway/style/plugin.hpp"

namespace hw {

/// A way of drawing objects. One instance for each named style of a level. The host makes a fresh instance, visits its
/// parameters, calls prepare(), and keeps the old instance when any of that throws.
///
/// Drawing never throws, keeps no clock of its own (Needs::clock) and no history: the same view gives the same bytes
/// whatever was drawn before.
class Style {
 public:
    virtual ~Style() = default;

    virtual void visit_params(ParamVisitor&) {}
    virtual Needs needs() const = 0;
    virtual void prepare(ProgramCache&) = 0;

    /// Called in this order with the style's visible objects: images() once a frame with all of them; surfaces() with
    /// the opaque ones whose first style it is, then with those that it lies over; lines() with the opaque ones; then
    /// both for each run of blended ones, back to front across styles.
    virtual void images(Pass&, Items) {}
    virtual void surfaces(Pass&, Items) {}
    virtual void lines(Pass&, Items) {}
};

/// The second kind of plugin: makes full-screen images, for any style (edge map, id mask, distance to lines). Its
/// parameters are those of the ImageKey that asks for it. Its needs hold while it draws, as a style's do.
class ImagePass {
 public:
    virtual ~ImagePass() = default;

    virtual void visit_params(ParamVisitor&) {}
    virtual Needs needs() const = 0;
    virtual void prepare(ProgramCache&) = 0;
    /// Called once a frame when a visible object's style needs the image, itself or by another image. `items`: all such
    /// objects, opaque and masked ones near before far, then blended ones back to front. What pass.image() gives for
    /// the key is what this returns.
    virtual Images make(Pass&, Items items) = 0;
};

}  // namespace hw
