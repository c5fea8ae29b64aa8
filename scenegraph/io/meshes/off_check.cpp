// OpenMesh reads the letters before "OFF" only from files that it opens itself; from a stream it takes positions and
// indices, and stumbles over comments, counts in the first line and colours behind faces. So it gets positions and
// indices alone, and colours and normals are read here.
#include "hatchway/io/meshes/off_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace hw {
namespace {

class OffCheck {
 public:
    OffCheck(std::string_view bytes, const std::string& name) : lines_(bytes), name_(name) {}

    CheckedMesh run()
    {
        read_header();
        const std::uint64_t stated_faces = std::exchange(result_.faces, 0);
        for (std::uint64_t i = 0; i < result_.vertices; ++i) read_vertex(next_line());
        for (std::uint64_t i = 0; i < stated_faces; ++i) read_face(next_line());
        result_.text.insert(0, fmt::format("OFF\n{} {} 0\n", result_.vertices, result_.faces));
        return std::move(result_);
    }

 private:
    FilePlace place() const { return {name_, "line", lines_.number()}; }

    /// The next line with a word; comments are taken out.
    std::string_view next_line()
    {
        for (std::string_view line; lines_.next(line);)
            if (line = trimmed(without_comment(line)); !line.empty()) return line;
        place().refuse("the file ends early", "all vertices and faces that its counts announce");
    }

    void read_header()
    {
        std::string_view line = next_line();
        std::string_view kind = next_word(line);
        if (kind.starts_with('C')) kind.remove_prefix(1);
        if (kind.starts_with('N')) {
            result_.has_normals = true;
            kind.remove_prefix(1);
        }
        if (kind != "OFF" || trimmed(line).starts_with("BINARY"))
            place().refuse("the file does not begin as an OFF file that is read here",
                           "OFF, COFF, NOFF or CNOFF, as text");
        if (trimmed(line).empty()) line = next_line();
        result_.vertices = count_of(line);
        result_.faces = count_of(line);
        check_vertex_count(result_.vertices, place());
        check_triangle_count(result_.faces, place());
        // A vertex takes six bytes ("0 0 0\n"), a face at least two.
        if (6 * result_.vertices + 2 * result_.faces > lines_.rest().size() + 2)
            place().refuse(fmt::format("{} vertices and {} faces are announced, {} bytes follow", result_.vertices,
                                       result_.faces, lines_.rest().size()));
    }

    std::uint64_t count_of(std::string_view& line) const
    {
        const std::string_view word = next_word(line);
        const std::optional<std::int64_t> count = parse_whole(word);
        if (!count || *count < 0) place().refuse(fmt::format("\"{}\" is no count", word), "vertices, faces, edges");
        return static_cast<std::uint64_t>(*count);
    }

    double number_of(std::string_view& line) const
    {
        const std::string_view word = next_word(line);
        const std::optional<double> value = parse_number(word);
        if (!value) place().refuse(fmt::format("stands \"{}\"", word), "a number");
        return *value;
    }

    void read_vertex(std::string_view line)
    {
        glm::vec3 position(0.0f);
        for (int axis = 0; axis < 3; ++axis) position[axis] = checked_coordinate(number_of(line), place());
        fmt::format_to(std::back_inserter(result_.text), "{} {} {}\n", position.x, position.y, position.z);
        if (result_.has_normals) {
            glm::vec3 normal(0.0f);
            for (int axis = 0; axis < 3; ++axis) normal[axis] = static_cast<float>(number_of(line));
            result_.normals.push_back(normal);
        }
        add_colour(line, result_.colours, result_.vertices, result_.has_colours);
    }

    void read_face(std::string_view line)
    {
        const std::int64_t corners = parse_whole(next_word(line)).value_or(-1);
        check_corner_count(corners, place());
        std::string face = std::to_string(corners);
        for (std::int64_t i = 0; i < corners; ++i) {
            const std::string_view word = next_word(line);
            const std::int64_t index = parse_whole(word).value_or(-1);
            if (index < 0 || static_cast<std::uint64_t>(index) >= result_.vertices)
                place().refuse(fmt::format("stands the index \"{}\"", word),
                               fmt::format("indices below the vertex count {}", result_.vertices));
            (face += ' ') += word;
        }
        if (corners < 3) {
            ++result_.faces_without_area;
            return;
        }
        triangles_ += static_cast<std::uint64_t>(corners) - 2;
        check_triangle_count(triangles_, place());
        ++result_.faces;
        (result_.text += face) += '\n';
        add_colour(line, result_.face_colours, 0, result_.has_face_colours);
    }

    /// Three or four numbers: whole ones to 255, others to 1. One that is missing among others is white.
    void add_colour(std::string_view line, std::vector<glm::vec4>& colours, std::uint64_t expected, bool& has_any)
    {
        const bool is_whole = line.find_first_of(".eE") == std::string_view::npos;
        glm::vec4 colour(1.0f);
        if (const std::size_t words = count_words(line); words >= 3) {
            for (int i = 0; i < (words == 3 ? 3 : 4); ++i) {
                const double value = number_of(line) / (is_whole ? 255.0 : 1.0);
                colour[i] = value > 0.0 ? static_cast<float>(std::min(value, 1.0)) : 0.0f;
            }
            has_any = true;
        }
        if (colours.empty()) colours.reserve(expected);
        colours.push_back(colour);
    }

    TextLines lines_;
    const std::string& name_;
    CheckedMesh result_;
    std::uint64_t triangles_ = 0;
};

}  // namespace

CheckedMesh check_off(std::string bytes, const std::string& name)
{
    return OffCheck(bytes, name).run();
}

}  // namespace hw
