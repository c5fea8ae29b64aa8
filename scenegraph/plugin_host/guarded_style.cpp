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

template <typename Call>
void GuardedStyle::attempt(const char* doing, Items items, Call&& call)
{
    if (!failure_.empty()) return;
    const PluginCall noted(guarded_.plugin, doing, drawn(items, guarded_.object_name));
    try {
        call_plugin(guarded_.plugin, doing, "", "", std::forward<Call>(call));
    } catch (const Error& error) {
        failure_ = fmt::format("the style \"{}\" is drawn plain: {}", name_, error.what());
        log_error(failure_);
    }
}

void GuardedStyle::visit_params(ParamVisitor& visitor)
{
    attempt("visit_params", {}, [&] { style_->visit_params(visitor); });
}

void GuardedStyle::images(Pass& pass, Items items)
{
    attempt("images", items, [&] { style_->images(pass, items); });
}

void GuardedStyle::surfaces(Pass& pass, Items items)
{
    attempt("surfaces", items, [&] { style_->surfaces(pass, items); });
    if (!failure_.empty()) fallback_.surfaces(pass, items);
}

void GuardedStyle::lines(Pass& pass, Items items)
{
    attempt("lines", items, [&] { style_->lines(pass, items); });
}

GuardedImagePass::GuardedImagePass(Guarded guarded, std::unique_ptr<ImagePass> pass)
    : guarded_(std::move(guarded)), pass_(std::move(pass))
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
        log_error(fmt::format("the image pass \"{}\" makes no image: {}", guarded_.plugin, error.what()));
        return {};
    }
}

}  // namespace hw
