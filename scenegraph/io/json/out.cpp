#include "hatchway/io/json/out.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/plain_text.hpp"

namespace hw {
namespace {

constexpr int kIndent = 2;
constexpr int kExactDigits = 17;

std::string quoted(const std::string& text)
{
    // Names come from models, whose UTF-8 nobody has checked.
    return plain_json(nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace

JsonValue JsonValue::object()
{
    JsonValue value;
    value.value_ = std::vector<Member>();
    return value;
}

JsonValue JsonValue::array()
{
    JsonValue value;
    value.value_ = std::vector<JsonValue>();
    return value;
}

JsonValue JsonValue::exact(double value)
{
    JsonValue result;
    result.value_ = Number{value, kExactDigits};
    return result;
}

JsonValue& JsonValue::set(std::string name, JsonValue value)
{
    auto* members = std::get_if<std::vector<Member>>(&value_);
    HW_ASSERT(members);
    members->emplace_back(std::move(name), std::move(value));
    return *this;
}

JsonValue& JsonValue::push(JsonValue value)
{
    auto* elements = std::get_if<std::vector<JsonValue>>(&value_);
    HW_ASSERT(elements);
    elements->push_back(std::move(value));
    return *this;
}

bool JsonValue::is_plain() const
{
    return value_.index() <= 4;
}

void JsonValue::append_array(std::string& text, int depth) const
{
    const auto& elements = std::get<std::vector<JsonValue>>(value_);
    const bool is_one_line = std::ranges::all_of(elements, &JsonValue::is_plain);
    text += '[';
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (i > 0) text += is_one_line ? ", " : ",";
        if (!is_one_line) text += '\n' + std::string((depth + 1) * kIndent, ' ');
        elements[i].append_to(text, depth + 1);
    }
    if (!is_one_line) text += '\n' + std::string(depth * kIndent, ' ');
    text += ']';
}

void JsonValue::append_object(std::string& text, int depth) const
{
    const auto& members = std::get<std::vector<Member>>(value_);
    text += '{';
    for (std::size_t i = 0; i < members.size(); ++i) {
        text += (i > 0 ? ",\n" : "\n") + std::string((depth + 1) * kIndent, ' ') + quoted(members[i].first) + ": ";
        members[i].second.append_to(text, depth + 1);
    }
    if (!members.empty()) text += '\n' + std::string(depth * kIndent, ' ');
    text += '}';
}

void JsonValue::append_to(std::string& text, int depth) const
{
    if (const auto* number = std::get_if<Number>(&value_))
        text += std::isfinite(number->value) ? fmt::format("{:.{}g}", number->value, number->digits) : "null";
    else if (const auto* whole = std::get_if<std::int64_t>(&value_))
        text += std::to_string(*whole);
    else if (const auto* flag = std::get_if<bool>(&value_))
        text += *flag ? "true" : "false";
    else if (const auto* string = std::get_if<std::string>(&value_))
        text += quoted(*string);
    else if (std::holds_alternative<std::vector<JsonValue>>(value_))
        append_array(text, depth);
    else if (std::holds_alternative<std::vector<Member>>(value_))
        append_object(text, depth);
    else
        text += "null";
}

std::string JsonValue::text() const
{
    std::string result;
    append_to(result, 0);
    return result + '\n';
}

void write_json(const std::filesystem::path& file, const JsonValue& value)
{
    write_file_atomically(file, value.text());
}

}  // namespace hw
