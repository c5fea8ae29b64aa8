#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hw {

/// Where a value stands in a JSON text: characters [begin, end). Private to io.
struct JsonPlace {
    std::size_t begin = 0;
    std::size_t end = 0;

    std::string_view text(std::string_view whole) const { return whole.substr(begin, end - begin); }
};

// These find values in a text that parse_json() has accepted, comments included, so that it can be edited without
// losing comments and layout. The text's root is an object.

JsonPlace root_place(std::string_view text);
/// The value of a member of the root; nothing when there is none.
std::optional<JsonPlace> member_place(std::string_view text, std::string_view name);
/// The value of the root's last member; nothing when the root is empty.
std::optional<JsonPlace> last_member_place(std::string_view text);
/// The names of the members of an object that is a member of the root, in the order of the text; none where there is no
/// such object.
std::vector<std::string> member_names(std::string_view text, std::string_view name);
/// The elements of the array that stands at `array`.
std::vector<JsonPlace> element_places(std::string_view text, const JsonPlace& array);

}  // namespace hw
