#include "hatchway/gl/context.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hatchway/core/error.hpp"
#include "hatchway/gl/gpu_target.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/gl/window.hpp"

namespace hw {
namespace {

using testing::IsEmpty;
using testing::Not;

TEST(context, a_headless_one_offers_opengl_3_3_without_errors)
{
    const auto context = make_headless_context();
    EXPECT_FALSE(context->device().is_es);
    EXPECT_GE(context->device().max_samples, 4);
    EXPECT_EQ(context->framebuffer_size_px(), glm::ivec2(0));
    EXPECT_THAT(context->take_errors(), IsEmpty());
}

TEST(context, a_headless_one_offers_es_3)
{
    const auto context = make_headless_context({.is_es = true});
    EXPECT_TRUE(context->device().is_es);
    EXPECT_THAT(context->take_errors(), IsEmpty());
}

TEST(context, two_live_side_by_side)
{
    const auto first = make_headless_context();
    const auto second = make_headless_context({.is_es = true});
    first->make_current();
    const GpuTarget target({.size_px = {4, 4}, .colours = {{TextureFormat::rgba8}}});
    target.bind();
    target.clear({1.0f, 0.0f, 0.0f, 1.0f});
    EXPECT_EQ(target.read_pixel(1, 1), glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
    EXPECT_THAT(first->take_errors(), IsEmpty());
    EXPECT_THAT(second->take_errors(), IsEmpty());
    first->make_current();
}

TEST(context, an_error_of_ours_is_reported_once)
{
    const auto context = make_headless_context();
    GpuTarget target({.size_px = {4, 4}, .colours = {{TextureFormat::rgba8}}});
    target.bind();
    target.clear_colour(-1, glm::vec4(0.0f));
    EXPECT_THAT(context->take_errors(), Not(IsEmpty()));
    EXPECT_THAT(context->take_errors(), IsEmpty());
}

TEST(context, a_target_larger_than_the_device_takes_is_refused)
{
    const auto context = make_headless_context();
    const int side = context->device().max_texture_side + 1;
    EXPECT_THROW(GpuTarget({.size_px = {side, 1}, .colours = {{TextureFormat::rgba8}}}), Error);
}

TEST(window, without_a_display_it_is_refused_as_a_missing_device)
{
    if (has_display()) GTEST_SKIP() << "there is a display";
    try {
        make_window({});
        FAIL() << "a window opened";
    } catch (const Error& error) {
        EXPECT_EQ(error.parts().fault, Fault::device);
        EXPECT_EQ(exit_code(error), 2);
    }
}

}  // namespace
}  // namespace hw
