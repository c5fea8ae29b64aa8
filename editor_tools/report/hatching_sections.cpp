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
        .leaves_out =
            "Curved surfaces other than a sphere. Of the filters only trilinear and ordinary mips are the device's "
            "(here "
            "Mesa's on the processor); anisotropic is a formula of our shader. Distances lie off whole octaves, where "
            "every hatch map is at its best; where no line is left there is no spacing.",
        .says =
            "Spacing, stroke width, tone and contrast of hatch maps on planes and a sphere over distance and angle, "
            "against lines of one width and one spacing: our choice of the level, the device's filtering, ordinary "
            "mips "
            "and none. The summary is over all planes and the sphere.",
        .arguments = {"hatch", "--angles", "0,45,80,85", "--distances", "1.2,1.8,3,11,90,200,700"},
        .more = {"summary"},
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
    arguments.insert(arguments.end(), {"--by-hand", (maps / "bricks").string(), "--pen", "1.5"});
    return {
        .name = "ink",
        .title = "Ink maps",
        .judge =
            "The ink of level 0 and of the level before, of the same map, counted along rows and columns "
            "(measure/hatching/ink_level; reading a level as ink is the engine's).",
        .leaves_out =
            "Other hands: one map alone has levels that a person chose. Of maps as made, level 0 has half the tone of "
            "the others by design, so their tone_error is about 1; tone_step is the jump from the level before. Where "
            "strokes are gone there is no stroke error. Maps from pixels are drawn with the pen of the drawings, 1.5 "
            "texels, which a user has to name: an error of the pen is not seen here.",
        .says =
            "Width of strokes, tone and contrast of ink maps level by level: drawn anew from vectors (as made), level "
            "for level by a person (by hand), drawn anew from the pixels of level 0 alone (from pixels: bitmaps), and "
            "filtered by the minimum and the mean. Errors of tone are relative to the tone of the map's level 0. The "
            "summary has the largest tone_step of each kind over all maps, and where it is.",
        .arguments = std::move(arguments),
        .more = {"summary"},
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
    return {
        .name = "coherence",
        .title = "Hatching from frame to frame",
        .judge = "Places carried along by rays; two frames of the renderer.",
        .leaves_out =
            "Edges, and surfaces that bend by more than 30 degrees within 17 pixels. Ratios to the unfiltered map "
            "are taken where both have marks (common_places); their amounts of ink differ: ink_there, "
            "unfiltered_ink_there. Blank places (places less marked_places) count in no error; where "
            "there are no marks at all, as of ordinary mips, a row holds dashes.",
        .says =
            "Neighbouring frames, 48 pairs along the level's tour and two at each of its cameras (a step ahead, one "
            "to the side), warped by the true motion of the surface, flat and curved places apart: change of ink in 3 "
            "x 3 pixels and in single pixels, of tone within 16 pixels, and the "
            "way of marks over the surface. motion_px_median is how far the surface itself moves; of the 300 places "
            "tried in each pair of frames those in column places were one smooth surface in both. "
            "of_unfiltered_low and high: 95 % of the ratios when as many pairs of frames are drawn anew, with repeats. "
            "Costs are of four frames of the tour, 1280 x 720, with lines.",
        .arguments = {"coherence", level, "--frames", "48"},
        .more = {"costs"},
        .plots = {{.title = "Flicker against sliding",
                   .x_column = "pixel_flicker",
                   .x_label = "mean change of ink of a pixel from frame to frame",
                   .y_column = "slide_px_p95",
                   .y_label = "way of marks over the surface, pixels, 95th percentile",
                   .series_columns = {"path", "ink", "surface"}}}};
}

}  // namespace hw
