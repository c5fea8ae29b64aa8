#pragma once

#include <string>
#include <string_view>

#include "hatchway/io/json/fwd.hpp"

namespace hw {

enum class JsonComments : unsigned char { refused, allowed };

/// Parses JSON from a stranger. Throws hw::Error with the JSON pointer of the place for text that is no JSON, nesting
/// over limits::kMaxJsonDepth, a repeated key, or a number too large for a double. Private to io.
nlohmann::json parse_json(std::string_view text, const std::string& file, JsonComments comments);

/// A JSON pointer to a member of what `pointer` points to; '~' and '/' in the name are escaped.
std::string pointer_to(const std::string& pointer, std::string_view member);
std::string pointer_to(const std::string& pointer, std::size_t element);

/// What a message calls a value: "the text \"on\"", "the number 12", "an object".
std::string described(const nlohmann::json& value);

}  // namespace hw
