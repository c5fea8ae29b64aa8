// Needs::clock and what changes with time: what docs/write_a_style.md promises, and what a walk that stands still
// relies on.
#include <gmock/gmock.h>

#include "tests/render/style/scripted_style.hpp"

namespace hw::test {
namespace {

class frame_clock : public RendererTest {
 protected:
    frame_clock() { add_object(scene_, box_mesh(glm::vec3(1.0f)), glm::dmat4(1.0), painted(glm::vec3(1.0f))); }

    bool changes_at(double time_s)
    {
        View view = view_from({0, 0, 4}, {0, 0, 0});
        view.time_s = time_s;
        draw(view);
        return stats_.changes_with_time;
    }

    ScriptedStyle style_;
};

TEST_F(frame_clock, is_0_for_a_style_that_does_not_need_it)
{
    double told_s = -1.0;
    style_.draws_surfaces = [&](Pass& pass, Items) { told_s = pass.view().time_s; };
    load(style_);
    EXPECT_FALSE(changes_at(2.5));
    EXPECT_EQ(told_s, 0.0);
}

TEST_F(frame_clock, makes_a_frame_change_with_time_while_a_style_that_needs_it_is_visible)
{
    style_.needed.clock = true;
    load(style_);
    EXPECT_TRUE(changes_at(2.5));
    draw(view_from({0, 0, 4}, {0, 0, 8}));
    EXPECT_FALSE(stats_.changes_with_time) << "the box is behind the eye";
}

TEST_F(frame_clock, is_read_by_a_presence_until_its_ramp_is_at_its_end)
{
    ScriptedStyle over;
    load({{"style", &style_}, {"over", &over}}, {{.style = 0, .over = 1, .presence = {.time = Ramp{1.0f, 3.0f}}}});
    EXPECT_TRUE(changes_at(0.0));
    EXPECT_TRUE(changes_at(2.5));
    EXPECT_FALSE(changes_at(3.0));
}

TEST_F(frame_clock, is_read_by_a_share_of_lines_until_its_ramp_is_at_its_end)
{
    style_.needed.edges = EdgeNeed{};
    style_.draws_lines = [](Pass& pass, Items items) {
        LineLook look;
        look.share.time = Ramp{3.0f, 1.0f};
        pass.lines(look, items);
    };
    load(style_);
    EXPECT_TRUE(changes_at(2.5));
    EXPECT_FALSE(changes_at(3.0));
}

}  // namespace
}  // namespace hw::test
