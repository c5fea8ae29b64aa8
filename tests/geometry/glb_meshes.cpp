#include "tests/geometry/glb_meshes.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tests/shared_data.hpp"

namespace hw::test {
namespace {

class GlbFile {
 public:
    explicit GlbFile(const std::filesystem::path& file)
    {
        std::ifstream in(file, std::ios::binary);
        const std::string bytes(std::istreambuf_iterator<char>(in), {});
        for (std::size_t at = 12; at + 8 <= bytes.size();) {
            std::uint32_t length = 0;
            std::memcpy(&length, bytes.data() + at, 4);
            const std::string chunk = bytes.substr(at + 8, length);
            if (bytes.compare(at + 4, 4, "JSON") == 0) json = nlohmann::json::parse(chunk);
            if (bytes.compare(at + 4, 3, "BIN") == 0) binary_ = chunk;
            at += 8 + length;
        }
    }

    std::vector<glm::vec3> vectors(int accessor) const
    {
        const Place place = place_of(accessor, 12);
        std::vector<glm::vec3> result(place.count);
        for (std::size_t i = 0; i < place.count; ++i) {
            std::memcpy(&result[i].x, binary_.data() + place.offset + i * place.stride, 12);
        }
        return result;
    }
    std::vector<std::uint32_t> indices(int accessor) const
    {
        const int type = json["accessors"][accessor]["componentType"];
        const std::size_t size = type == 5125 ? 4 : type == 5123 ? 2 : 1;
        const Place place = place_of(accessor, size);
        std::vector<std::uint32_t> result(place.count, 0);
        for (std::size_t i = 0; i < place.count; ++i) {
            std::memcpy(&result[i], binary_.data() + place.offset + i * place.stride, size);
        }
        return result;
    }

    nlohmann::json json;

 private:
    struct Place {
        std::size_t offset, stride, count;
    };
    Place place_of(int accessor, std::size_t item_bytes) const
    {
        const auto& a = json["accessors"][accessor];
        const auto& view = json["bufferViews"][a["bufferView"].get<int>()];
        return {view.value("byteOffset", std::size_t{0}) + a.value("byteOffset", std::size_t{0}),
                view.value("byteStride", item_bytes), a["count"].get<std::size_t>()};
    }
    std::string binary_;
};

}  // namespace

std::vector<MeshData> read_glb_meshes(const std::filesystem::path& file)
{
    const GlbFile glb(file);
    std::vector<MeshData> meshes;
    for (const auto& mesh : glb.json["meshes"]) {
        for (const auto& primitive : mesh["primitives"]) {
            MeshData data;
            data.positions = glb.vectors(primitive["attributes"]["POSITION"]);
            if (primitive["attributes"].contains("NORMAL")) {
                data.normals = glb.vectors(primitive["attributes"]["NORMAL"]);
                data.has_own_normals = true;
            }
            data.indices = glb.indices(primitive["indices"]);
            meshes.push_back(std::move(data));
        }
    }
    return meshes;
}

std::vector<std::filesystem::path> shared_glb_files(const char* folder)
{
    std::vector<std::filesystem::path> files;
    const std::filesystem::path place = kSharedData / folder;
    if (!std::filesystem::is_directory(place)) return files;
    for (const auto& entry : std::filesystem::directory_iterator(place)) {
        if (entry.path().extension() == ".glb") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace hw::test
