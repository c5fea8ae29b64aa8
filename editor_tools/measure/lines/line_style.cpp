#include "measure/lines/line_style.hpp"

#include "hatchway/plugin_host/make_style.hpp"

namespace hw {
namespace {

constexpr double kCreaseWidthPx = 1.2;
constexpr double kContourWidthPx = 1.9;

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
    for (const char* name : {"line_width_px", "valley_width_px", "intersection_width_px"}) set(name, kCreaseWidthPx);
    for (const char* name : {"silhouette_width_px", "border_width_px"}) set(name, kContourWidthPx);
    return make_style(plugin, params, source);
}

}  // namespace hw
