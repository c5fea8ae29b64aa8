#include "hatchway/plugin_host/guarded_style.hpp"

#include <fmt/format.h>

#include <utility>

#include "hatchway/core/log.hpp"
#include "hatchway/plugin_host/plugin_call.hpp"

namespace hw {
namespace {

constexpr const char* kDestroying = "its destructor";

/// What a crash would say of the items; nothing where nobody notes it.
std::string drawn(Items items, const ObjectNamer& object_name)
{
    if (!PluginCall::is_watching() || items.empty() || !object_name) return {};
    const std::string first = object_name(items.front().object());
    return items.size() == 1 ? first : fmt::format("{} and {} more", first, items.size() - 1);
}

/// Shows what another pass shows, and draws nothing.
class IdlePass final : public Pass {
 public:
    explicit IdlePass(const Pass& pass) : pass_(pass) {}
    const View& view() const override { return pass_.view(); }
    Layer layer() const override { return pass_.layer(); }
    Items opaque_scene() const override { return pass_.opaque_scene(); }
    DepthRange depth_range(const ImageKey& key) const override { return pass_.depth_range(key); }
    void cover(Program, const Uniforms&) override {}
    Image image(const ImageKey& key, std::size_t output) const override { return pass_.image(key, output); }
    Images render(const TargetDesc&, Program, const Uniforms&, Items) override { return {}; }
    Images filter(const TargetDesc&, Program, const Uniforms&) override { return {}; }
    void surfaces(Program, const Uniforms&, Items) override {}
    void lines(const LineLook&, Items) override {}
    void lines(Program, const Uniforms&, const LineLook&, Items) override {}

 private:
    const Pass& pass_;
};

}  // namespace

void PlainStyle::prepare(ProgramCache& programs)
{
    program_ = programs.surface("plain.frag");
}

void PlainStyle::surfaces(Pass& pass, Items items)
{
    pass.surfaces(program_, {}, items);
}

GuardedStyle::GuardedStyle(std::string name, Guarded guarded, std::unique_ptr<Style> style, Style& fallback)
    : name_(std::move(name)), guarded_(std::move(guarded)), fallback_(fallback)
{
    replace(guarded_.plugin, std::move(style));
}

GuardedStyle::~GuardedStyle()
{
    const PluginCall noted(guarded_.plugin, kDestroying);
    style_.reset();
}

void GuardedStyle::replace(const std::string& plugin, std::unique_ptr<Style> style)
{
    Needs needs = call_plugin(plugin, "needs", "", "", [&] { return style->needs(); });
    {
        const PluginCall noted(guarded_.plugin, kDestroying);
        style_ = std::move(style);
    }
    guarded_.plugin = plugin;
    needs_ = std::move(needs);
    failure_.clear();
}

std::string GuardedStyle::culprit(Pass& pass, Items items, void (Style::*draw)(Pass&, Items))
{
    if (items.empty() || !guarded_.object_name) return {};
    IdlePass idle(pass);
    for (std::size_t i = 0; i < items.size(); ++i) {
        try {
            ((*style_).*draw)(idle, items.subspan(i, 1));
        } catch (...) {
            return " at the object \"" + guarded_.object_name(items[i].object()) + '"';
        }
    }
    return fmt::format(" at the object \"{}\" and {} more together", guarded_.object_name(items[0].object()),
                       items.size() - 1);
}

void GuardedStyle::attempt(const char* doing, Pass& pass, Items items, void (Style::*draw)(Pass&, Items))
{
    if (!failure_.empty()) return;
    const PluginCall noted(guarded_.plugin, doing, drawn(items, guarded_.object_name));
    try {
        call_plugin(guarded_.plugin, doing, "", "", [&] { ((*style_).*draw)(pass, items); });
    } catch (const Error& error) {
        failure_ =
            fmt::format("the style \"{}\" is drawn plain{}: {}", name_, culprit(pass, items, draw), error.what());
        log_error(failure_);
    }
}

void GuardedStyle::visit_params(ParamVisitor& visitor)
{
    call_plugin(guarded_.plugin, "visit_params", "", "", [&] { style_->visit_params(visitor); });
}

void GuardedStyle::images(Pass& pass, Items items)
{
    attempt("images", pass, items, &Style::images);
}

void GuardedStyle::surfaces(Pass& pass, Items items)
{
    attempt("surfaces", pass, items, &Style::surfaces);
    if (!failure_.empty()) fallback_.surfaces(pass, items);
}

void GuardedStyle::lines(Pass& pass, Items items)
{
    attempt("lines", pass, items, &Style::lines);
}

GuardedImagePass::GuardedImagePass(Guarded guarded, std::unique_ptr<ImagePass> pass,
                                   std::function<void(const std::string&)> tell)
    : guarded_(std::move(guarded)), pass_(std::move(pass)), tell_(std::move(tell))
{
    needs_ = call_plugin(guarded_.plugin, "needs", "", "", [&] { return pass_->needs(); });
}

GuardedImagePass::~GuardedImagePass()
{
    const PluginCall noted(guarded_.plugin, kDestroying);
    pass_.reset();
}

Images GuardedImagePass::make(Pass& pass, Items items)
{
    if (has_failed_) return {};
    const PluginCall noted(guarded_.plugin, "make", drawn(items, guarded_.object_name));
    try {
        return call_plugin(guarded_.plugin, "make", "", "", [&] { return pass_->make(pass, items); });
    } catch (const Error& error) {
        has_failed_ = true;
        tell_(fmt::format("the image pass \"{}\" makes no image: {}", guarded_.plugin, error.what()));
        return {};
    }
}

}  // namespace hw
