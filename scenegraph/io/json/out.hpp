#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace hw {

/// A value of a machine-readable result. Members keep the order in which they were added, so equal results are equal
/// bytes.
///
///     JsonValue result = JsonValue::object();
///     result.set("faces", 28).set("eye", JsonValue::array().push(1.5).push(0).push(2));
///     write_json("result.json", result);
class JsonValue {
 public:
    JsonValue() = default;  ///< null
    JsonValue(bool value) : value_(value) {}
    JsonValue(int value) : value_(static_cast<std::int64_t>(value)) {}
    JsonValue(std::int64_t value) : value_(value) {}
    JsonValue(std::uint32_t value) : value_(static_cast<std::int64_t>(value)) {}
    JsonValue(std::uint64_t value) : value_(static_cast<std::int64_t>(value)) {}
    JsonValue(double value) : value_(Number{value, 9}) {}
    JsonValue(std::string value) : value_(std::move(value)) {}
    JsonValue(const char* value) : value_(std::string(value)) {}

    static JsonValue object();
    static JsonValue array();
    /// A number with all 17 significant digits: reads back as the same double. Others are written with 9.
    static JsonValue exact(double value);

    /// Adds a member to an object, an element to an array.
    JsonValue& set(std::string name, JsonValue value);
    JsonValue& push(JsonValue value);

    /// The text, arrays of plain values on one line, everything else indented; ends with a newline. A number that is
    /// not finite becomes null, since JSON has no other word for it.
    std::string text() const;

 private:
    struct Number {
        double value;
        int digits;
    };
    using Member = std::pair<std::string, JsonValue>;

    bool is_plain() const;
    void append_to(std::string& text, int depth) const;
    void append_array(std::string& text, int depth) const;
    void append_object(std::string& text, int depth) const;

    std::variant<std::monostate, bool, std::int64_t, Number, std::string, std::vector<JsonValue>, std::vector<Member>>
        value_;
};

/// Writes `value.text()`; readers see the old file or the new one.
void write_json(const std::filesystem::path& file, const JsonValue& value);

}  // namespace hw
