#include "hatchway/io/level/schema.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "hatchway/core/plain_text.hpp"
#include "hatchway/io/level/keys.hpp"

namespace hw {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kColourPattern = "^#[0-9a-fA-F]{6}$";

Json number_schema(double min, double max)
{
    return {{"type", "number"}, {"minimum", min}, {"maximum", max}};
}

Json point_schema()
{
    return {{"type", "array"}, {"items", number_schema(kMetres.min, kMetres.max)}, {"minItems", 3}, {"maxItems", 3}};
}

/// A float such as 0.1f, written as people write it.
double shortest(double value)
{
    return std::stod(fmt::format("{}", static_cast<float>(value)));
}

Json param_schema(const ParamSchema& param)
{
    Json schema;
    switch (param.type) {
        case ParamType::real:
        case ParamType::whole:
            schema = number_schema(shortest(param.min), shortest(param.max));
            if (param.type == ParamType::whole) schema["type"] = "integer";
            break;
        case ParamType::flag:
            schema["type"] = "boolean";
            break;
        case ParamType::colour:
            schema = {{"type", "string"}, {"pattern", kColourPattern}};
            break;
        case ParamType::choice:
            schema["enum"] = param.choices;
            break;
        case ParamType::map:
        case ParamType::image:
            schema["type"] = "string";
            break;
    }
    schema["description"] = param.help;
    if (const bool* flag = std::get_if<bool>(&param.default_value)) schema["default"] = *flag;
    if (const double* number = std::get_if<double>(&param.default_value)) {
        if (param.type == ParamType::whole)
            schema["default"] = static_cast<std::int64_t>(*number);
        else
            schema["default"] = shortest(*number);
    }
    if (const std::string* text = std::get_if<std::string>(&param.default_value)) schema["default"] = *text;
    return schema;
}

Json plugin_names(const std::vector<StyleSchema>& plugins)
{
    Json names = Json::array();
    for (const StyleSchema& plugin : plugins) names.push_back(plugin.name);
    return names;
}

/// The visitor of visit_keys() that describes keys instead of reading them.
class SchemaWriter {
 public:
    explicit SchemaWriter(const std::vector<StyleSchema>& plugins) : plugins_(plugins) {}

    template <typename T>
    bool text(const LevelKey& key, T&)
    {
        return add(key, {{"type", "string"}, {"minLength", 1}});
    }
    template <typename T>
    bool flag(const LevelKey& key, T&)
    {
        return add(key, {{"type", "boolean"}});
    }
    template <typename T>
    bool colour(const LevelKey& key, T&)
    {
        return add(key, {{"type", "string"}, {"pattern", kColourPattern}});
    }
    template <typename T>
    bool linear_colour(const LevelKey& key, T& value)
    {
        return colour(key, value);
    }
    template <typename T>
    bool texts(const LevelKey& key, T&)
    {
        return add(key, {{"type", "array"}, {"items", {{"type", "string"}, {"minLength", 1}}}});
    }
    template <typename T>
    bool real(const LevelKey& key, const LevelRange& range, T&)
    {
        return add(key, number_schema(range.min, range.max));
    }
    bool whole(const LevelKey& key, const LevelRange& range, int&)
    {
        Json schema = number_schema(range.min, range.max);
        schema["type"] = "integer";
        return add(key, std::move(schema));
    }
    bool angle(const LevelKey& key, const LevelRange& range_deg, float&)
    {
        return add(key, number_schema(range_deg.min, range_deg.max));
    }
    bool point(const LevelKey& key, glm::dvec3&) { return add(key, point_schema()); }
    bool file(const LevelKey& key, std::filesystem::path&) { return add(key, {{"type", "string"}, {"minLength", 1}}); }
    bool constant(const LevelKey& key, std::string_view value) { return add(key, {{"const", value}}); }
    void ignored(const LevelKey& key) { add(key, {{"type", "string"}}); }

    template <typename Enum>
    bool choice(const LevelKey& key, std::span<const std::string_view> names, Enum&)
    {
        return add(key, {{"enum", std::vector<std::string>(names.begin(), names.end())}});
    }
    template <typename T>
    bool object(const LevelKey& key, T& value)
    {
        return add(key, object_schema(value));
    }
    template <typename T>
    bool object(const LevelKey& key, std::optional<T>&)
    {
        T value{};
        return add(key, object_schema(value));
    }
    template <typename T>
    bool objects(const LevelKey& key, std::vector<T>&)
    {
        T value{};
        return add(key, {{"type", "array"}, {"items", object_schema(value)}});
    }
    template <typename T>
    bool named(const LevelKey& key, std::map<std::string, T>&)
    {
        T value{};
        return add(key, {{"type", "object"}, {"additionalProperties", object_schema(value)}});
    }
    template <typename T>
    bool named(const LevelKey& key, std::vector<T>&)
    {
        std::map<std::string, T> by_name;
        return named(key, by_name);
    }

    void one_of(std::string_view first, std::string_view second)
    {
        one_of_ = {{{"required", {first}}}, {{"required", {second}}}};
    }

    void not_both(std::string_view first, std::string_view second) { not_both_ = {{"required", {first, second}}}; }

    /// Parameters of the plugin that is named beside them; left open where another style names it.
    void params(ParamSettings&)
    {
        is_open_ = true;
        if (plugins_.empty()) return;
        properties_["plugin"]["examples"] = plugin_names(plugins_);
        for (const StyleSchema& plugin : plugins_) {
            Json properties = {{"plugin", {{"const", plugin.name}, {"description", plugin.summary}}}};
            for (const ParamSchema& param : plugin.params) properties[param.name] = param_schema(param);
            const Json is_this_plugin = {{"required", {"plugin"}},
                                         {"properties", {{"plugin", {{"const", plugin.name}}}}}};
            alternatives_.push_back(
                {{"if", is_this_plugin}, {"then", {{"properties", properties}, {"additionalProperties", false}}}});
        }
    }

    Json schema() const
    {
        Json result = {{"type", "object"}, {"properties", properties_}};
        if (!required_.empty()) result["required"] = required_;
        if (!is_open_) result["additionalProperties"] = false;
        if (!one_of_.empty()) result["oneOf"] = one_of_;
        if (!not_both_.empty()) result["not"] = not_both_;
        if (!alternatives_.empty()) result["allOf"] = alternatives_;
        return result;
    }

    template <typename T>
    Json object_schema(T& value) const
    {
        SchemaWriter writer(plugins_);
        visit_keys(writer, value);
        return writer.schema();
    }

 private:
    /// Never "was there": nothing is read.
    bool add(const LevelKey& key, Json schema)
    {
        schema["description"] = key.help;
        properties_[std::string(key.name)] = std::move(schema);
        if (key.is_required) required_.push_back(key.name);
        return false;
    }

    const std::vector<StyleSchema>& plugins_;
    Json properties_ = Json::object();
    Json required_ = Json::array();
    Json one_of_ = Json::array();
    Json not_both_;
    Json alternatives_ = Json::array();
    bool is_open_ = false;
};

ParamSchema described_param(const ParamInfo& info, ParamType type, ParamValue default_value)
{
    return {.name = std::string(info.name),
            .help = std::string(info.help),
            .type = type,
            .change = info.change,
            .default_value = std::move(default_value)};
}

}  // namespace

void SchemaCollector::real(const ParamInfo& info, float& value, float min, float max)
{
    params_.push_back(described_param(info, ParamType::real, static_cast<double>(value)));
    params_.back().min = min;
    params_.back().max = max;
}

void SchemaCollector::whole(const ParamInfo& info, int& value, int min, int max)
{
    params_.push_back(described_param(info, ParamType::whole, static_cast<double>(value)));
    params_.back().min = min;
    params_.back().max = max;
}

void SchemaCollector::flag(const ParamInfo& info, bool& value)
{
    params_.push_back(described_param(info, ParamType::flag, value));
}

void SchemaCollector::colour(const ParamInfo& info, glm::vec3& value)
{
    const auto byte = [&](int i) { return std::lround(255.0f * std::clamp(value[i], 0.0f, 1.0f)); };
    params_.push_back(
        described_param(info, ParamType::colour, fmt::format("#{:02x}{:02x}{:02x}", byte(0), byte(1), byte(2))));
}

void SchemaCollector::choice_of(const ParamInfo& info, int& index, std::span<const std::string_view> names)
{
    params_.push_back(described_param(info, ParamType::choice, std::string(names[static_cast<std::size_t>(index)])));
    params_.back().choices.assign(names.begin(), names.end());
}

void SchemaCollector::map(const ParamInfo& info, MapName& value, MapKind)
{
    params_.push_back(described_param(info, ParamType::map, value.value));
}

void SchemaCollector::image(const ParamInfo& info, ImageFile& value)
{
    params_.push_back(described_param(info, ParamType::image, value.value));
}

std::string level_schema(const std::vector<StyleSchema>& plugins)
{
    Level level;
    Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                   {"title", "Hatchway level"},
                   {"description", "Made by `hatchway schema` from the lists that read level files."}};
    schema.update(SchemaWriter(plugins).object_schema(level));
    return plain_json(schema.dump(2)) + '\n';
}

}  // namespace hw
