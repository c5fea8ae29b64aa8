#pragma once

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

/// Makes small glTF models for tests, right or wrong on purpose.
class ModelBuilder {
 public:
    nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
    std::string binary;

    /// Adds a buffer view with these values and an accessor over it; returns the accessor's index.
    template <typename T>
    int add_accessor(const std::vector<T>& values, int component_type, const std::string& type, int components)
    {
        const int view = add_view(values);
        return add_accessor_of_view(view, component_type, type, static_cast<int>(values.size()) / components);
    }

    template <typename T>
    int add_view(const std::vector<T>& values)
    {
        while (binary.size() % 4 != 0) binary += '\0';
        const std::size_t offset = binary.size();
        binary.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
        return push("bufferViews", {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", values.size() * sizeof(T)}});
    }

    int add_accessor_of_view(int view, int component_type, const std::string& type, int count)
    {
        return push("accessors",
                    {{"bufferView", view}, {"componentType", component_type}, {"type", type}, {"count", count}});
    }

    int add_positions(const std::vector<float>& xyz) { return add_accessor(xyz, 5126, "VEC3", 3); }
    int add_indices(const std::vector<std::uint16_t>& indices) { return add_accessor(indices, 5123, "SCALAR", 1); }

    /// A mesh of one primitive and a root node that shows it; returns the primitive.
    nlohmann::json& add_object(const nlohmann::json& attributes)
    {
        const int mesh = push("meshes", {{"primitives", {{{"attributes", attributes}}}}});
        const int node = push("nodes", {{"mesh", mesh}});
        if (!json.contains("scenes")) json["scenes"].push_back({{"nodes", nlohmann::json::array()}});
        json["scenes"][0]["nodes"].push_back(node);
        return json["meshes"][mesh]["primitives"][0];
    }

    int push(const char* list, const nlohmann::json& value)
    {
        json[list].push_back(value);
        return static_cast<int>(json[list].size()) - 1;
    }

    std::string glb() const
    {
        nlohmann::json document = json;
        if (!binary.empty()) document["buffers"] = {{{"byteLength", binary.size()}}};
        return container(document.dump(), binary);
    }

    /// A binary glTF file of these two parts.
    static std::string container(std::string text, std::string bin)
    {
        while (text.size() % 4 != 0) text += ' ';
        while (bin.size() % 4 != 0) bin += '\0';
        const std::size_t size = 20 + text.size() + (bin.empty() ? 0 : 8 + bin.size());
        std::string file = "glTF" + word(2) + word(size) + word(text.size()) + "JSON" + text;
        if (!bin.empty()) file += word(bin.size()) + std::string("BIN\0", 4) + bin;
        return file;
    }

    static std::string word(std::size_t value)
    {
        const auto bits = static_cast<std::uint32_t>(value);
        std::string text(4, '\0');
        std::memcpy(text.data(), &bits, 4);
        return text;
    }
};

/// One triangle in the plane z = 0, with the corners (0,0), (1,0), (0,1).
inline ModelBuilder triangle_model()
{
    ModelBuilder builder;
    const int positions = builder.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int indices = builder.add_indices({0, 1, 2});
    builder.add_object({{"POSITION", positions}})["indices"] = indices;
    return builder;
}
