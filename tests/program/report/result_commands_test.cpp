// A result says by which command it was made: one that can be given again.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "tests/program/run_program.hpp"

namespace hw::test {
namespace {

namespace fs = std::filesystem;

/// Words of a command line as `given` writes them that no option takes: after the first option there is nothing but
/// options, each with its one value unless it is a flag.
std::vector<std::string> words_astray(const std::vector<std::string>& words, const std::string& help)
{
    const auto is_option = [](const std::string& word) { return word.size() > 1 && word[0] == '-'; };
    const auto is_flag = [&](const std::string& option) {
        return std::regex_search(help, std::regex("\n +" + option + "  +\\S"));
    };
    std::vector<std::string> astray;
    bool is_value = false;
    bool are_options = false;
    for (const std::string& word : words) {
        if (is_option(word)) {
            are_options = true;
            is_value = !is_flag(word);
        } else {
            if (are_options && !is_value) astray.push_back(word);
            is_value = false;
        }
    }
    return astray;
}

/// The words after the program's name.
std::vector<std::string> words_of(const std::string& command)
{
    std::istringstream text(command);
    std::vector<std::string> words;
    for (std::string word; text >> word;) words.push_back(word);
    words.erase(words.begin());
    return words;
}

/// All that the reader objects to is the folder of --json, which is not there: so nothing is measured.
void expect_is_read(const std::string& command)
{
    const TemporaryFolder folder;
    std::vector<std::string> words = words_of(command);
    const std::string help = run_program({words.at(0), words.at(1), "--help"}).out;
    EXPECT_THAT(words_astray(words, help), testing::IsEmpty()) << command;
    words.insert(words.end(), {"--json", folder / "none/rows.json"});
    const ProgramResult result = run_program(words);
    EXPECT_EQ(result.exit_code, 2) << command;
    EXPECT_THAT(result.err, testing::HasSubstr("--json: there is no folder")) << command;
}

/// A script gets as far as to miss its files, which are not there.
void expect_is_read_by(const fs::path& script, const std::string& command)
{
    const TemporaryFolder folder;
    std::string line = "cd '" + folder.path().string() + "' && python3 '" + script.string() + "'";
    for (const std::string& word : words_of(command)) line += " '" + word + "'";
    EXPECT_EQ(std::system((line + " > /dev/null 2> err").c_str()), 1 << 8) << command;
    EXPECT_THAT(bytes_of(folder.path() / "err"),
                testing::AllOf(testing::HasSubstr("FileNotFoundError"), testing::Not(testing::HasSubstr("usage:"))));
}

}  // namespace

TEST(result_commands, every_command_of_a_committed_result_is_one_that_its_program_reads)
{
    const fs::path source(HATCHWAY_SOURCE_DIR);
    for (const auto& entry : fs::directory_iterator(source / "docs/report/results")) {
        const std::string name = entry.path().stem().string();
        const nlohmann::json result = nlohmann::json::parse(bytes_of(entry.path()));
        if (!result.contains("origin")) {
            ADD_FAILURE() << name << " does not say what made it";
            continue;
        }
        const std::string command = result["origin"].at("command");
        if (name == "game_map")
            expect_is_read_by(source / "editor_tools/measure/visibility/game_map_share.py", command);
        else if (name == "fuzz")
            expect_is_read_by(source / "tests/fuzz/campaign.py", command);
        else if (name == "devices")
            EXPECT_EQ(command, "test_program --gtest_filter='second_device.*'");
        else
            expect_is_read(command);
    }
}

TEST(result_commands, the_command_of_a_result_makes_a_result_of_the_same_command)
{
    const TemporaryFolder folder;
    const std::string json = folder / "rows.json";
    const auto command = [&] {
        return nlohmann::json::parse(bytes_of(json)).at("origin").at("command").get<std::string>();
    };
    const std::string prism = (kContent / "models" / "prism.glb").string();
    const std::string first = "hatchway measure silhouettes " + prism + " --views 1 --orthographic --offset 0,1";
    for (const std::string flag : {"--orthographic", "--orthographic=true"}) {
        ASSERT_EQ(
            run_program({"measure", "silhouettes", prism, "--views", "1", flag, "--offset", "0,1", "--json", json})
                .exit_code,
            0);
        EXPECT_EQ(command(), first);
    }
    std::vector<std::string> words = words_of(first);
    words.insert(words.end(), {"--json", json});
    ASSERT_EQ(run_program(words).exit_code, 0);
    EXPECT_EQ(command(), first);
}

}  // namespace hw::test
