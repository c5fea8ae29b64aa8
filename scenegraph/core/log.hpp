#pragma once

#include <string_view>

namespace hw {

/// How much of the log reaches stderr.
enum class LogLevel : unsigned char { debug, info, warning, error, off };

/// Messages below `level` are dropped. The default is LogLevel::info.
void set_log_level(LogLevel level);

/// Writes one line to stderr, as plain_text(). Results never go here, they go to stdout. Thread safe.
void log_debug(std::string_view message);
void log_info(std::string_view message);
void log_warning(std::string_view message);
void log_error(std::string_view message);

}  // namespace hw
