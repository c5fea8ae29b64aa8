#pragma once

#include <filesystem>
#include <string>

namespace hw {

/// Which libraries are tried in a process of their own before they are loaded.
enum class Trial : unsigned char {
    if_new,  ///< Those that this user's host has not tried yet. One that was costs a hash and a read.
    anew,    ///< All, also those that were left out.
    none,
};

/// Why a library must not be loaded, in one sentence; empty when it may. From then on its crashes are watched, under
/// the name of its file. `trial` is not `none`.
std::string trial_refusal(const std::filesystem::path& library, Trial trial);

}  // namespace hw
