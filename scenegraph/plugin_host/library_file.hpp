#pragma once

#include <filesystem>
#include <string>

namespace hw {

/// Why a library must not be given to the loader, in one sentence; empty when it may be. The loader opens a FIFO and
/// waits, and maps a library that was cut off, whose missing pages then end the process. What is no 64-bit ELF file at
/// all is left to the loader, which refuses it well.
std::string library_refusal(const std::filesystem::path& library);

}  // namespace hw
