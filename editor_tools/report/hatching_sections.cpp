#include "report/hatching_sections.hpp"

namespace hw {

ReportSection hatch_section()
{
    return {
        .name = "hatch",
        .title = "Hatch maps",
        .judge =
            "Columns of pixels, compared with lines of one width and one spacing (hatch_profile, no code of the "
            "engine).",
        .leaves_out = "Curved surfaces other than a sphere.",
        .says =
            "Spacing, stroke width, tone and contrast of hatch maps on planes and a sphere over distance and angle, "
            "against lines of one width and one spacing: our choice of the level, hardware filtering, ordinary mips "
            "and none.",
        .arguments = {"hatch", "--angles", "0,45,80", "--distances", "1,1.4,8,64,256"},
        .plots = {{.title = "Time against tone error",
                   .x_column = "ms",
                   .x_label = "ms for a picture of 64 x 512",
                   .y_column = "tone_rms",
                   .y_label = "RMS of tone, box-blurred over two spacings",
                   .series_columns = {"choice"}},
                  {.title = "Spacing by ink over distance",
                   .x_column = "distance",
                   .x_label = "distance; 1: a texel covers a pixel",
                   .y_column = "ink_spacing_median",
                   .y_label = "relative error, median",
                   .series_columns = {"choice"}}}};
}

ReportSection ink_section(const std::filesystem::path& maps)
{
    std::vector<std::string> arguments{"ink"};
    for (const char* name : {"stone_courses", "flagstones", "planks", "roof_tiles"})
        arguments.push_back((maps / name).string());
    return {
        .name = "ink",
        .title = "Ink maps",
        .judge = "The ink of level 0 and of the level before, of the same map, counted along rows and columns.",
        .leaves_out =
            "Maps whose levels are drawn by hand: they are shown as they are. Level 0 has half the tone of the others "
            "by design, so their tone_error is about 1; tone_step is the jump from the level before.",
        .says =
            "Width of strokes, tone and contrast of ink maps level by level: drawn anew from vectors (as made), from "
            "the pixels of level 0 alone (from pixels), and filtered by the minimum and the mean. Errors of tone are "
            "relative to the map's own.",
        .arguments = std::move(arguments),
        .plots = {{.title = "Tone of the levels",
                   .x_column = "level",
                   .x_label = "level",
                   .y_column = "tone",
                   .y_label = "ink coverage",
                   .series_columns = {"map", "filter"},
                   .is_joined = true}}};
}

ReportSection coherence_section(const std::string& level)
{
    return {.name = "coherence",
            .title = "Hatching from frame to frame",
            .judge = "Places carried along by rays; two frames of the renderer.",
            .leaves_out =
                "Edges, and surfaces that bend by more than 30 degrees within 17 pixels. Ratios to the unfiltered map "
                "are taken where both have marks (common_places); their amounts of ink differ: ink_there, "
                "unfiltered_ink_there.",
            .says =
                "Neighbouring frames along the level's tour, warped by the true motion of the surface, flat and curved "
                "places apart: change of ink in 3 x 3 pixels and in single pixels, of tone within 16 pixels, and the "
                "way of marks over the surface. Costs at 1280 x 720 with lines, 1 and 4 samples, are in the JSON.",
            .arguments = {"coherence", level, "--frames", "6"},
            .plots = {{.title = "Flicker against sliding",
                       .x_column = "pixel_flicker",
                       .x_label = "mean change of ink of a pixel from frame to frame",
                       .y_column = "slide_px_p95",
                       .y_label = "way of marks over the surface, pixels, 95th percentile",
                       .series_columns = {"ink", "surface"}}}};
}

}  // namespace hw
