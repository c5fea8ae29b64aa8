#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hatchway/core/limits.hpp"
#include "hatchway/io/json/text.hpp"
#include "hatchway/io/level/keys.hpp"

namespace hw {

/// Fills an object of a level from JSON: the visitor of visit_keys() that reads. Every function tells whether the key
/// was there, and throws hw::Error when its value is wrong. Private to io.
class LevelReader {
 public:
    /// Reads a whole level; its `file` and `project_root` are set.
    static void read(const nlohmann::json& document, Level& level);

    /// `level` gives the file and the project's root; `object` and `pointer` must outlive the reader.
    LevelReader(const Level& level, const nlohmann::json& object, std::string pointer);

    // A value may also be an optional: absent keys leave it empty.
    template <typename T>
    bool text(const LevelKey& key, T& value)
    {
        return set(value, text_of(key));
    }
    template <typename T>
    bool flag(const LevelKey& key, T& value)
    {
        return set(value, flag_of(key));
    }
    template <typename T>
    bool colour(const LevelKey& key, T& srgb)
    {
        return set(srgb, colour_of(key));
    }
    template <typename T>
    bool texts(const LevelKey& key, T& values)
    {
        return set(values, texts_of(key));
    }
    template <typename T>
    bool real(const LevelKey& key, const LevelRange& range, T& value)
    {
        return set(value, number(key, range));
    }
    template <typename Enum>
    bool choice(const LevelKey& key, std::span<const std::string_view> names, Enum& value)
    {
        const std::optional<std::size_t> stated = index_of(key, names);
        if (stated) value = static_cast<Enum>(*stated);
        return stated.has_value();
    }
    bool whole(const LevelKey& key, const LevelRange& range, int& value);
    bool point(const LevelKey& key, glm::dvec3& value);
    bool linear_colour(const LevelKey& key, glm::vec3& linear);
    bool angle(const LevelKey& key, const LevelRange& range_deg, float& rad);
    bool file(const LevelKey& key, std::filesystem::path& value);
    bool constant(const LevelKey& key, std::string_view expected);
    void ignored(const LevelKey& key) { find(key); }
    /// Exactly one of two keys that have been visited.
    void one_of(std::string_view first, std::string_view second) const;
    /// At most one of two keys that have been visited.
    void not_both(std::string_view first, std::string_view second) const;
    void params(ParamSettings& values);

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
        const std::optional<std::vector<Part>> stated = elements_of(key);
        if (!stated) return false;
        for (const Part& part : *stated) read_object(part.value, part.pointer, values.emplace_back());
        return true;
    }

    template <typename T>
    bool named(const LevelKey& key, std::map<std::string, T>& values)
    {
        const std::optional<std::vector<Part>> stated = members_of(key);
        if (!stated) return false;
        for (const Part& part : *stated) read_object(part.value, part.pointer, values[part.name]);
        return true;
    }

    /// Things that know their names; in any order.
    template <typename T>
    bool named(const LevelKey& key, std::vector<T>& values)
    {
        std::map<std::string, T> by_name;
        const bool is_stated = named(key, by_name);
        for (auto& [name, value] : by_name) {
            values.push_back(std::move(value));
            values.back().name = name;
        }
        return is_stated;
    }

    template <typename T>
    bool object(const LevelKey& key, std::optional<T>& value)
    {
        T target{};
        if (object(key, target)) value = std::move(target);
        return value.has_value();
    }

    /// Call after the visit: throws for a key that was not visited, naming those that exist.
    void refuse_unknown() const;
    bool has(std::string_view name) const;
    const std::string& pointer() const { return pointer_; }
    [[noreturn]] void refuse(const std::string& pointer, std::string what, std::string expected) const;

 private:
    /// An element of an array, or a member of an object, and where it stands.
    struct Part {
        const nlohmann::json& value;
        std::string pointer;
        std::string name;  ///< Of a member.
    };

    template <typename T>
    void read_object(const nlohmann::json& value, const std::string& pointer, T& target) const
    {
        LevelReader reader(level_, value, pointer);
        visit_keys(reader, target);
        reader.refuse_unknown();
        finish(reader, target);
    }

    template <typename T, typename U>
    static bool set(T& target, const std::optional<U>& stated)
    {
        if (stated) target = *stated;
        return stated.has_value();
    }

    // What no single key can tell: keys that need or exclude each other, and where the object stands.
    template <typename T>
    static void finish(const LevelReader&, T&)
    {
    }
    static void finish(const LevelReader& reader, StyleDesc& style);
    static void finish(const LevelReader& reader, AssignRule& rule);
    static void finish(const LevelReader& reader, MirrorRule& mirror);
    static void finish(const LevelReader& reader, StartPlace& place);
    static void finish(const LevelReader& reader, Camera& camera);
    static void finish(const LevelReader& reader, CameraPath& path);
    static void finish(const LevelReader& reader, Light& light);
    static void finish(const LevelReader& reader, Level& level);

    const nlohmann::json* find(const LevelKey& key);
    const nlohmann::json* find_list(const LevelKey& key);
    std::optional<std::vector<Part>> elements_of(const LevelKey& key);
    std::optional<std::vector<Part>> members_of(const LevelKey& key);
    std::optional<std::string> text_of(const LevelKey& key);
    std::optional<bool> flag_of(const LevelKey& key);
    std::optional<glm::vec3> colour_of(const LevelKey& key);
    std::optional<std::vector<std::string>> texts_of(const LevelKey& key);
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
