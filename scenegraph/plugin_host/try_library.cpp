#include "hatchway/plugin_host/try_library.hpp"

#include <memory>
#include <new>
#include <optional>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/plugin_host/no_programs.hpp"
#include "hatchway/plugin_host/style_set.hpp"
#include "hatchway/plugin_host/trial/trial_process.hpp"
#include "hatchway/render/renderer.hpp"
#include "hatchway/render/view/camera_view.hpp"

namespace hw {
namespace {

namespace fs = std::filesystem;

const TrialReport* report_of_memory = nullptr;

/// A square of 2 m, `at_z` in front of the eye, with texture coordinates.
void add_square(Scene& scene, float at_z, AlphaMode alpha)
{
    MeshData mesh;
    mesh.positions = {{-1, -1, at_z}, {1, -1, at_z}, {1, 1, at_z}, {-1, 1, at_z}};
    mesh.normals.assign(4, glm::vec3(0, 0, 1));
    mesh.uv0 = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    Box bounds;
    for (const glm::vec3& point : mesh.positions) bounds.add(glm::dvec3(point));
    const int number = static_cast<int>(scene.objects.size());
    scene.meshes.push_back(std::move(mesh));
    Material& material = scene.materials.emplace_back();
    material.alpha_mode = alpha;
    material.base_colour.a = alpha == AlphaMode::blend ? 0.5f : 1.0f;
    scene.nodes.push_back({.name = "square", .path = "square"});
    scene.objects.push_back({.node = number, .mesh = number, .material = number, .bounds_world = bounds});
    scene.bounds_world.add(bounds);
}

/// Null when the registry refused it: the host will, too, and say why.
const Plugin* loaded_from(const fs::path& library, const PluginRegistry& registry)
{
    for (const Plugin& plugin : registry.plugins())
        if (plugin.library == library) return &plugin;
    return nullptr;
}

std::unique_ptr<Context> context_if_any()
{
    try {
        return make_headless_context();
    } catch (const Error&) {
        return nullptr;
    }
}

void prepare_blindly(const Plugin& plugin)
{
    NoPrograms programs;
    const auto ask = [&](const auto& instance) {
        instance->prepare(programs);
        instance->needs();
    };
    plugin.kind == PluginKind::style ? ask(make_style(plugin, {}, {})) : ask(make_image_pass(plugin, {}, {}));
}

void draw_small_frame(const PluginRegistry& registry, const Plugin& plugin, Renderer& renderer,
                      const TrialReport& report)
{
    Scene scene;
    add_square(scene, -4.0f, AlphaMode::opaque);
    add_square(scene, -3.0f, AlphaMode::blend);
    StyleSet styles(registry, [&](const fs::path& folder) -> ProgramCache& { return renderer.program_cache(folder); });
    SceneInput input;
    input.scene = &scene;
    input.objects.resize(scene.objects.size());
    FrameOptions options{.samples = 1};
    if (plugin.kind == PluginKind::image_pass) options.shown_image = ImageKey{plugin.name, {}};
    if (plugin.kind == PluginKind::style)
        for (StyledObject& object : input.objects) object.style = styles.use(plugin.name, "");
    input.lights.push_back({.type = LightType::sun, .direction_world = {0.0, -0.6, -0.8}});
    input.styles = styles.styles();
    input.image_passes = styles.image_passes();
    renderer.load(std::move(input));
    report.step("drawing a small frame");
    renderer.draw(camera_view({{0, 0, 0}, {0, 0, -4}, 60.0}, {64, 64}, scene.bounds_world), options);
    renderer.read_picture();
    report.step("being taken down");
}

}  // namespace

void try_library(const fs::path& library, const ImageReader& read_image)
{
    static const TrialReport report;
    report_of_memory = &report;
    std::set_new_handler([] { report_of_memory->fail_for_memory(); });
    set_log_level(LogLevel::off);
    report.step("being loaded");
    const PluginRegistry registry({.under_trial = library});
    const Plugin* plugin = loaded_from(library, registry);
    const std::unique_ptr<Context> context = plugin != nullptr ? context_if_any() : nullptr;
    try {
        if (plugin != nullptr) report.step("being prepared");
        if (context)
            draw_small_frame(registry, *plugin, *std::make_unique<Renderer>(*context, read_image), report);
        else if (plugin != nullptr)
            prepare_blindly(*plugin);
    } catch (const std::exception&) {
        // Told again, with its reason, where the plugin is used.
    }
    report.end(plugin == nullptr || context != nullptr);
}

}  // namespace hw
