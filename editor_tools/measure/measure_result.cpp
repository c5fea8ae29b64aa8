#include "measure/measure_result.hpp"

#include <fmt/format.h>

#include <chrono>
#include <ctime>
#include <fstream>
#include <thread>

#include "hatchway_commit.hpp"

namespace hw {
namespace {

std::string processor_name()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
    return "unknown processor";
}

std::string today()
{
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    char text[16] = {};
    std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
    return text;
}

}  // namespace

void MeasureResult::add_to(CommandLine command)
{
    command.add_option("--json", file_, "Write the result as JSON").option_text("FILE");
    command_ = command;
}

void MeasureResult::write(JsonValue result) const
{
    if (file_.empty()) return;
    result.set("origin", JsonValue::object()
                             .set("version", HATCHWAY_VERSION)
                             .set("commit", HATCHWAY_COMMIT)
                             .set("processor", processor_name())
                             .set("threads", static_cast<int>(std::thread::hardware_concurrency()))
                             .set("date", today())
                             .set("command", fmt::format("{}", fmt::join(command_->given({"--json"}), " "))));
    write_json(file_, result);
}

}  // namespace hw
