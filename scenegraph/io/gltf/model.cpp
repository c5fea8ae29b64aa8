#include "hatchway/io/gltf/model.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/io/gltf/check/check.hpp"
#include "hatchway/io/gltf/glb_container.hpp"
#include "hatchway/io/json/text.hpp"

namespace hw {
namespace {

using nlohmann::json;
using Bytes = std::vector<std::byte>;

constexpr std::size_t kMaxJsonBytes = 256u << 20;  // "[0,0,0..." takes ten times its size as a document

constexpr const char* kParsedParts[] = {"asset", "accessors", "bufferViews", "cameras", "materials", "meshes",
                                        "nodes", "samplers",  "scene",       "scenes",  "textures"};

/// What a GltfModel refers to.
struct ParsedDocument {
    json document;
    tinygltf::Model data;
};

Bytes read_buffer(GltfModel& model, std::size_t index, const std::optional<std::span<const std::byte>>& binary)
{
    const json& buffer = model.json.at("buffers")[index];
    const std::string pointer = pointer_to("/buffers", index);
    const auto length = buffer.at("byteLength").get<std::size_t>();
    Bytes bytes;
    if (buffer.contains("uri"))
        bytes = model.resources.read(buffer.at("uri").get<std::string>(), pointer + "/uri");
    else if (index == 0 && binary)
        bytes.assign(binary->begin(), binary->end());
    else
        model.refuse(pointer, "the buffer has no uri", "one, or to be the first of a .glb with a BIN chunk");
    if (bytes.size() < length)
        model.refuse(pointer + "/byteLength", fmt::format("{} bytes are stated, {} are there", length, bytes.size()));
    bytes.resize(length);  // The container pads to four bytes.
    return bytes;
}

void remove_extras(json& value)
{
    if (value.is_object()) {
        value.erase("extras");
        value.erase("extensions");
    }
    if (value.is_structured())
        for (json& element : value) remove_extras(element);
}

json copy_for_tinygltf(const json& checked, std::size_t buffer_count)
{
    json copy = json::object();
    for (const char* part : kParsedParts)
        if (const auto found = checked.find(part); found != checked.end()) copy[part] = *found;
    remove_extras(copy);
    for (std::size_t i = 0; i < buffer_count; ++i)
        copy["buffers"].push_back(
            {{"uri", std::to_string(i)}, {"byteLength", checked.at("buffers")[i].at("byteLength")}});
    return copy;
}

/// tinygltf's view of the file system: the loaded buffers, named by number.
tinygltf::FsCallbacks callbacks_over(std::vector<Bytes>& buffers)
{
    tinygltf::FsCallbacks callbacks = {};
    callbacks.FileExists = [](const std::string&, void*) { return true; };
    callbacks.ExpandFilePath = [](const std::string& name, void*) { return name; };
    callbacks.ReadWholeFile = [](std::vector<unsigned char>* target, std::string*, const std::string& name,
                                 void* data) {
        auto& loaded = *static_cast<std::vector<Bytes>*>(data);
        std::size_t index = loaded.size();
        std::from_chars(name.data(), name.data() + name.size(), index);
        if (index >= loaded.size()) return false;
        const auto* first = reinterpret_cast<const unsigned char*>(loaded[index].data());
        target->assign(first, first + loaded[index].size());
        Bytes().swap(loaded[index]);
        return true;
    };
    callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
        return false;
    };
    callbacks.user_data = &buffers;
    return callbacks;
}

bool refuse_image(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int, void*)
{
    return false;
}

void parse_with_tinygltf(const GltfModel& model, std::vector<Bytes>& buffers, tinygltf::Model& data)
{
    const std::string text = copy_for_tinygltf(model.json, buffers.size()).dump();
    tinygltf::TinyGLTF parser;
    parser.SetFsCallbacks(callbacks_over(buffers));
    parser.SetImageLoader(refuse_image, nullptr);
    std::string error;
    std::string warning;
    const bool is_parsed = parser.LoadASCIIFromString(&data, &error, &warning, text.data(),
                                                      static_cast<unsigned>(text.size()), "", tinygltf::NO_REQUIRE);
    if (!is_parsed) model.refuse("", "tinygltf cannot read the model: " + error);
}

}  // namespace

std::span<const std::byte> GltfModel::view(int index) const
{
    const tinygltf::BufferView& view = data.bufferViews[index];
    return std::as_bytes(std::span(data.buffers[view.buffer].data)).subspan(view.byteOffset, view.byteLength);
}

const nlohmann::json* GltfModel::extension(const nlohmann::json& object, const char* name)
{
    const auto extensions = object.find("extensions");
    if (extensions == object.end()) return nullptr;
    const auto found = extensions->find(name);
    return found == extensions->end() ? nullptr : &*found;
}

void GltfModel::refuse(const std::string& pointer, std::string what, std::string expected) const
{
    throw Error({.what = std::move(what), .file = file, .pointer = pointer, .expected = std::move(expected)});
}

GltfModel load_gltf(const std::filesystem::path& file, const std::filesystem::path& project_root)
{
    const auto parsed = std::make_shared<ParsedDocument>();
    GltfModel model{.file = file.string(),
                    .json = parsed->document,
                    .data = parsed->data,
                    .resources = GltfResources(file, project_root),
                    .owner = parsed};
    const Bytes bytes = read_file(file, limits::kMaxFileBytes);
    const GltfParts parts = split_gltf(bytes, model.file);
    if (parts.json.size() > kMaxJsonBytes)
        model.refuse("", fmt::format("the JSON has {} bytes", parts.json.size()),
                     fmt::format("at most {}", kMaxJsonBytes));
    parsed->document = parse_json(parts.json, model.file, JsonComments::refused);
    check_gltf(parsed->document, model.file);

    std::vector<Bytes> buffers;
    const std::size_t buffer_count = model.json.contains("buffers") ? model.json.at("buffers").size() : 0;
    for (std::size_t i = 0; i < buffer_count; ++i) buffers.push_back(read_buffer(model, i, parts.binary));
    parse_with_tinygltf(model, buffers, parsed->data);
    return model;
}

}  // namespace hw
