#include "hatchway/render/frame_phases.hpp"

#include <algorithm>

#include "hatchway/render/opaque_faces.hpp"
#include "hatchway/render/style_pass.hpp"

namespace hw {
namespace {

StylePass pass_of(const Frame& frame, int style, PassStage stage)
{
    const LoadedScene& scene = frame.scene;
    return {frame,
            stage,
            {"the style \"" + scene.input.styles[style].name + '"', scene.needs[style], scene.style_maps[style]}};
}

Style& style_of(const Frame& frame, int style)
{
    return *frame.scene.input.styles[style].style;
}

int style_count(const Frame& frame)
{
    return static_cast<int>(frame.view.plan.styles.size());
}

std::vector<DrawItem> opaque_items(const StyleItems& of_style)
{
    std::vector<DrawItem> items = of_style.base;
    items.insert(items.end(), of_style.over.begin(), of_style.over.end());
    return items;
}

/// Whether some style of the scene draws lines, seen or not.
bool has_lines(const LoadedScene& scene)
{
    const auto draws_lines = [&](int style) { return style != kNone && scene.needs[style].edges.has_value(); };
    return std::any_of(scene.input.objects.begin(), scene.input.objects.end(), [&](const StyledObject& object) {
        return draws_lines(object.style) || draws_lines(object.over);
    });
}

void draw_opaque(const Frame& frame, PassStage stage, std::vector<DrawItem> StyleItems::*items_of)
{
    for (int i = 0; i < style_count(frame); ++i) {
        const std::vector<DrawItem>& items = frame.view.plan.styles[i].*items_of;
        if (items.empty()) continue;
        StylePass pass = pass_of(frame, i, stage);
        style_of(frame, i).surfaces(pass, items);
        frame.device.state.apply({});
    }
}

}  // namespace

void draw_products(const Frame& frame)
{
    LoadedScene& scene = frame.scene;
    const int shadow_side_px = frame.view.options.is_rehearsal ? ShadowMap::kRehearsalSidePx : ShadowMap::kSidePx;
    const auto prepare = [&](const Needs& needs) {
        frame.results.reads_clock |= needs.clock;
        if (needs.lightmap) scene.lightmap.prepare();
        const bool is_all_baked = needs.lightmap && scene.is_all_baked;
        if (needs.shadow == ShadowNeed::main_light && !is_all_baked)
            scene.shadow.prepare(*scene.input.scene, frame.view.viewer_world, scene.repeats, scene.gpu, scene.light,
                                 frame.device.programs, frame.device.state, shadow_side_px);
    };
    for (int i = 0; i < style_count(frame); ++i)
        if (!frame.view.plan.styles[i].is_empty()) prepare(scene.needs[i]);
    for (const WantedImage& image : frame.view.images) prepare(scene.images.at(image.key).needs);
    View told = frame.view.camera;
    if (!frame.results.reads_clock) told.time_s = 0.0;
    stream_frame_block(frame.device.frame_block, told, scene.light, scene.shadow.frame());
}

void draw_images(const Frame& frame)
{
    for (const WantedImage& wanted : frame.view.images) {
        const NeededImage& image = frame.scene.images.at(wanted.key);
        StylePass pass(frame, PassStage::images,
                       {"the image pass \"" + wanted.key.pass + '"', image.needs, image.maps});
        frame.results.images[wanted.key] =
            image.pass->make(pass, items_of(image, wanted.is_shown, frame.scene.input, frame.whole()));
        frame.device.state.apply({});
    }
    for (int i = 0; i < style_count(frame); ++i) {
        const StyleItems& of_style = frame.view.plan.styles[i];
        if (of_style.is_empty()) continue;
        std::vector<DrawItem> items = opaque_items(of_style);
        items.insert(items.end(), of_style.blended.begin(), of_style.blended.end());
        StylePass pass = pass_of(frame, i, PassStage::images);
        style_of(frame, i).images(pass, items);
        frame.device.state.apply({});
    }
}

void draw_surfaces(const Frame& frame)
{
    frame.view.picture.bind();
    frame.device.state.apply({});
    frame.view.picture.clear(glm::vec4(frame.scene.light.background_linear, 1.0f));
    draw_opaque(frame, PassStage::base, &StyleItems::base);
    draw_opaque_faces(frame);
    draw_opaque(frame, PassStage::over, &StyleItems::over);
}

void draw_lines(const Frame& frame)
{
    if (has_lines(frame.scene)) lay_line_depth(frame);
    for (int i = 0; i < style_count(frame); ++i) {
        const std::vector<DrawItem> items = opaque_items(frame.view.plan.styles[i]);
        if (items.empty()) continue;
        StylePass pass = pass_of(frame, i, PassStage::lines);
        style_of(frame, i).lines(pass, items);
        frame.device.state.apply({});
    }
}

void draw_blended(const Frame& frame)
{
    for (const StyleRun& run : frame.view.plan.blended_runs) {
        StylePass pass = pass_of(frame, run.style, PassStage::blended);
        style_of(frame, run.style).surfaces(pass, run.items);
        frame.device.state.apply({});
        style_of(frame, run.style).lines(pass, run.items);
        frame.device.state.apply({});
    }
}

void show_image(const Frame& frame, const ImageKey& key)
{
    const Image image = frame.results.images[key][0];
    const char* defines = is_whole_number(image.format) ? "#define HW_WHOLE_NUMBERS 1\n" : "";
    const LinkedProgram& program = frame.device.programs.engine("full_screen.vert", "images/show_image.frag", defines);
    frame.view.picture.bind();
    draw_full_screen(frame.device, program.gpu, Uniforms().set("shown", image));
}

}  // namespace hw
