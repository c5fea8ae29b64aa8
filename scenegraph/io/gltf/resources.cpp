#include "hatchway/io/gltf/resources.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/limits.hpp"

namespace hw {
namespace {

constexpr std::string_view kBase64Digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::optional<std::vector<std::byte>> decode_base64(std::string_view text)
{
    std::array<int, 256> value_of;
    value_of.fill(-1);
    for (std::size_t i = 0; i < kBase64Digits.size(); ++i)
        value_of[static_cast<unsigned char>(kBase64Digits[i])] = int(i);
    for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);

    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    int bit_count = 0;
    for (const char c : text) {
        const int value = value_of[static_cast<unsigned char>(c)];
        if (value < 0) return {};
        bits = (bits << 6) | static_cast<std::uint32_t>(value);
        bit_count += 6;
        if (bit_count < 8) continue;
        bit_count -= 8;
        bytes.push_back(static_cast<std::byte>(bits >> bit_count));
    }
    return bytes;
}

/// "%2e" and the like undone. A '%' that no two hexadecimal digits follow stands for itself: many exporters write names
/// as they are.
std::string decode_percent(const std::string& uri)
{
    const auto digit = [](char c) {
        if (c >= '0' && c <= '9') return c - '0';
        if (c >= 'a' && c <= 'f') return c - 'a' + 10;
        return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
    };
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const bool is_coded = uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0;
        if (!is_coded) {
            text += uri[i];
            continue;
        }
        text += static_cast<char>(digit(uri[i + 1]) * 16 + digit(uri[i + 2]));
        i += 2;
    }
    return text;
}

bool has_scheme(const std::string& uri)
{
    const std::size_t colon = uri.find(':');
    return colon != std::string::npos && uri.find('/') > colon;
}

}  // namespace

std::vector<std::byte> GltfResources::decode_data_uri(const std::string& uri, const std::string& pointer) const
{
    constexpr std::string_view kMark = ";base64,";
    const std::size_t mark = uri.find(kMark);
    const bool is_readable = mark != std::string::npos && uri.find(',') == mark + kMark.size() - 1;
    auto bytes = is_readable ? decode_base64(std::string_view(uri).substr(mark + kMark.size())) : std::nullopt;
    if (bytes) return std::move(*bytes);
    throw Error({.what = "the data URI cannot be decoded",
                 .file = file_.string(),
                 .pointer = pointer,
                 .expected = "data:<type>;base64,<digits>"});
}

std::filesystem::path GltfResources::resolve(const std::string& uri, const std::string& pointer) const
{
    if (!has_scheme(uri))
        return resolve_inside(project_root_, file_.parent_path(), decode_percent(uri), file_.string(), pointer);
    throw Error({.what = "the URI \"" + uri.substr(0, 80) + "\" is not read",
                 .file = file_.string(),
                 .pointer = pointer,
                 .expected = "a relative path, or data:<type>;base64,<digits>"});
}

std::vector<std::byte> GltfResources::read(const std::string& uri, const std::string& pointer)
{
    if (uri.starts_with("data:")) return decode_data_uri(uri, pointer);
    const std::filesystem::path path = resolve(uri, pointer);
    std::error_code failed;
    if (!std::filesystem::exists(path, failed))
        throw Error({.what = "there is no file \"" + uri + '"',
                     .file = file_.string(),
                     .pointer = pointer,
                     .expected = "a path relative to the file that names it"});
    const std::uint64_t left = limits::kMaxTotalBytes - std::min(spent_, limits::kMaxTotalBytes);
    try {
        std::vector<std::byte> bytes = read_file(path, std::min(left, limits::kMaxFileBytes));
        spent_ += bytes.size();
        return bytes;
    } catch (const Error& error) {
        throw Error({.what = "cannot read \"" + uri + "\": " + error.parts().what,
                     .file = file_.string(),
                     .pointer = pointer,
                     .expected = error.parts().expected});
    }
}

}  // namespace hw
