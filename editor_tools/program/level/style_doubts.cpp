#include "program/level/style_doubts.hpp"

#include <fmt/format.h>

#include <set>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/gl/gpu_program.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/param/param_rules.hpp"
#include "hatchway/plugin_host/make_style.hpp"
#include "hatchway/stage/whole_scene.hpp"

namespace hw {
namespace {

constexpr glm::ivec2 kRehearsalSize(64, 64);

/// Whose parameters are looked at: what the level names, and what came from other folders than the installation.
bool is_of_interest(const Plugin& plugin, const Stage& stage)
{
    for (const auto& [name, style] : stage.level().styles)
        if (style.plugin == plugin.name) return true;
    for (const ObjectLook& look : stage.looks())
        if (look.style == plugin.name || look.over == plugin.name) return true;
    return false;
}

void add_parameters(const Stage& stage, std::vector<std::string>& doubts)
{
    for (const Plugin& plugin : stage.plugins().plugins()) {
        if (plugin.kind == PluginKind::style && !is_of_interest(plugin, stage)) continue;
        ParamRules rules;
        visit_defaults(plugin, rules);
        for (const std::string& broken : rules.broken())
            doubts.push_back(fmt::format("the plugin \"{}\": {}", plugin.name, broken));
    }
}

void rehearse(Stage& stage, std::vector<std::string>& doubts)
{
    const View view =
        camera_view(whole_scene_camera(stage.scene(), 1.0), kRehearsalSize, stage.world().places.boxes_world);
    stage.draw(view, {.samples = 1, .use_pvs = false, .skips_hidden = false, .is_rehearsal = true});
    const std::vector<std::string> remarks = stage.renderer().remarks();
    doubts.insert(doubts.end(), remarks.begin(), remarks.end());
}

/// On an OpenGL ES context, where there is one.
void add_shaders_that_es_refuses(Context& context, const Stage& stage, std::vector<std::string>& doubts)
{
    const std::vector<ProgramText> shaders = stage.renderer().style_shaders();
    try {
        const auto es = make_headless_context({.is_es = true, .is_debug = false});
        std::set<std::filesystem::path> told;
        for (const ProgramText& shader : shaders) {
            try {
                const GpuProgram program(shader.vertex, shader.fragment, true);
            } catch (const Error& error) {
                if (told.insert(shader.fragment.files.at(1)).second)
                    doubts.push_back(std::string("OpenGL ES refuses a shader: ") + error.what());
            }
        }
    } catch (const Error& error) {
        log_info(std::string(error.what()) + ": shaders are not tried on OpenGL ES");
    }
    context.make_current();
}

}  // namespace

std::vector<std::string> style_doubts(Context& context, Stage& stage)
{
    std::vector<std::string> doubts;
    add_parameters(stage, doubts);
    rehearse(stage, doubts);
    add_shaders_that_es_refuses(context, stage, doubts);
    return doubts;
}

}  // namespace hw
