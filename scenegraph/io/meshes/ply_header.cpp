#include "hatchway/io/meshes/ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "hatchway/core/log.hpp"
#include "hatchway/io/meshes/checked_mesh.hpp"

namespace hw {
namespace {

constexpr std::size_t kMaxProperties = 1000;
constexpr std::array<std::string_view, 3> kEncodings{"ascii", "binary_little_endian", "binary_big_endian"};
constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
constexpr std::array<std::string_view, 8> kTypes{"int8",  "uint8",  "int16",   "uint16",
                                                 "int32", "uint32", "float32", "float64"};
constexpr std::array<std::string_view, 8> kOldTypes{"char", "uchar", "short", "ushort",
                                                    "int",  "uint",  "float", "double"};
// OpenMesh knows four types of counts. The others have as many bytes and, in range, the same bits.
constexpr std::array<std::string_view, 6> kCountTypes{"uint8", "uint8", "uint16", "uint16", "int", "int"};

/// Other names of what is used.
struct Synonym {
    std::string_view stated;
    std::string_view known;
};
constexpr Synonym kSynonyms[] = {{"s", "u"},
                                 {"t", "v"},
                                 {"texture_u", "u"},
                                 {"texture_v", "v"},
                                 {"diffuse_red", "red"},
                                 {"diffuse_green", "green"},
                                 {"diffuse_blue", "blue"},
                                 {"vertex_index", "vertex_indices"}};

class HeaderReader {
 public:
    HeaderReader(std::string_view bytes, const std::string& name) : bytes_(bytes), lines_(bytes), name_(name) {}

    PlyHeader run()
    {
        std::string_view line;
        if (!lines_.next(line) || (trimmed(line) != "ply" && trimmed(line) != "PLY"))
            place().refuse("the file does not begin with \"ply\"");
        bool has_encoding = false;
        while (lines_.next(line)) {
            const std::string_view word = next_word(line);
            if (word == "end_header") return finished(has_encoding);
            if (word.empty() || word == "comment" || word == "obj_info") continue;
            if (word == "format") {
                read_encoding(line);
                has_encoding = true;
            } else if (word == "element") {
                read_element(line);
            } else if (word == "property" && !header_.elements.empty()) {
                read_property(line);
            } else {
                place().refuse(fmt::format("stands \"{}\"", word.substr(0, 40)), "a line of a PLY header");
            }
        }
        place().refuse("the header does not end", "\"end_header\"");
    }

 private:
    FilePlace place() const { return {name_, "line", lines_.number()}; }

    void read_encoding(std::string_view line)
    {
        const std::string_view word = next_word(line);
        const auto found = std::ranges::find(kEncodings, word);
        if (found == kEncodings.end())
            place().refuse(fmt::format("the format is \"{}\"", word.substr(0, 40)),
                           fmt::format("{}", fmt::join(kEncodings, ", ")));
        header_.encoding = static_cast<PlyEncoding>(found - kEncodings.begin());
    }

    void read_element(std::string_view line)
    {
        PlyElement element;
        element.name = next_word(line);
        const std::string_view word = next_word(line);
        const std::optional<std::int64_t> count = parse_whole(word);
        if (!count || *count < 0) place().refuse(fmt::format("\"{}\" is no count", word.substr(0, 40)));
        element.count = static_cast<std::uint64_t>(*count);
        for (const PlyElement& other : header_.elements)
            if (other.name == element.name)
                place().refuse(fmt::format("the element \"{}\" is there twice", element.name.substr(0, 40)));
        if (element.name == "vertex") check_vertex_count(element.count, place());
        if (element.name == "face") check_triangle_count(element.count, place());
        header_.elements.push_back(std::move(element));
    }

    PlyType type_of(std::string_view word) const
    {
        for (const auto& names : {kTypes, kOldTypes})
            if (const auto found = std::ranges::find(names, word); found != names.end())
                return static_cast<PlyType>(found - names.begin());
        place().refuse(fmt::format("\"{}\" is no type of numbers", word.substr(0, 40)),
                       fmt::format("{}", fmt::join(kOldTypes, ", ")));
    }

    void read_property(std::string_view line)
    {
        PlyProperty property;
        std::string_view word = next_word(line);
        if (word == "list") {
            property.count_type = type_of(next_word(line));
            if (!is_whole(*property.count_type)) place().refuse("a list's length is no whole number");
            word = next_word(line);
        }
        property.type = type_of(word);
        property.name = next_word(line);
        for (const Synonym& synonym : kSynonyms)
            if (property.name == synonym.stated) property.name = synonym.known;
        PlyElement& element = header_.elements.back();
        for (const PlyProperty& other : element.properties)
            if (other.name == property.name)
                place().refuse(fmt::format("the property \"{}\" is there twice", property.name.substr(0, 40)));
        if (++properties_ > kMaxProperties)
            place().refuse("there are too many properties", fmt::format("at most {}", kMaxProperties));
        element.properties.push_back(std::move(property));
    }

    PlyElement& element(std::string_view name)
    {
        const auto found = std::ranges::find(header_.elements, name, &PlyElement::name);
        if (found == header_.elements.end() || found->count == 0)
            place().refuse(fmt::format("there is no element \"{}\"", name), "a mesh with vertices and faces");
        return *found;
    }

    /// Uses properties when all are there and of such a type; says so when only their type hinders.
    template <typename Fits>
    bool use(PlyElement& element, std::initializer_list<std::string_view> names, PlyUse use, Fits fits)
    {
        std::vector<PlyProperty*> found;
        for (PlyProperty& property : element.properties)
            if (std::ranges::find(names, property.name) != names.end()) found.push_back(&property);
        if (found.size() != names.size()) return false;
        for (const PlyProperty* property : found)
            if (property->count_type.has_value() != (use == PlyUse::corners) || !fits(property->type)) {
                log_warning(fmt::format("{}: \"{}\" of its {} elements is of a type that is not read", name_,
                                        property->name, element.name));
                return false;
            }
        for (PlyProperty* property : found) property->use = use;
        return true;
    }

    PlyHeader finished(bool has_encoding)
    {
        if (!has_encoding) place().refuse("the header states no format");
        const auto is_float = [](PlyType type) { return !is_whole(type); };
        const auto is_colour = [](PlyType type) { return type == PlyType::uint8 || type == PlyType::float32; };
        PlyElement& vertex = element("vertex");
        if (!use(vertex, {"x", "y", "z"}, PlyUse::coordinate, is_float))
            place().refuse("vertices have no x, y and z that can be read", "float or double");
        use(vertex, {"nx", "ny", "nz"}, PlyUse::normal, is_float);
        use(vertex, {"u", "v"}, PlyUse::uv, is_float);
        PlyElement& face = element("face");
        if (!use(face, {"vertex_indices"}, PlyUse::corners, is_whole))
            place().refuse("faces have no list of whole vertex_indices");
        for (PlyElement* owner : {&vertex, &face})
            if (use(*owner, {"red", "green", "blue"}, PlyUse::colour, is_colour))
                use(*owner, {"alpha"}, PlyUse::colour, is_colour);
        header_.size = bytes_.size() - lines_.rest().size();
        return std::move(header_);
    }

    std::string_view bytes_;
    TextLines lines_;
    const std::string& name_;
    PlyHeader header_;
    std::size_t properties_ = 0;
};

std::string line_of(const PlyProperty& property)
{
    const std::string_view type = kTypes[static_cast<std::size_t>(property.type)];
    if (!property.count_type) return fmt::format("property {} {}\n", type, property.name);
    return fmt::format("property list {} {} {}\n", kCountTypes[static_cast<std::size_t>(*property.count_type)], type,
                       property.name);
}

}  // namespace

std::size_t size_of(PlyType type)
{
    return kSizes[static_cast<std::size_t>(type)];
}

bool PlyElement::uses(PlyUse use) const
{
    return std::ranges::find(properties, use, &PlyProperty::use) != properties.end();
}

std::uint64_t PlyHeader::vertices() const
{
    return std::ranges::find(elements, "vertex", &PlyElement::name)->count;
}

PlyHeader read_ply_header(std::string_view bytes, const std::string& name)
{
    return HeaderReader(bytes, name).run();
}

std::string text_of(const PlyHeader& header)
{
    std::string text = fmt::format("ply\nformat {} 1.0\n", kEncodings[static_cast<std::size_t>(header.encoding)]);
    for (const PlyElement& element : header.elements) {
        if (element.name != "vertex" && element.name != "face") continue;
        text += fmt::format("element {} {}\n", element.name, element.count);
        // OpenMesh wants corners first.
        for (const bool wants_corners : {true, false})
            for (const PlyProperty& property : element.properties)
                if (property.use != PlyUse::skipped && (property.use == PlyUse::corners) == wants_corners)
                    text += line_of(property);
    }
    return text + "end_header\n";
}

}  // namespace hw
