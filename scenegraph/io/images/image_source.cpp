#include "hatchway/io/images/image_source.hpp"

#include <fmt/format.h>

#include "hatchway/core/error.hpp"
#include "hatchway/core/limits.hpp"

namespace hw {

void check_image_size(std::uint64_t width, std::uint64_t height, const ImageSource& source)
{
    const auto side = static_cast<std::uint64_t>(limits::kMaxImageSide);
    const bool is_allowed =
        width > 0 && height > 0 && width <= side && height <= side && width * height <= source.max_pixels;
    if (is_allowed) return;
    throw Error({.what = fmt::format("is an image of {} x {} pixels", width, height),
                 .file = source.name,
                 .expected = fmt::format("sides of 1 to {} and at most {} pixels", side, source.max_pixels)});
}

}  // namespace hw
