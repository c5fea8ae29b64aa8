#include "measure/frame/frame_series.hpp"

#include "measure/picture_difference.hpp"

namespace hw::measure {

std::vector<FrameSeries> draw_in_turn(std::span<const FrameVariant> variants, std::span<const View> views, int samples,
                                      const std::function<void()>& told)
{
    std::vector<FrameSeries> series(variants.size());
    FrameOptions options{.samples = samples, .is_timed = true};
    // What is made on first use is no part of a frame.
    for (const FrameVariant& variant : variants) variant.renderer->draw(views.front(), options);
    for (const View& view : views) {
        Pixels first;
        for (std::size_t i = 0; i < variants.size(); ++i) {
            options.use_pvs = variants[i].use_pvs;
            series[i].frames.push_back(variants[i].renderer->draw(view, options));
            const Pixels picture = variants[i].renderer->read_picture();
            if (i == 0) first = picture;
            series[i].unlike_share += unlike_share(picture, first) / static_cast<double>(views.size());
        }
        if (told) told();
    }
    return series;
}

}  // namespace hw::measure
