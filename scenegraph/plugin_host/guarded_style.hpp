#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "hatchway/style/style.hpp"

namespace hw {

/// A neutral gray drawing without lines: what the host draws when a style fails.
class PlainStyle final : public Style {
 public:
    Needs needs() const override { return {}; }
    void prepare(ProgramCache& programs) override;
    void surfaces(Pass& pass, Items items) override;

 private:
    Program program_;
};

/// The name of an object of the scene, for messages.
using ObjectNamer = std::function<std::string(std::uint32_t object)>;

/// Whose call it is, and how its objects are called.
struct Guarded {
    std::string plugin;
    const ObjectNamer& object_name;  ///< May be empty. Outlives the guard.
};

/// A plugin's style in the hands of the renderer, which knows no plugin: when the style throws while drawing, that is
/// logged once, with the object at which it does, and `fallback` draws from then on.
class GuardedStyle final : public Style {
 public:
    /// `style` is prepared and so is `fallback`, which must outlive this.
    GuardedStyle(std::string name, Guarded guarded, std::unique_ptr<Style> style, Style& fallback);
    ~GuardedStyle() override;

    /// Takes a fresh prepared instance, maybe of another plugin; forgets the failure of the last.
    void replace(const std::string& plugin, std::unique_ptr<Style> style);
    /// Why the style no longer draws; empty when it does.
    const std::string& failure() const { return failure_; }

    void visit_params(ParamVisitor& visitor) override;
    Needs needs() const override { return needs_; }
    void prepare(ProgramCache&) override {}
    void images(Pass& pass, Items items) override;
    void surfaces(Pass& pass, Items items) override;
    void lines(Pass& pass, Items items) override;

 private:
    void attempt(const char* doing, Pass& pass, Items items, void (Style::*draw)(Pass&, Items));
    /// Where it throws, in words: the first object with which it does so alone, too.
    std::string culprit(Pass& pass, Items items, void (Style::*draw)(Pass&, Items));

    std::string name_;
    Guarded guarded_;
    std::unique_ptr<Style> style_;
    Style& fallback_;
    Needs needs_;  ///< Asked once: they depend on the parameters alone.
    std::string failure_;
};

/// The same for an image pass: after a failure it makes no image, and styles draw without. `tell` hears of it.
class GuardedImagePass final : public ImagePass {
 public:
    GuardedImagePass(Guarded guarded, std::unique_ptr<ImagePass> pass, std::function<void(const std::string&)> tell);
    ~GuardedImagePass() override;

    Needs needs() const override { return needs_; }
    void prepare(ProgramCache&) override {}
    Images make(Pass& pass, Items items) override;

 private:
    Guarded guarded_;
    std::unique_ptr<ImagePass> pass_;
    std::function<void(const std::string&)> tell_;
    Needs needs_;
    bool has_failed_ = false;
};

}  // namespace hw
