// What Mesa's compiler lets pass, another may refuse: every program is read by the reference compiler of Khronos, too.
#include <gmock/gmock.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "hatchway/gl/gpu_program.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "tests/render/assembled_programs.hpp"
#include "tests/temporary_folder.hpp"

namespace hw::test {
namespace {

struct Outcome {
    int status = 0;
    std::string text;
};

Outcome run(const std::string& command)
{
    Outcome outcome;
    FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
    std::array<char, 4096> buffer;
    for (std::size_t count = 0; (count = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
        outcome.text.append(buffer.data(), count);
    outcome.status = ::pclose(pipe);
    return outcome;
}

bool is_installed()
{
    return run("command -v glslangValidator").status == 0;
}

/// Distinct stages as files of one folder, numbered; the validator tells the stage by the ending.
class Stages {
 public:
    Stages(bool is_es) : is_es_(is_es) {}

    void add(const AssembledProgram& program)
    {
        add(program.vertex, ".vert", program.name);
        add(program.fragment, ".frag", program.name);
    }
    std::size_t count() const { return texts_.size(); }

    /// What the validator refuses of all of them: the program's name and the first message.
    std::vector<std::string> refused() const
    {
        const Outcome outcome = run("cd '" + folder_.path().string() + "' && glslangValidator *.vert *.frag");
        std::vector<std::string> refused;
        std::istringstream lines(outcome.text);
        std::string file;
        for (std::string line; std::getline(lines, line);) {
            if (names_.contains(line))
                file = line;
            else if (line.starts_with("ERROR: ") && !file.empty())
                refused.push_back(names_.at(std::exchange(file, "")) + ": " + line);
        }
        if (outcome.status != 0 && refused.empty()) refused.push_back(outcome.text);
        return refused;
    }

 private:
    void add(const ShaderText& stage, const std::string& ending, const std::string& name)
    {
        if (!texts_.insert(ending + stage.text).second) return;
        const std::string file = std::to_string(texts_.size()) + ending;
        std::ofstream(folder_.path() / file) << shader_header(is_es_) << stage.text;
        names_[file] = name;
    }

    bool is_es_;
    TemporaryFolder folder_;
    std::set<std::string> texts_;
    std::map<std::string, std::string> names_;  ///< File -> program.
};

class validator : public testing::TestWithParam<bool> {
 protected:
    void SetUp() override
    {
        if (!is_installed()) GTEST_SKIP() << "glslangValidator is not installed (Debian: glslang-tools)";
    }
};

TEST_P(validator, accepts_every_program)
{
    Stages stages(GetParam());
    for_each_program([&](const AssembledProgram& program) { stages.add(program); });
    EXPECT_GT(stages.count(), 500u);
    EXPECT_THAT(stages.refused(), testing::IsEmpty());
}

TEST_P(validator, refuses_what_mesa_lets_pass)
{
    const ShaderText vertex{.text = "void main() { gl_Position = vec4(0.0); }\n", .files = {"defines", "vertex"}};
    const ShaderText fragment{.text = "out vec4 colour;\nvoid main() { colour = vec4(1.0); };\n",
                              .files = {"defines", "fragment"}};
    const auto context = make_headless_context({.is_es = GetParam()});
    EXPECT_NO_THROW(GpuProgram(vertex, fragment, GetParam()));
    Stages stages(GetParam());
    stages.add({"planted", vertex, fragment});
    EXPECT_THAT(stages.refused(), testing::ElementsAre(testing::HasSubstr("planted: ERROR: 0:2")));
}

std::string language_name(const testing::TestParamInfo<bool>& info)
{
    return info.param ? "es_300" : "core_330";
}
INSTANTIATE_TEST_SUITE_P(glsl, validator, testing::Bool(), language_name);

}  // namespace
}  // namespace hw::test
