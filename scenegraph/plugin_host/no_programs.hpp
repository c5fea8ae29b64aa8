#pragma once

#include "hatchway/style/program_cache.hpp"

namespace hw {

/// Promises programs that nobody will draw with: for styles that are prepared without a device.
class NoPrograms final : public ProgramCache {
 public:
    Program surface(std::string_view, std::string_view) override { return {1}; }
    Program full_screen(std::string_view, std::string_view) override { return {1}; }
    Program line(std::string_view, std::string_view) override { return {1}; }
    Image texture(std::string_view) override { return {}; }
};

}  // namespace hw
