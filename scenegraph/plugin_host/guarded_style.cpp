#include "hatchway/plugin_host/guarded_style.hpp"

#include <fmt/format.h>

#include <utility>

#include "hatchway/core/log.hpp"
#include "hatchway/plugin_host/plugin_call.hpp"

namespace hw {

void PlainStyle::prepare(ProgramCache& programs)
{
    program_ = programs.surface("plain.frag");
}

void PlainStyle::surfaces(Pass& pass, Items items)
{
    pass.surfaces(program_, {}, items);
}

GuardedStyle::GuardedStyle(std::string name, std::unique_ptr<Style> style, Style& fallback)
    : name_(std::move(name)), fallback_(fallback)
{
    replace(std::move(style));
}

void GuardedStyle::replace(std::unique_ptr<Style> style)
{
    Needs needs = call_plugin(name_, "needs", "", "", [&] { return style->needs(); });
    style_ = std::move(style);
    needs_ = std::move(needs);
    failure_.clear();
}

template <typename Call>
void GuardedStyle::attempt(const char* doing, Call&& call)
{
    if (!failure_.empty()) return;
    try {
        call_plugin(name_, doing, "", "", std::forward<Call>(call));
    } catch (const Error& error) {
        failure_ = fmt::format("the style \"{}\" is drawn plain: {}", name_, error.what());
        log_error(failure_);
    }
}

void GuardedStyle::visit_params(ParamVisitor& visitor)
{
    attempt("visit_params", [&] { style_->visit_params(visitor); });
}

void GuardedStyle::images(Pass& pass, Items items)
{
    attempt("images", [&] { style_->images(pass, items); });
}

void GuardedStyle::surfaces(Pass& pass, Items items)
{
    attempt("surfaces", [&] { style_->surfaces(pass, items); });
    if (!failure_.empty()) fallback_.surfaces(pass, items);
}

void GuardedStyle::lines(Pass& pass, Items items)
{
    attempt("lines", [&] { style_->lines(pass, items); });
}

GuardedImagePass::GuardedImagePass(std::string name, std::unique_ptr<ImagePass> pass)
    : name_(std::move(name)), pass_(std::move(pass))
{
    needs_ = call_plugin(name_, "needs", "", "", [&] { return pass_->needs(); });
}

Images GuardedImagePass::make(Pass& pass, Items items)
{
    if (has_failed_) return {};
    try {
        return call_plugin(name_, "make", "", "", [&] { return pass_->make(pass, items); });
    } catch (const Error& error) {
        has_failed_ = true;
        log_error(fmt::format("the image pass \"{}\" makes no image: {}", name_, error.what()));
        return {};
    }
}

}  // namespace hw
