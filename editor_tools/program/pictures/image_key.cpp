#include "program/pictures/image_key.hpp"

#include <charconv>
#include <sstream>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

ParamValue value_of(const std::string& text)
{
    if (text == "true" || text == "false") return text == "true";
    double number = 0.0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (status == std::errc() && end == text.data() + text.size()) return number;
    return text;
}

}  // namespace

ImageKey image_key_of(const std::string& text)
{
    ImageKey key;
    std::istringstream words(text);
    words >> key.pass;
    for (std::string word; words >> word;) {
        const std::size_t sign = word.find('=');
        if (sign == 0 || sign == std::string::npos || sign + 1 == word.size())
            throw Error(
                {.what = "the image \"" + text + "\"", .expected = "a name and parameters: edge_map operator=c1"});
        key.params[word.substr(0, sign)] = value_of(word.substr(sign + 1));
    }
    if (key.pass.empty()) throw Error({.what = "an image without a name", .expected = "such as normal_depth"});
    return key;
}

}  // namespace hw
