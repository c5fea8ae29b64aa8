// OpenMesh's reader takes a binary file's count at its word, takes "outer" in a solid's name for the beginning of a
// facet, and joins corners that are closer than the smallest normal float. So facets are looked at one by one, tiny
// coordinates become 0, and facets of two equal corners, which it drops, are counted and dropped here.
#include "hatchway/io/meshes/stl_check.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstring>
#include <iterator>

#include "hatchway/core/limits.hpp"

namespace hw {
namespace {

constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kFacetBytes = 50;
constexpr std::size_t kNormalBytes = 12;
constexpr float kTiny = 1e-30f;  // floats that differ and are not smaller differ by more than the smallest normal one

using Facet = std::array<glm::vec3, 3>;

float tiny_to_zero(float value)
{
    return std::abs(value) < kTiny ? 0.0f : value;
}

bool has_equal_corners(const Facet& facet)
{
    return facet[0] == facet[1] || facet[1] == facet[2] || facet[2] == facet[0];
}

std::uint32_t stated_count(std::string_view bytes)
{
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + kHeaderBytes - sizeof(count), sizeof(count));
    return count;
}

bool is_binary_size(std::string_view bytes)
{
    return bytes.size() >= kHeaderBytes &&
           bytes.size() == kHeaderBytes + kFacetBytes * std::size_t{stated_count(bytes)};
}

CheckedMesh check_binary(std::string_view bytes, const std::string& name)
{
    CheckedMesh result;
    result.is_binary = true;
    check_triangle_count(stated_count(bytes), {name, "byte", kHeaderBytes - sizeof(std::uint32_t)});
    std::string facets;
    facets.reserve(bytes.size());
    for (std::size_t at = kHeaderBytes; at < bytes.size(); at += kFacetBytes) {
        std::array<float, 9> numbers;
        std::memcpy(numbers.data(), bytes.data() + at + kNormalBytes, sizeof(numbers));
        for (float& number : numbers) number = tiny_to_zero(checked_coordinate(number, {name, "byte", at}));
        const Facet facet{glm::vec3(numbers[0], numbers[1], numbers[2]), glm::vec3(numbers[3], numbers[4], numbers[5]),
                          glm::vec3(numbers[6], numbers[7], numbers[8])};
        if (has_equal_corners(facet)) {
            ++result.faces_without_area;
            continue;
        }
        ++result.faces;
        facets.append(kNormalBytes, '\0');
        facets.append(reinterpret_cast<const char*>(numbers.data()), sizeof(numbers));
        facets.append(kFacetBytes - kNormalBytes - sizeof(numbers), '\0');
    }
    const auto count = static_cast<std::uint32_t>(result.faces);
    result.text.assign(kHeaderBytes - sizeof(count), ' ');
    result.text.append(reinterpret_cast<const char*>(&count), sizeof(count));
    result.text += facets;
    return result;
}

/// Facets of solids, word by word, as the files of this kind differ in their lines.
class StlTextCheck {
 public:
    StlTextCheck(std::string_view bytes, const std::string& name) : lines_(bytes), name_(name)
    {
        result_.parts.clear();
        result_.runs.clear();
    }

    CheckedMesh run()
    {
        for (std::string_view line; lines_.next(line);) {
            const std::string_view word = next_word(line);
            if (word == "solid" || word == "SOLID")
                begin_solid(trimmed(line));
            else if (word == "vertex" || word == "VERTEX")
                read_corner(line);
            else if (word == "endloop" || word == "ENDLOOP")
                end_facet();
        }
        if (corners_ != 0) place().refuse("the last facet does not end", "\"endloop\"");
        return std::move(result_);
    }

 private:
    FilePlace place() const { return {name_, "line", lines_.number()}; }

    void begin_solid(std::string_view solid)
    {
        if (result_.parts.size() >= limits::kMaxObjects)
            place().refuse("there are too many solids", fmt::format("at most {}", limits::kMaxObjects));
        result_.runs.push_back({result_.faces, result_.parts.size()});
        result_.parts.push_back({.object = std::string(solid)});
    }

    void read_corner(std::string_view line)
    {
        if (corners_ == 3) place().refuse("a facet has more than three corners", "triangles");
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view word = next_word(line);
            const std::optional<double> value = parse_number(word);
            if (!value) place().refuse(fmt::format("stands \"{}\"", word.substr(0, 40)), "a number");
            facet_[corners_][axis] = tiny_to_zero(checked_coordinate(*value, place()));
        }
        ++corners_;
    }

    void end_facet()
    {
        if (corners_ != 3) place().refuse(fmt::format("a facet has {} corners", corners_), "triangles");
        corners_ = 0;
        if (has_equal_corners(facet_)) {
            ++result_.faces_without_area;
            return;
        }
        if (result_.parts.empty()) begin_solid({});  // the file begins with "solids" or the like
        check_triangle_count(++result_.faces, place());
        result_.text += "outer loop\n";
        for (const glm::vec3& corner : facet_)
            fmt::format_to(std::back_inserter(result_.text), "vertex {} {} {}\n", corner.x, corner.y, corner.z);
    }

    TextLines lines_;
    const std::string& name_;
    CheckedMesh result_;
    Facet facet_{};
    std::size_t corners_ = 0;  ///< Of the facet, so far.
};

}  // namespace

CheckedMesh check_stl(std::string bytes, const std::string& name)
{
    if (is_binary_size(bytes)) return check_binary(bytes, name);
    if (bytes.starts_with("solid") || bytes.starts_with("SOLID")) return StlTextCheck(bytes, name).run();
    if (bytes.size() < kHeaderBytes)
        FilePlace{name, "byte", 0}.refuse(fmt::format("the file has {} bytes", bytes.size()),
                                          "\"solid\", or a header of 84 bytes");
    FilePlace{name, "byte", 80}.refuse(
        fmt::format("{} facets are announced, {} bytes follow", stated_count(bytes), bytes.size() - kHeaderBytes),
        fmt::format("{} bytes a facet", kFacetBytes));
}

}  // namespace hw
