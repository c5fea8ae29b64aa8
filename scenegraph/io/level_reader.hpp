#pragma once

#include <concepts>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/limits.hpp"
#include "io/json_text.hpp"
#include "io/level_keys.hpp"

namespace hw {

/// Fills an object of a level from JSON: the visitor of visit_keys() that reads. Every function tells whether the key
/// was there, and throws hw::Error when its value is wrong. Private to io.
class LevelReader {
 public:
    /// Reads a whole level; its `file` and `project_root` are set.
    static void read(const nlohmann::json& document, Level& level);

    /// `level` gives the file and the project's root; `object` and `pointer` must outlive the reader.
    LevelReader(const Level& level, const nlohmann::json& object, std::string pointer);

    bool text(const LevelKey& key, std::string& value);
    bool flag(const LevelKey& key, bool& value);
    bool point(const LevelKey& key, glm::dvec3& value);
    bool colour(const LevelKey& key, glm::vec3& srgb);
    bool linear_colour(const LevelKey& key, glm::vec3& linear);
    bool file(const LevelKey& key, std::filesystem::path& value);
    bool constant(const LevelKey& key, std::string_view expected);
    bool texts(const LevelKey& key, std::vector<std::string>& values);
    void ignored(const LevelKey& key) { find(key); }
    void params(ParamSettings& values);

    template <std::floating_point Real>
    bool real(const LevelKey& key, const LevelRange& range, Real& value)
    {
        const std::optional<double> stated = number(key, range);
        if (stated) value = static_cast<Real>(*stated);
        return stated.has_value();
    }
    bool angle(const LevelKey& key, const LevelRange& range_deg, float& rad);

    template <typename Enum>
    bool choice(const LevelKey& key, std::span<const std::string_view> names, Enum& value)
    {
        const std::optional<std::size_t> stated = index_of(key, names);
        if (stated) value = static_cast<Enum>(*stated);
        return stated.has_value();
    }

    template <typename T>
    bool object(const LevelKey& key, T& value)
    {
        const nlohmann::json* stated = find(key);
        if (stated) read_object(*stated, pointer_to(pointer_, key.name), value);
        return stated != nullptr;
    }

    template <typename T>
    bool objects(const LevelKey& key, std::vector<T>& values)
    {
        const nlohmann::json* stated = find_list(key);
        for (std::size_t i = 0; stated && i < stated->size(); ++i)
            read_object((*stated)[i], pointer_to(pointer_to(pointer_, key.name), i), values.emplace_back());
        return stated != nullptr;
    }

    template <typename T>
    bool named(const LevelKey& key, std::map<std::string, T>& values)
    {
        const nlohmann::json* stated = find_names(key);
        if (!stated) return false;
        for (const auto& [name, value] : stated->items())
            read_object(value, pointer_to(pointer_to(pointer_, key.name), name), values[name]);
        return true;
    }

    // A value that may be absent is read as the value itself.
    template <typename T>
    bool text(const LevelKey& key, std::optional<T>& value)
    {
        return optionally(value, [&](T& target) { return text(key, target); });
    }
    template <typename T>
    bool flag(const LevelKey& key, std::optional<T>& value)
    {
        return optionally(value, [&](T& target) { return flag(key, target); });
    }
    template <typename T>
    bool colour(const LevelKey& key, std::optional<T>& value)
    {
        return optionally(value, [&](T& target) { return colour(key, target); });
    }
    template <typename T>
    bool texts(const LevelKey& key, std::optional<T>& value)
    {
        return optionally(value, [&](T& target) { return texts(key, target); });
    }
    template <typename T>
    bool real(const LevelKey& key, const LevelRange& range, std::optional<T>& value)
    {
        return optionally(value, [&](T& target) { return real(key, range, target); });
    }
    template <typename T>
    bool object(const LevelKey& key, std::optional<T>& value)
    {
        return optionally(value, [&](T& target) { return object(key, target); });
    }

    /// Call after the visit: throws for a key that was not visited, naming those that exist.
    void refuse_unknown() const;
    bool has(std::string_view name) const { return object_.contains(name); }
    const std::string& pointer() const { return pointer_; }
    [[noreturn]] void refuse(const std::string& pointer, std::string what, std::string expected) const;

 private:
    template <typename T>
    void read_object(const nlohmann::json& value, const std::string& pointer, T& target) const
    {
        LevelReader reader(level_, value, pointer);
        visit_keys(reader, target);
        reader.refuse_unknown();
        finish(reader, target);
    }

    template <typename T, typename Read>
    static bool optionally(std::optional<T>& value, Read read)
    {
        T target{};
        if (!read(target)) return false;
        value = std::move(target);
        return true;
    }

    // What no single key can tell: keys that need or exclude each other, and where the object stands.
    template <typename T>
    static void finish(const LevelReader&, T&)
    {
    }
    static void finish(const LevelReader& reader, StyleDesc& style);
    static void finish(const LevelReader& reader, AssignRule& rule) { rule.pointer = reader.pointer(); }
    static void finish(const LevelReader& reader, StartPlace& place);
    static void finish(const LevelReader& reader, Camera& camera);
    static void finish(const LevelReader& reader, CameraPath& path);
    static void finish(const LevelReader& reader, Light& light);

    const nlohmann::json* find(const LevelKey& key);
    const nlohmann::json* find_list(const LevelKey& key);
    const nlohmann::json* find_names(const LevelKey& key);
    std::optional<double> number(const LevelKey& key, const LevelRange& range);
    std::optional<std::size_t> index_of(const LevelKey& key, std::span<const std::string_view> names);
    void require_look(const glm::dvec3& position, const glm::dvec3& look_at, const std::string& pointer) const;

    const Level& level_;
    const nlohmann::json& object_;
    std::string pointer_;
    std::vector<std::string> visited_;
    bool is_open_ = false;  ///< Keys that are not visited are parameters.
};

}  // namespace hw
