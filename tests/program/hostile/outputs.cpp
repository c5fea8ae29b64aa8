#include "tests/program/hostile/outputs.hpp"

#include "tests/program/run_program.hpp"

namespace hw::test {
namespace fs = std::filesystem;
namespace {

bool is_temporary(const std::string& name)
{
    return name.starts_with(".hatchway-") && name.ends_with(".tmp");
}

}  // namespace

std::vector<std::string> CommandOutput::arguments(const fs::path& model, const fs::path& folder, bool is_new) const
{
    std::vector<std::string> arguments;
    for (const std::string& word : words) arguments.push_back(word == "MODEL" ? model.string() : word);
    arguments.insert(arguments.end(), {option, is_new ? new_value : old_value, "--out", (folder / name).string()});
    return arguments;
}

std::map<std::string, std::string> state_of(const fs::path& output)
{
    std::map<std::string, std::string> state;
    if (fs::is_regular_file(output)) state[""] = bytes_of(output);
    if (!fs::is_directory(output)) return state;
    for (const auto& entry : fs::directory_iterator(output)) {
        const std::string name = entry.path().filename().string();
        if (!is_temporary(name)) state[name] = bytes_of(entry.path());
    }
    return state;
}

int left_behind_in(const fs::path& folder)
{
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        count += is_temporary(entry.path().filename().string()) ? 1 : 0;
    return count;
}

}  // namespace hw::test
