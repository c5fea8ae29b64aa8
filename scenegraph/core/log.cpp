#include "hatchway/core/log.hpp"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "hatchway/core/plain_text.hpp"

namespace hw {
namespace {

spdlog::logger& logger()
{
    static const std::shared_ptr<spdlog::logger> log = [] {
        auto created =
            std::make_shared<spdlog::logger>("hatchway", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
        created->set_pattern("%n: %^%l%$: %v");
        return created;
    }();
    return *log;
}

}  // namespace

void set_log_level(LogLevel level)
{
    constexpr spdlog::level::level_enum kLevels[] = {spdlog::level::debug, spdlog::level::info, spdlog::level::warn,
                                                     spdlog::level::err, spdlog::level::off};
    logger().set_level(kLevels[static_cast<int>(level)]);
}

void log_debug(std::string_view message)
{
    logger().debug("{}", plain_text(message));
}
void log_info(std::string_view message)
{
    logger().info("{}", plain_text(message));
}
void log_warning(std::string_view message)
{
    logger().warn("{}", plain_text(message));
}
void log_error(std::string_view message)
{
    logger().error("{}", plain_text(message));
}

}  // namespace hw
