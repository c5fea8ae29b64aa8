#pragma once

#include <filesystem>
#include <optional>

#include "hatchway/io/json/out.hpp"
#include "program/command_line.hpp"
#include "program/output_files.hpp"

namespace hw {

/// Where a measurement puts its result: the file of --json, or nowhere.
class MeasureResult {
 public:
    void add_to(CommandLine command);

    OutputFile output() const { return {"--json", file_}; }

    /// Writes the result with the member "origin": the commit that the program was built from, the processor, its
    /// threads, the day, and the command line without --json. Nothing without --json.
    void write(JsonValue result) const;

 private:
    std::filesystem::path file_;
    std::optional<CommandLine> command_;
};

}  // namespace hw
