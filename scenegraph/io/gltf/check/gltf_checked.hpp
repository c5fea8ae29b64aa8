#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hatchway/io/json/fwd.hpp"

namespace hw {

/// A checked document and the words for what is wrong in it. Private to io.
struct GltfChecked {
    const nlohmann::json& root;
    const std::string& file;

    [[noreturn]] void refuse(const std::string& pointer, std::string what, std::string expected = {}) const;
    /// The array of root[name]; empty when it is missing.
    const nlohmann::json& list(const char* name) const;
    const nlohmann::json& accessor(const nlohmann::json& index) const;
    /// The value of a whole number, or `fallback` when the object has none.
    static std::uint64_t whole(const nlohmann::json& object, const char* name, std::uint64_t fallback);
    static std::optional<std::size_t> index(const nlohmann::json& object, const char* name);
};

}  // namespace hw
