// OpenMesh's reader goes wrong, mostly without a word, over lists that are no corners, elements with lists, types that
// it does not convert, comments before the format, a header or body that ends early, numbers that are not finite, and
// lengths that nobody could mean. So each number is looked at, and what is used is copied behind a header of our own.
#include "hatchway/io/meshes/ply_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>

#include "hatchway/io/meshes/ply_header.hpp"

namespace hw {
namespace {

/// A number of the body, as it stands there. NaN where it is not finite.
struct PlyNumber {
    double value = 0.0;
    std::string_view stated;
};

/// The numbers of a body, one after the other.
class PlyBody {
 public:
    PlyBody(std::string_view bytes, PlyEncoding encoding) : rest_(bytes), encoding_(encoding) {}

    PlyNumber next(PlyType type, const FilePlace& place)
    {
        return encoding_ == PlyEncoding::ascii ? next_word_as(type, place) : next_bytes_as(type, place);
    }
    /// Writes a number as a body of this encoding has it: behind a word stands a blank.
    void write(double value, PlyType type, std::string& text) const
    {
        if (encoding_ == PlyEncoding::ascii) {
            fmt::format_to(std::back_inserter(text), "{} ", value);
        } else if (type == PlyType::float32) {
            write_bytes(static_cast<float>(value), text);
        } else if (type == PlyType::float64) {
            write_bytes(value, text);
        }
    }
    void copy(const PlyNumber& number, std::string& text) const
    {
        text += number.stated;
        if (encoding_ == PlyEncoding::ascii) text += ' ';
    }
    std::size_t bytes_left() const { return rest_.size(); }

 private:
    PlyNumber next_word_as(PlyType type, const FilePlace& place)
    {
        const std::string_view word = hw::next_word(rest_);
        if (word.empty()) place.refuse("the file ends early");
        const std::optional<double> value = parse_number(word);
        if (!value || (is_whole(type) && !parse_whole(word)))
            place.refuse(fmt::format("stands \"{}\"", word.substr(0, 40)),
                         is_whole(type) ? "a whole number" : "a number");
        return {*value, word};
    }

    PlyNumber next_bytes_as(PlyType type, const FilePlace& place)
    {
        const std::size_t size = size_of(type);
        if (rest_.size() < size) place.refuse("the file ends early");
        const PlyNumber number{value_of(rest_.substr(0, size), type), rest_.substr(0, size)};
        rest_.remove_prefix(size);
        return number;
    }

    template <typename T>
    T bytes_as(std::string_view bytes) const
    {
        char ordered[sizeof(T)];
        std::memcpy(ordered, bytes.data(), sizeof(T));
        if (encoding_ == PlyEncoding::big_endian) std::reverse(std::begin(ordered), std::end(ordered));
        return std::bit_cast<T>(ordered);
    }

    template <typename T>
    void write_bytes(T value, std::string& text) const
    {
        auto ordered = std::bit_cast<std::array<char, sizeof(T)>>(value);
        if (encoding_ == PlyEncoding::big_endian) std::reverse(ordered.begin(), ordered.end());
        text.append(ordered.data(), ordered.size());
    }

    double value_of(std::string_view bytes, PlyType type) const
    {
        switch (type) {
            case PlyType::int8:
                return bytes_as<std::int8_t>(bytes);
            case PlyType::uint8:
                return bytes_as<std::uint8_t>(bytes);
            case PlyType::int16:
                return bytes_as<std::int16_t>(bytes);
            case PlyType::uint16:
                return bytes_as<std::uint16_t>(bytes);
            case PlyType::int32:
                return bytes_as<std::int32_t>(bytes);
            case PlyType::uint32:
                return bytes_as<std::uint32_t>(bytes);
            case PlyType::float32:
                return bytes_as<float>(bytes);
            case PlyType::float64:
                return bytes_as<double>(bytes);
        }
        return 0.0;
    }

    std::string_view rest_;
    PlyEncoding encoding_;
};

class PlyCheck {
 public:
    PlyCheck(std::string_view bytes, const std::string& name)
        : name_(name), header_(read_ply_header(bytes, name)), body_(bytes.substr(header_.size), header_.encoding)
    {
        result_.is_binary = header_.encoding != PlyEncoding::ascii;
        result_.vertices = header_.vertices();
        result_.text.reserve(bytes.size());
    }

    CheckedMesh run()
    {
        for (PlyElement& element : header_.elements) {
            if (element.name == "vertex" || element.name == "face") check_size(element);
            for (std::uint64_t i = 0; i < element.count; ++i) read_item(element, {name_, element.name.c_str(), i});
            if (element.name == "vertex") {
                result_.has_normals = element.uses(PlyUse::normal);
                result_.has_uv = element.uses(PlyUse::uv);
                result_.has_colours = element.uses(PlyUse::colour);
            } else if (element.name == "face") {
                result_.has_face_colours = element.uses(PlyUse::colour);
                element.count = result_.faces;
            } else {
                result_.lines_and_points += element.count;
            }
        }
        result_.text.insert(0, text_of(header_));
        return std::move(result_);
    }

 private:
    /// Before anything is reserved for its items.
    void check_size(const PlyElement& element) const
    {
        std::uint64_t least = 0;
        for (const PlyProperty& property : element.properties)
            least += result_.is_binary ? size_of(property.count_type.value_or(property.type)) : 2;
        if (element.count * least > body_.bytes_left() + 1)
            FilePlace{name_, element.name.c_str(), 0}.refuse(
                fmt::format("{} of them are announced, {} bytes follow", element.count, body_.bytes_left()));
    }

    void read_item(const PlyElement& element, const FilePlace& place)
    {
        if (element.properties.empty()) place.refuse("the element has no properties");
        corners_.clear();
        others_.clear();
        bool is_face = element.name != "face";
        for (const PlyProperty& property : element.properties) {
            if (property.use == PlyUse::corners)
                is_face = read_corners(property, place);
            else if (property.count_type)
                skip_list(property, place);
            else
                read_number(property, place);
        }
        if (!is_face) {
            ++result_.faces_without_area;
            return;
        }
        if (element.name == "face") ++result_.faces;
        result_.text += corners_;
        result_.text += others_;
        if (!result_.is_binary) result_.text += '\n';
    }

    void skip_list(const PlyProperty& property, const FilePlace& place)
    {
        const double count = body_.next(*property.count_type, place).value;
        for (double i = 0.0; i < count; ++i) body_.next(property.type, place);
    }

    /// Whether they are three at least.
    bool read_corners(const PlyProperty& property, const FilePlace& place)
    {
        const PlyNumber count = body_.next(*property.count_type, place);
        check_corner_count(static_cast<std::int64_t>(count.value), place);
        body_.copy(count, corners_);
        for (double i = 0.0; i < count.value; ++i) {
            const PlyNumber index = body_.next(property.type, place);
            if (!(index.value >= 0.0 && index.value < static_cast<double>(result_.vertices)))
                place.refuse(fmt::format("a corner is the vertex {}", index.value),
                             fmt::format("vertices below {}", result_.vertices));
            body_.copy(index, corners_);
        }
        if (count.value < 3.0) return false;
        triangles_ += static_cast<std::uint64_t>(count.value) - 2;
        check_triangle_count(triangles_, place);
        return true;
    }

    void read_number(const PlyProperty& property, const FilePlace& place)
    {
        const PlyNumber number = body_.next(property.type, place);
        if (property.use == PlyUse::skipped) return;
        if (property.use == PlyUse::coordinate) checked_coordinate(number.value, place);
        double allowed = std::isfinite(number.value) ? number.value : 0.0;
        if (property.use == PlyUse::colour) allowed = std::clamp(allowed, 0.0, is_whole(property.type) ? 255.0 : 1.0);
        if (allowed == number.value)
            body_.copy(number, others_);
        else
            body_.write(allowed, property.type, others_);
    }

    const std::string& name_;
    PlyHeader header_;
    PlyBody body_;
    CheckedMesh result_;
    std::string corners_;  ///< Of the item at hand.
    std::string others_;
    std::uint64_t triangles_ = 0;
};

}  // namespace

CheckedMesh check_ply(std::string bytes, const std::string& name)
{
    return PlyCheck(bytes, name).run();
}

}  // namespace hw
