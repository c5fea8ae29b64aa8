// What the author does while walking, on a copy of the paper's prism, with a context but no window.
#include "hatchway/walk/walk_styles.hpp"
#include "hatchway/gl/headless_context.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/io/level/edit.hpp"
#include "hatchway/io/level/file.hpp"
#include "hatchway/world/looks.hpp"

namespace {

namespace fs = std::filesystem;

class WalkStylesTest : public testing::Test {
 protected:
    void SetUp() override
    {
        folder_ = fs::temp_directory_path() / ("hatchway_walk_styles_" + std::to_string(::getpid()));
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        for (const char* name : {"levels", "models", "maps"})
            fs::copy(fs::path(HATCHWAY_SOURCE_DIR) / "content" / name, folder_ / name, fs::copy_options::recursive);
        try {
            context_ = hw::make_headless_context();
        } catch (const hw::Error& error) {
            GTEST_SKIP() << error.what();
        }
    }
    void TearDown() override
    {
        stage_.reset();
        fs::remove_all(folder_);
    }

    void open(const fs::path& file, std::vector<std::string> style_overrides = {})
    {
        stage_ = std::make_unique<hw::Stage>(*context_, hw::StageOptions{.file = file,
                                                                         .style_overrides = std::move(style_overrides),
                                                                         .visibility_use = hw::VisibilityUse::none});
    }
    fs::path level() const { return folder_ / "levels" / "prism.level.json"; }
    fs::path model() const { return folder_ / "models" / "prism.glb"; }

    /// The style of an object as the file says it, without a stage.
    std::string style_in(const fs::path& file, hw::ObjectId object = 0) const
    {
        return hw::resolve_looks(hw::read_level(file), stage_->scene(), hw::kFallbackStyle)[object].style;
    }

    fs::path folder_;
    std::unique_ptr<hw::Context> context_;
    std::unique_ptr<hw::Stage> stage_;
};

}  // namespace

TEST_F(WalkStylesTest, a_cycled_style_shows_and_is_not_in_the_file_before_it_is_saved)
{
    open(level());
    hw::WalkStyles styles(*stage_);
    const std::string before = stage_->looks()[0].style;
    styles.cycle(0, 1);
    EXPECT_NE(stage_->looks()[0].style, before);
    EXPECT_EQ(style_in(level()), before);
    EXPECT_TRUE(styles.has_unsaved());
    styles.save();
    EXPECT_EQ(style_in(level()), stage_->looks()[0].style);
    EXPECT_FALSE(styles.has_unsaved());
}

TEST_F(WalkStylesTest, saving_keeps_comments_and_everything_else)
{
    open(level());
    hw::WalkStyles styles(*stage_);
    styles.cycle(0, 1);
    styles.save();
    const std::string text = hw::read_text_file(level(), 1 << 20);
    EXPECT_NE(text.find("// The prism of"), std::string::npos);
    EXPECT_EQ(hw::read_level(level()).cameras.size(), stage_->level().cameras.size());
}

TEST_F(WalkStylesTest, a_full_round_of_styles_ends_where_it_began)
{
    open(level());
    hw::WalkStyles styles(*stage_);
    const std::string first = stage_->looks()[0].style;
    for (std::size_t i = 0; i < stage_->style_names().size(); ++i) styles.cycle(0, 1);
    EXPECT_EQ(stage_->looks()[0].style, first);
}

TEST_F(WalkStylesTest, undo_after_saving_is_saved_too)
{
    open(level());
    hw::WalkStyles styles(*stage_);
    const std::string before = style_in(level());
    styles.cycle(0, 1);
    styles.save();
    styles.undo();
    EXPECT_EQ(stage_->looks()[0].style, before);
    styles.save();
    EXPECT_EQ(style_in(level()), before);
}

TEST_F(WalkStylesTest, saving_over_and_over_does_not_make_the_file_grow)
{
    open(level());
    hw::WalkStyles styles(*stage_);
    styles.cycle(0, 1);
    styles.save();
    const std::size_t entries = hw::read_level(level()).assign.size();
    for (int i = 0; i < 6; ++i) {
        styles.cycle(0, 1);
        styles.save();
        EXPECT_EQ(style_in(level()), stage_->looks()[0].style) << i;
    }
    EXPECT_LE(hw::read_level(level()).assign.size(), entries + 1);
}

TEST_F(WalkStylesTest, what_another_editor_says_of_a_saved_object_wins)
{
    open(level());
    hw::WalkStyles styles(*stage_);
    styles.cycle(0, 1);
    styles.save();
    styles.stage_changed();
    const std::string saved = style_in(level());
    std::string text = hw::read_text_file(level(), 1 << 20);
    const std::string other = saved == "drawn" ? "real" : "drawn";
    const std::size_t place = text.rfind("\"style\": \"" + saved + '"');
    ASSERT_NE(place, std::string::npos);
    text.replace(place, std::string("\"style\": \"" + saved + '"').size(), "\"style\": \"" + other + '"');
    hw::write_file_atomically(level(), std::string_view(text));
    open(level());
    EXPECT_EQ(stage_->looks()[0].style, other);
}

TEST_F(WalkStylesTest, styles_of_the_command_line_are_not_saved_by_accident)
{
    open(level(), {"*=photoreal"});
    hw::WalkStyles styles(*stage_);
    EXPECT_EQ(stage_->looks()[0].style, "photoreal");
    EXPECT_EQ(styles.save(), "Nothing to save");
    EXPECT_EQ(style_in(level()), "drawn");
}

TEST_F(WalkStylesTest, a_bare_model_is_saved_as_a_level_beside_it)
{
    open(model(), {"*=pen_and_ink"});
    hw::WalkStyles styles(*stage_);
    styles.cycle(0, 1);
    const std::string shown = stage_->looks()[0].style;
    const fs::path file = hw::level_file_for(model());
    styles.save_as(file, {{1, 2, 3}, {0, 1, 0}}, {"*=pen_and_ink"});
    EXPECT_EQ(file.filename(), "prism.level.json");
    EXPECT_EQ(style_in(file), shown);
    ASSERT_TRUE(hw::read_level(file).start.has_value());
    EXPECT_EQ(hw::read_level(file).start->position, glm::dvec3(1, 2, 3));
    EXPECT_THROW(styles.save_as(file, {}, {}), hw::Error) << "a file that is there is never replaced";
}

TEST_F(WalkStylesTest, what_is_not_saved_is_offered_to_the_next_walk)
{
    open(level());
    std::string shown, kept;
    {
        hw::WalkStyles styles(*stage_);
        EXPECT_EQ(styles.unsaved_text(), "");
        styles.cycle(0, 1);
        shown = stage_->looks()[0].style;
        kept = styles.unsaved_text();
    }
    open(level());
    hw::WalkStyles styles(*stage_);
    EXPECT_NE(styles.offer(kept), "");
    EXPECT_NE(stage_->looks()[0].style, shown) << "offered, not done";
    EXPECT_EQ(styles.unsaved_text(), kept) << "and not lost before it is taken up";
    styles.redo();
    EXPECT_EQ(stage_->looks()[0].style, shown);
    EXPECT_TRUE(styles.has_unsaved());
    styles.save();
    EXPECT_EQ(style_in(level()), shown);
    EXPECT_EQ(styles.unsaved_text(), "");
    EXPECT_THROW(styles.offer("{ broken"), hw::Error);
}

TEST_F(WalkStylesTest, two_walks_that_save_one_level_both_keep_their_changes)
{
    open(level());
    hw::WalkStyles one(*stage_);
    one.cycle(0, 1);
    const std::string shown = stage_->looks()[0].style;
    hw::edit_level_file(level(), [](const hw::Level&) {
        return std::vector<hw::StyleAssignment>{{.nodes = "Elsewhere", .style = "drawn"}};
    });
    EXPECT_NE(one.save().find("changed elsewhere"), std::string::npos);
    EXPECT_EQ(style_in(level()), shown);
    const hw::Level saved = hw::read_level(level());
    EXPECT_TRUE(std::any_of(saved.assign.begin(), saved.assign.end(),
                            [](const hw::AssignRule& rule) { return rule.nodes == "Elsewhere"; }));
    one.cycle(0, 1);
    EXPECT_EQ(one.save().find("changed elsewhere"), std::string::npos) << "told once";
}

TEST_F(WalkStylesTest, what_cannot_be_saved_stays_unsaved)
{
    open(model());
    hw::WalkStyles styles(*stage_);
    styles.cycle(0, 1);
    EXPECT_THROW(styles.save_as(folder_ / "nowhere" / "a.level.json", {}, {}), hw::Error);
    EXPECT_TRUE(styles.has_unsaved());
    EXPECT_NE(styles.unsaved_text(), "");
}

TEST_F(WalkStylesTest, what_is_hidden_is_saved_as_a_rule_and_shown_again_in_one_step)
{
    open(level());
    hw::WalkStyles styles(*stage_);
    const auto hidden = [&] { return stage_->scene().hidden.size(); };
    const auto style = stage_->looks()[0].style;
    EXPECT_NE(styles.hide(0).find("hidden"), std::string::npos);
    EXPECT_EQ(hidden(), 1u);
    styles.undo();
    EXPECT_EQ(hidden(), 0u);
    styles.redo();
    const std::string kept = styles.unsaved_text();
    styles.save();
    const hw::AssignRule saved = hw::read_level(level()).assign.back();
    EXPECT_EQ(saved.visible, false);
    EXPECT_FALSE(saved.style) << "hiding says nothing of styles";
    std::this_thread::sleep_for(std::chrono::milliseconds(260));
    stage_->reload_changed();
    styles.stage_changed();
    EXPECT_EQ(hidden(), 1u);
    EXPECT_NE(styles.show_all().find("1 object is shown"), std::string::npos);
    EXPECT_EQ(hidden(), 0u);
    EXPECT_EQ(stage_->looks()[0].style, style);
    EXPECT_EQ(styles.show_all(), "Nothing is hidden");
    styles.save();
    EXPECT_EQ(hw::resolve_looks(hw::read_level(level()), stage_->scene(), hw::kFallbackStyle)[0].is_visible, true);

    open(level());
    hw::WalkStyles next(*stage_);
    EXPECT_NE(next.offer(kept), "");
    next.redo();
    EXPECT_EQ(hidden(), 1u) << "an offer brings back what was hidden";
    EXPECT_EQ(stage_->looks()[0].style, style);
}

TEST_F(WalkStylesTest, the_certainty_is_told_with_the_style)
{
    open(level());
    hw::WalkStyles styles(*stage_);
    EXPECT_NE(styles.cycle(0, 1).find("certainty"), std::string::npos);
}

TEST(level_file_for, stands_beside_the_model)
{
    EXPECT_EQ(hw::level_file_for("models/teapot.glb"), fs::path("models/teapot.level.json"));
    EXPECT_EQ(hw::level_file_for("a.b.glb"), fs::path("a.b.level.json"));
}

TEST(level_file_for, keeps_within_what_a_file_system_takes_and_cuts_no_character)
{
    const std::string name(246, 'a');
    EXPECT_EQ(hw::level_file_for("m/" + name + ".glb"), fs::path("m/" + name.substr(0, 244) + ".level.json"));
    std::string greek;
    for (int i = 0; i < 123; ++i) greek += "\xce\xb1";
    EXPECT_EQ(hw::level_file_for(greek + "a.glb").string(), greek.substr(0, 244) + ".level.json");
    EXPECT_EQ(hw::level_file_for('a' + greek + ".glb").string(), 'a' + greek.substr(0, 242) + ".level.json");
    EXPECT_TRUE(hw::is_level_file("a/hall.level.json"));
    EXPECT_FALSE(hw::is_level_file("a/hall.glb"));
}
