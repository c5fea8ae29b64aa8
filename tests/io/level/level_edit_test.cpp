#include "hatchway/io/level/edit.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <random>

#include "hatchway/core/files/files.hpp"
#include "hatchway/io/level/file.hpp"
#include "tests/io/expect_error.hpp"
#include "tests/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using Assignments = std::vector<hw::StyleAssignment>;

constexpr const char* kLevel = R"({
  "format": "hatchway-level/1",
  "scene": "hall.glb",   // the hall
  "styles": {"ink": {"plugin": "pen_and_ink"}},
  "assign": [
    // everything first
    {"nodes": "*", "style": "ink"},
    {"nodes": "Hall/*", "certainty": 0.4}   /* known in part */
    // add more here
  ],
  "exposure_ev": 12
}
)";

class EditedLevel {
 public:
    EditedLevel()
    {
        folder_.write("hall.glb", "not opened");
        file_ = folder_.write("hall.level.json", kLevel);
    }
    std::string edit(const std::string& text, const Assignments& assignments) const
    {
        return hw::with_assignments(text, assignments, file_);
    }
    hw::LevelTexts save(const Assignments& assignments) const
    {
        return hw::edit_level_file(file_, [&](const hw::Level&) { return assignments; });
    }
    hw::Level parse(const std::string& text) const { return hw::parse_level(text, file_); }
    const fs::path& file() const { return file_; }

 private:
    TemporaryFolder folder_;
    fs::path file_;
};

std::string with_list(const std::string& list)
{
    return R"({"format": "hatchway-level/1", "scene": "hall.glb", "assign": )" + list + "}";
}

/// Levels with comments, blanks and line ends wherever JSON allows them.
class RandomLevels {
 public:
    std::string text()
    {
        std::string text = gap() + "{" + gap() + R"("format":)" + gap() + R"("hatchway-level/1")" + gap() + "," +
                           gap() + R"("scene": "hall.glb")" + gap();
        if (below(4) != 0) text += "," + gap() + R"("assign":)" + gap() + list() + gap();
        if (below(2) != 0) text += "," + gap() + R"("exposure_ev": 12)" + gap();
        return text + "}" + gap();
    }
    hw::StyleAssignment assignment()
    {
        hw::StyleAssignment made{.nodes = "New_" + std::to_string(below(3)), .style = below(2) ? "ink" : "photoreal"};
        if (below(2) != 0) made.materials = "Stone";
        if (below(3) == 0) made.over = "hybrid";
        return made;
    }

 private:
    int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    std::string gap()
    {
        static constexpr const char* kGaps[]{"", " ", "\n", "\r\n  ", "\t", " /* ]}, \" */ ", " // [{,\n", "\n\n    "};
        return kGaps[below(8)];
    }
    std::string list()
    {
        std::string text = "[" + gap();
        const int count = below(4);
        for (int i = 0; i < count; ++i)
            text += (i > 0 ? "," + gap() : "") + R"({"nodes":)" + gap() + '"' + static_cast<char>('A' + i) + R"(/*")" +
                    gap() + "," + gap() + R"("style": "ink"})" + gap();
        return text + "]";
    }

    std::mt19937 random_{7};
};

/// What `after` has more than `before`, when `before` is all there, in order; nothing else.
std::optional<std::string> added(const std::string& before, const std::string& after)
{
    std::string more;
    std::size_t next = 0;
    for (const char c : after) {
        if (next < before.size() && before[next] == c)
            ++next;
        else
            more += c;
    }
    if (next < before.size()) return {};
    return more;
}

}  // namespace

TEST(level_edit, what_is_hidden_is_a_rule_of_its_own_and_replaces_only_its_like)
{
    const EditedLevel level;
    const std::string hidden = level.edit(kLevel, {{.nodes = "Roof", .visible = false}});
    EXPECT_EQ(level.parse(hidden).assign.back().visible, false);
    EXPECT_FALSE(level.parse(hidden).assign.back().style);
    const std::string inked = level.edit(hidden, {{.nodes = "Roof", .style = "ink"}});
    EXPECT_EQ(level.parse(inked).assign.size(), 4u);
    const std::string shown =
        level.edit(inked, {{.nodes = "Roof", .visible = true}, {.nodes = "Roof", .style = "ink"}});
    const hw::Level last = level.parse(shown);
    EXPECT_EQ(last.assign.back().style, "ink");
    EXPECT_EQ(last.assign.at(last.assign.size() - 2).visible, true);
    EXPECT_LE(last.assign.size(), 5u);
}

TEST(level_edit, an_assignment_goes_to_the_end_and_all_else_stays)
{
    const EditedLevel level;
    const std::string text = level.edit(kLevel, {{.nodes = "Hall/Column", .style = "photoreal"}});
    const std::string expected = std::string(R"({
  "format": "hatchway-level/1",
  "scene": "hall.glb",   // the hall
  "styles": {"ink": {"plugin": "pen_and_ink"}},
  "assign": [
    // everything first
    {"nodes": "*", "style": "ink"},
    {"nodes": "Hall/*", "certainty": 0.4},   /* known in part */
    // add more here
    {"nodes": "Hall/Column", "style": "photoreal"}
  ],
  "exposure_ev": 12
}
)");
    EXPECT_EQ(text, expected);
}

TEST(level_edit, pressing_the_key_again_replaces_what_it_wrote)
{
    const EditedLevel level;
    const std::string once = level.edit(kLevel, {{.nodes = "Hall/Column", .style = "photoreal"}});
    const std::string twice = level.edit(once, {{.nodes = "Hall/Column", .style = "ink"}});
    EXPECT_EQ(twice.find("photoreal"), std::string::npos);
    EXPECT_EQ(level.parse(twice).assign.size(), 3u);
    EXPECT_EQ(level.edit(twice, {{.nodes = "Hall/Column", .style = "photoreal"}}), once);
}

TEST(level_edit, an_entry_that_is_not_the_last_moves_to_the_end)
{
    const EditedLevel level;
    std::string text = level.edit(kLevel, {{.nodes = "A", .style = "ink"}, {.nodes = "A/B", .style = "ink"}});
    text = level.edit(text, {{.nodes = "A", .style = "photoreal"}});
    const hw::Level read = level.parse(text);
    ASSERT_EQ(read.assign.size(), 4u);
    EXPECT_EQ(read.assign[2].nodes, "A/B");
    EXPECT_EQ(read.assign[3].nodes, "A") << "it must win over the entry for its child";
    EXPECT_EQ(read.assign[3].style, "photoreal");
}

TEST(level_edit, an_entry_that_says_more_is_kept)
{
    const EditedLevel level;
    const std::string before = with_list(R"([{"nodes": "A", "style": "ink", "certainty": 1}])");
    const hw::Level read = level.parse(level.edit(before, {{.nodes = "A", .style = "photoreal"}}));
    ASSERT_EQ(read.assign.size(), 2u);
    EXPECT_EQ(read.assign[0].certainty, 1.0);
}

TEST(level_edit, the_list_is_made_where_it_is_missing_or_empty)
{
    const EditedLevel level;
    for (const std::string& before :
         {std::string(R"({"format": "hatchway-level/1", "scene": "hall.glb"})"),
          std::string("{\"format\": \"hatchway-level/1\", \"scene\": \"hall.glb\" // the hall\n}"), with_list("[]"),
          with_list("[ ]"), with_list("[ // none yet\n ]"), with_list("[{\"nodes\": \"B\", \"style\": \"ink\"}]"),
          with_list("[{\"nodes\": \"B\", \"style\": \"ink\"} // B\n]"),
          with_list("[{\"nodes\": \"B\", \"style\": \"ink\"} /* ] */ ]")}) {
        SCOPED_TRACE(before);
        const hw::Level read = level.parse(level.edit(before, {{.nodes = "A", .style = "ink"}}));
        ASSERT_FALSE(read.assign.empty());
        EXPECT_EQ(read.assign.back().nodes, "A");
        EXPECT_EQ(read.assign.size(), before.find("\"B\"") == std::string::npos ? 1u : 2u);
    }
}

TEST(level_edit, brackets_quotes_and_comment_signs_in_texts_do_not_confuse_it)
{
    const EditedLevel level;
    const std::string before = with_list(R"([{"nodes": "a]}\"//*", "style": "ink"}])");
    const std::string text = level.edit(before, {{.nodes = "quote\" and \\ and \xc3\xa4", .style = "ink"}});
    const hw::Level read = level.parse(text);
    EXPECT_EQ(read.assign.at(0).nodes, "a]}\"//*");
    EXPECT_EQ(read.assign.at(1).nodes, "quote\" and \\ and \xc3\xa4");
}

TEST(level_edit, a_hybrid_is_written_with_its_presence)
{
    const EditedLevel level;
    const hw::PresenceField presence{.constant = 0.5f, .height = hw::Ramp{0.1f, 3.0f}};
    const std::string text = level.edit(
        kLevel, {{.nodes = "A", .style = "ink", .materials = "Stone", .over = "photoreal", .presence = presence}});
    const hw::AssignRule rule = level.parse(text).assign.back();
    EXPECT_EQ(rule.materials, "Stone");
    EXPECT_EQ(rule.over, "photoreal");
    EXPECT_EQ(rule.presence, presence);
    EXPECT_EQ(level.parse(level.edit(text, {{.nodes = "A", .style = "ink"}})).assign.size(), 4u)
        << "one material and all materials are different things";
}

TEST(level_edit, styles_that_are_like_others_stay_as_they_are_written)
{
    const EditedLevel level;
    const std::string before = R"({"format": "hatchway-level/1", "scene": "hall.glb",
        "styles": {"ink": {"plugin": "pen_and_ink", "crease_deg": 40}, "fine": {"like": "ink"}}})";
    const std::string text = level.edit(before, {{.nodes = "A", .style = "fine"}});
    EXPECT_THAT(text, testing::HasSubstr(R"("fine": {"like": "ink"}})"));
    EXPECT_EQ(level.parse(text).styles.at("fine").plugin, "pen_and_ink");
}

TEST(level_edit, many_edits_read_as_the_last_of_each)
{
    const EditedLevel level;
    std::string text = kLevel;
    for (int i = 0; i < 40; ++i)
        text = level.edit(text, {{.nodes = "Node_" + std::to_string(i * 7 % 5), .style = i % 2 ? "ink" : "photoreal"}});
    const hw::Level read = level.parse(text);
    EXPECT_LE(read.assign.size(), 2u + 6u);
    EXPECT_NE(text.find("// add more here"), std::string::npos);
}

TEST(level_edit, every_byte_of_a_level_stays_and_saying_it_again_changes_nothing)
{
    const EditedLevel level;
    RandomLevels next;
    for (int trial = 0; trial < 500; ++trial) {
        const std::string before = next.text();
        const Assignments assignments{next.assignment()};
        const std::string text = level.edit(before, assignments);
        const std::optional<std::string> more = added(before, text);
        ASSERT_TRUE(more) << before << "\nbecame\n" << text;
        EXPECT_LT(more->size(), 200u);
        EXPECT_EQ(level.parse(text).assign.size(), level.parse(before).assign.size() + 1);
        ASSERT_EQ(level.edit(text, assignments), text) << before;
    }
}

TEST(level_edit, writing_changes_the_file_and_an_error_does_not)
{
    const EditedLevel level;
    const hw::LevelTexts texts = level.save({{.nodes = "A", .style = "ink"}});
    EXPECT_EQ(texts.before, kLevel);
    EXPECT_EQ(texts.after, hw::read_text_file(level.file(), 10000));
    EXPECT_EQ(hw::read_level(level.file()).assign.back().nodes, "A");

    hw::write_file_atomically(level.file(), std::string_view("{ broken"));
    EXPECT_THROW(level.save({{.nodes = "A", .style = "ink"}}), hw::Error);
    EXPECT_EQ(hw::read_text_file(level.file(), 1000), "{ broken");
}

TEST(level_edit, a_level_that_is_a_link_is_replaced_and_what_it_leads_to_stays)
{
    const EditedLevel level;
    const fs::path link = level.file().parent_path() / "link.level.json";
    fs::create_symlink(level.file().filename(), link);
    hw::edit_level_file(link, [](const hw::Level&) { return Assignments{{.nodes = "A", .style = "ink"}}; });
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(link)));
    EXPECT_EQ(hw::read_level(link).assign.back().nodes, "A");
    EXPECT_EQ(hw::read_text_file(level.file(), 10000), kLevel);
}

TEST(level_edit, what_an_editor_wrote_while_the_changes_were_made_is_kept)
{
    const EditedLevel level;
    int asked = 0;
    hw::edit_level_file(level.file(), [&](const hw::Level&) {
        if (asked++ == 0) {
            std::string text = kLevel;
            text.replace(text.find("12"), 2, "13");
            hw::write_file_atomically(level.file(), text);
        }
        return Assignments{{.nodes = "A", .style = "ink"}};
    });
    EXPECT_EQ(hw::read_level(level.file()).exposure_ev, 13.0);
    EXPECT_EQ(hw::read_level(level.file()).assign.back().nodes, "A");
}

TEST(level_edit, no_save_of_two_processes_at_once_is_lost)
{
    const EditedLevel level;
    constexpr int kSaves = 60;
    const auto save_all = [&](const std::string& name) {
        for (int i = 0; i < kSaves; ++i) level.save({{.nodes = name + std::to_string(i), .style = "ink"}});
    };
    const pid_t other = ::fork();
    if (other == 0) {
        save_all("B");
        ::_exit(0);
    }
    save_all("A");
    int status = 0;
    ::waitpid(other, &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(hw::read_level(level.file()).assign.size(), 2u + 2u * kSaves);
}

TEST(level_edit, a_bare_model_cannot_be_edited)
{
    const EditedLevel level;
    const auto nothing = [](const hw::Level&) { return Assignments(); };
    EXPECT_THAT(error_of([&] { hw::edit_level_file(level.file().parent_path() / "hall.glb", nothing); }).expected,
                testing::HasSubstr(".json"));
}
