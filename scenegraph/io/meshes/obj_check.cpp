// OpenMesh's reader opens material files by itself, at any path; it passes over vertices that it cannot read, so that
// all later indices mean others, forgets groups, and gives colours to the wrong vertices where some have none. So it
// gets vertices and faces alone, with indices from 1, every corner of a face with the same attributes, and each corner
// once.
#include "hatchway/io/meshes/obj_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <unordered_set>

#include "hatchway/core/limits.hpp"

namespace hw {
namespace {

/// A corner's vertex, texture coordinate and normal, from 1; 0 where it has none.
using ObjCorner = std::array<std::int64_t, 3>;
constexpr std::array<const char*, 3> kAttributes{"vertex", "texture coordinate", "normal"};

class ObjCheck {
 public:
    ObjCheck(std::string_view bytes, const std::string& name) : lines_(bytes), name_(name)
    {
        result_.text.reserve(bytes.size());
        result_.parts.clear();
        result_.runs.clear();
    }

    CheckedMesh run()
    {
        for (std::string_view line; next_line(line);) read_line(line);
        for (std::size_t i = 0; i < 3; ++i)
            if (largest_[i].index > counts_[i])
                FilePlace{name_, "line", largest_[i].line}.refuse(
                    fmt::format("a corner is the {} {}", kAttributes[i], largest_[i].index),
                    fmt::format("at most {}, as many as there are", counts_[i]));
        result_.vertices = static_cast<std::uint64_t>(counts_[0]);
        result_.has_uv = counts_[1] > 0;
        result_.has_normals = counts_[2] > 0;
        return std::move(result_);
    }

 private:
    FilePlace place() const { return {name_, "line", lines_.number()}; }

    /// A line that ends in '\' goes on in the next.
    bool next_line(std::string_view& line)
    {
        if (!lines_.next(line)) return false;
        if (!line.ends_with('\\')) return true;
        joined_.clear();
        do {
            joined_ += line.substr(0, line.size() - 1);
            joined_ += ' ';
        } while (lines_.next(line) && line.ends_with('\\'));
        joined_ += line;
        line = joined_;
        return true;
    }

    void read_line(std::string_view line)
    {
        const std::string_view word = next_word(line);
        if (word == "v")
            read_vertex(without_comment(line));
        else if (word == "vt")
            read_uv(without_comment(line));
        else if (word == "vn")
            read_normal(without_comment(line));
        else if (word == "f" || word == "fo")
            read_face(without_comment(line));
        else if (word == "o")
            change_part({.object = std::string(trimmed(line)), .material = now_.material});
        else if (word == "g")
            change_part({now_.object, std::string(trimmed(line)), now_.material});
        else if (word == "usemtl")
            change_part({now_.object, now_.group, std::string(trimmed(line))});
        else if (word == "mtllib")
            add_material_file(trimmed(line));
        else if (word == "l" || word == "p" || word == "curv" || word == "surf")
            ++result_.lines_and_points;
    }

    double number_of(std::string_view word) const
    {
        const std::optional<double> value = parse_number(word);
        if (!value) place().refuse(fmt::format("stands \"{}\"", word.substr(0, 40)), "a number");
        return *value;
    }

    /// Appends numbers as they stand; `fallback` where one is missing or not finite.
    void copy_numbers(std::string_view line, int count, std::string_view fallback)
    {
        for (int i = 0; i < count; ++i) {
            const std::string_view word = next_word(line);
            (result_.text += ' ') += !word.empty() && std::isfinite(number_of(word)) ? word : fallback;
        }
    }

    void read_vertex(std::string_view line)
    {
        result_.text += 'v';
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view word = next_word(line);
            checked_coordinate(number_of(word), place());
            (result_.text += ' ') += word;
        }
        const bool has_colour = count_words(line) >= 3;
        result_.has_colours |= has_colour;
        copy_numbers(has_colour ? line : std::string_view(), 3, "1");
        result_.text += '\n';
        check_vertex_count(static_cast<std::uint64_t>(++counts_[0]), place());
    }

    void read_uv(std::string_view line)
    {
        result_.text += "vt";
        copy_numbers(line, 2, "0");
        result_.text += '\n';
        check_vertex_count(static_cast<std::uint64_t>(++counts_[1]), place());
    }

    void read_normal(std::string_view line)
    {
        result_.text += "vn";
        copy_numbers(line, 3, "0");
        result_.text += '\n';
        check_vertex_count(static_cast<std::uint64_t>(++counts_[2]), place());
    }

    ObjCorner read_corner(std::string_view word)
    {
        const std::string_view stated = word;
        ObjCorner corner{};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t slash = std::min(word.find('/'), word.size());
            const std::string_view index = word.substr(0, slash);
            word.remove_prefix(std::min(slash + 1, word.size()));
            if (index.empty() && i > 0) continue;
            std::int64_t value = parse_whole(index).value_or(0);
            if (value < 0) value += counts_[i] + 1;
            if (value <= 0 || (i == 2 && !word.empty()))
                place().refuse(fmt::format("stands the corner \"{}\"", stated.substr(0, 40)),
                               "vertex/texture/normal: numbers from 1, or from -1 back");
            if (value > largest_[i].index) largest_[i] = {value, lines_.number()};
            corner[i] = value;
        }
        return corner;
    }

    void read_face(std::string_view line)
    {
        corners_.clear();
        for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
            corners_.push_back(read_corner(word));
            check_corner_count(static_cast<std::int64_t>(corners_.size()), place());
        }
        drop_repeated_corners();
        if (corners_.size() < 3) {
            ++result_.faces_without_area;
            return;
        }
        triangles_ += corners_.size() - 2;
        check_triangle_count(triangles_, place());
        begin_run();
        ++result_.faces;
        write_face();
    }

    void drop_repeated_corners()
    {
        constexpr std::size_t kFew = 16;
        if (corners_.size() > kFew) {
            std::unordered_set<std::int64_t> seen;
            std::erase_if(corners_, [&](const ObjCorner& corner) { return !seen.insert(corner[0]).second; });
            return;
        }
        std::size_t kept = 0;
        for (const ObjCorner& corner : corners_) {
            const auto end = corners_.begin() + static_cast<std::ptrdiff_t>(kept);
            const auto is_same = [&](const ObjCorner& other) { return other[0] == corner[0]; };
            if (std::none_of(corners_.begin(), end, is_same)) corners_[kept++] = corner;
        }
        corners_.resize(kept);
    }

    void write_face()
    {
        const auto all_have = [&](std::size_t i) {
            return std::ranges::all_of(corners_, [&](const ObjCorner& corner) { return corner[i] != 0; });
        };
        const bool has_uv = all_have(1);
        const bool has_normal = all_have(2);
        result_.text += 'f';
        for (const ObjCorner& corner : corners_) {
            write_index(' ', corner[0]);
            if (has_uv) write_index('/', corner[1]);
            if (has_normal && !has_uv) result_.text += '/';
            if (has_normal) write_index('/', corner[2]);
        }
        result_.text += '\n';
    }

    void write_index(char before, std::int64_t index)
    {
        char digits[24];
        const auto end = std::to_chars(digits, digits + sizeof(digits), index).ptr;
        result_.text += before;
        result_.text.append(digits, end);
    }

    void change_part(MeshPart part)
    {
        now_ = std::move(part);
        is_part_new_ = true;
    }

    /// Faces of one group and material are one part, however often the file comes back to them.
    void begin_run()
    {
        if (!is_part_new_) return;
        is_part_new_ = false;
        const auto [found, is_new] =
            part_ids_.try_emplace({now_.object, now_.group, now_.material}, result_.parts.size());
        if (is_new) result_.parts.push_back(now_);
        if (result_.parts.size() > limits::kMaxObjects)
            place().refuse("there are too many groups", fmt::format("at most {}", limits::kMaxObjects));
        result_.runs.push_back({result_.faces, found->second});
    }

    void add_material_file(std::string_view file)
    {
        std::vector<std::string>& files = result_.material_files;
        if (file.empty() || std::ranges::find(files, file) != files.end()) return;
        if (files.size() >= kMaxMaterialFiles)
            place().refuse("there are too many material files", fmt::format("at most {}", kMaxMaterialFiles));
        files.emplace_back(file);
    }

    struct Largest {
        std::int64_t index = 0;
        std::uint64_t line = 0;
    };
    static constexpr std::size_t kMaxMaterialFiles = 100;

    TextLines lines_;
    const std::string& name_;
    CheckedMesh result_;
    std::string joined_;
    std::array<std::int64_t, 3> counts_{};  ///< Vertices, texture coordinates, normals so far.
    std::array<Largest, 3> largest_{};      ///< Indices may look ahead.
    std::vector<ObjCorner> corners_;
    std::uint64_t triangles_ = 0;
    MeshPart now_;
    bool is_part_new_ = true;
    std::map<std::array<std::string, 3>, std::size_t> part_ids_;
};

}  // namespace

CheckedMesh check_obj(std::string bytes, const std::string& name)
{
    return ObjCheck(bytes, name).run();
}

}  // namespace hw
