#include "measure/lines/line_style.hpp"

#include "hatchway/plugin_host/make_style.hpp"

namespace hw {
namespace {

constexpr double kWidthPx = 1.5;  // of all classes, so that GL_LINES can draw them

}  // namespace

std::unique_ptr<Style> line_style(const PluginRegistry& plugins, const std::string& asked_by)
{
    const StyleSource source{asked_by, ""};
    const Plugin& plugin = require_plugin(plugins, "pen_and_ink", PluginKind::style, source);
    ParamSettings params;
    const auto set = [&](const char* name, ParamValue value) { params[name] = {std::move(value), name}; };
    set("tone", std::string("none"));
    set("ink_colour", std::string("#000000"));
    set("paper_colour", std::string("#ffffff"));
    set("ink_map_strength", 0.0);
    set("crease_deg", kMeasuredCreaseDeg);
    set("crease_colour", std::string("#000000"));
    for (const char* name :
         {"line_width_px", "valley_width_px", "intersection_width_px", "silhouette_width_px", "border_width_px"})
        set(name, kWidthPx);
    return make_style(plugin, params, source);
}

}  // namespace hw
