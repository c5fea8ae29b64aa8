#include "hatchway/walk/walk_overlay.hpp"

#include <gtest/gtest.h>

#include "hatchway/walk/controls.hpp"

namespace {

std::string all_text(const hw::WalkFacts& facts)
{
    std::string text;
    for (const hw::OverlayText& block : hw::walk_overlay(facts).texts) text += block.text + '\n';
    return text;
}

bool has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST(walk_overlay, says_how_to_free_the_mouse_while_it_is_taken_and_how_to_quit_while_it_is_free)
{
    EXPECT_TRUE(has(all_text({.is_mouse_captured = true}), "Esc frees the mouse"));
    EXPECT_TRUE(has(all_text({.is_mouse_captured = false}), "Q quit"));
}

TEST(walk_overlay, says_what_pacing_does)
{
    EXPECT_TRUE(has(all_text({.fps = 29.7, .quality = "1 sample, 70 % of the resolution"}),
                    "30 fps, 1 sample, 70 % of the resolution"));
}

TEST(walk_overlay, names_the_object_under_the_cross_hair_and_its_style)
{
    EXPECT_TRUE(has(all_text({.object = "Hall/Column_02", .style = "assumed"}), "Hall/Column_02: assumed"));
    EXPECT_FALSE(has(all_text({}), "Tab changes"));
}

TEST(walk_overlay, tells_the_certainty_of_the_object_under_the_cross_hair)
{
    const std::string text = all_text({.object = "Hall/Column_02", .style = "assumed", .certainty = 0.3});
    EXPECT_TRUE(has(text, "Hall/Column_02: assumed, certainty 0.3")) << text;
}

TEST(walk_overlay, lines_at_the_bottom_do_not_lie_on_each_other)
{
    for (const float width : {400.0f, 900.0f, 1280.0f, 3000.0f}) {
        const hw::WalkFacts facts{
            .object = "Hall/Column", .style = "ink", .quality = "1 sample, 70 % of the resolution", .width = width};
        const auto overlay = hw::walk_overlay(facts);
        for (const hw::OverlayText& a : overlay.texts)
            for (const hw::OverlayText& b : overlay.texts) {
                if (&a == &b || a.position_px.y != b.position_px.y) continue;
                EXPECT_LT(12.0f * static_cast<float>(a.text.size() + b.text.size()), width) << a.text << b.text;
            }
    }
}

TEST(walk_overlay, shows_every_key_on_demand)
{
    const std::string text = all_text({.is_help_shown = true, .cameras = {"door", "well"}});
    for (const hw::KeyHelp& line : hw::key_help()) EXPECT_TRUE(has(text, line.keys)) << line.keys;
    EXPECT_TRUE(has(text, "2 well"));
}

TEST(walk_overlay, errors_come_first_and_are_not_cut_off)
{
    hw::WalkFacts facts{
        .problems = {"hall.level.json: /styles/assumed/crease_deg: 400 is too large; expected 0 to 180"},
        .notices = {"Saved"},
        .width = 320.0f};
    const hw::Overlay overlay = hw::walk_overlay(facts);
    ASSERT_FALSE(overlay.texts.empty());
    EXPECT_TRUE(has(overlay.texts[0].text, "expected 0 to 180") || has(overlay.texts[0].text, "expected\n0 to 180"))
        << overlay.texts[0].text;
    EXPECT_GT(overlay.texts[1].position_px.y, overlay.texts[0].position_px.y);
    facts.problems.assign(12, "broken");
    EXPECT_TRUE(has(all_text(facts), "and 8 more"));
}

TEST(wrapped, breaks_between_words_where_it_can)
{
    EXPECT_EQ(hw::wrapped("one two three", 8), "one two\nthree");
    EXPECT_EQ(hw::wrapped("abcdefghij", 4), "abcd\nefgh\nij");
    EXPECT_EQ(hw::wrapped("a\nlonger line", 8), "a\nlonger\nline");
    EXPECT_EQ(hw::wrapped("", 8), "");
}

TEST(wrapped, no_line_is_longer_than_asked)
{
    const std::string text =
        hw::wrapped("a path/that/is/rather/long and words, more words and evenmorewordswithoutspace", 13);
    std::size_t length = 0;
    for (const char c : text) {
        length = c == '\n' ? 0 : length + 1;
        EXPECT_LE(length, 13u) << text;
    }
}
