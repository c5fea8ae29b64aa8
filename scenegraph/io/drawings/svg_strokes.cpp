#include "hatchway/io/drawings/svg_strokes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <optional>
#include <set>
#include <string_view>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/log.hpp"

namespace hw {
namespace {

constexpr std::uint64_t kMaxBytes = 4ull << 20;
constexpr std::size_t kMaxStrokes = 100'000;
constexpr std::size_t kMaxPoints = 200'000;
constexpr double kMaxLength = 4000.0;  // widths of the drawing: more ink than its paper holds
constexpr double kFarthest = 1e5;      // widths of the drawing, from its corner
constexpr double kMostHigh = 256.0;    // widths of the drawing; as wide at most
constexpr int kCurvePieces = 16;

/// Numbers of a list such as "M 10,20 l-3.5 4": separators are spaces and commas, a sign starts a number.
class NumberText {
 public:
    NumberText(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    void skip_separators()
    {
        while (!text_.empty() && (std::isspace(static_cast<unsigned char>(text_[0])) || text_[0] == ','))
            text_.remove_prefix(1);
    }
    bool is_at_end()
    {
        skip_separators();
        return text_.empty();
    }
    bool is_at_letter()
    {
        skip_separators();
        return !text_.empty() && std::isalpha(static_cast<unsigned char>(text_[0]));
    }
    char letter()
    {
        const char c = text_[0];
        text_.remove_prefix(1);
        return c;
    }
    double number()
    {
        skip_separators();
        if (!text_.empty() && text_[0] == '+') text_.remove_prefix(1);
        double value = 0.0;
        const auto [end, status] = std::from_chars(text_.data(), text_.data() + text_.size(), value);
        if (status != std::errc() || !std::isfinite(value) || std::abs(value) > 1e9)
            throw Error({.what = text_.empty() ? "coordinates end where a number should follow"
                                               : "\"" + std::string(text_.substr(0, 16)) + "\" is no number",
                         .file = file_,
                         .expected = "numbers up to 1e9"});
        text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
        return value;
    }
    glm::dvec2 point(const glm::dvec2& origin)
    {
        const double x = number();
        return origin + glm::dvec2(x, number());
    }

 private:
    std::string_view text_;
    const std::string& file_;
};

std::optional<std::string_view> attribute(std::string_view tag, std::string_view name)
{
    for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
        const std::size_t after = at + name.size();
        const bool is_name = at > 0 && std::isspace(static_cast<unsigned char>(tag[at - 1])) &&
                             after + 1 < tag.size() && tag[after] == '=' &&
                             (tag[after + 1] == '"' || tag[after + 1] == '\'');
        if (!is_name) continue;
        const std::size_t end = tag.find(tag[after + 1], after + 2);
        if (end != std::string_view::npos) return tag.substr(after + 2, end - after - 2);
    }
    return std::nullopt;
}

double number_of(std::string_view tag, std::string_view name, double otherwise, const std::string& file)
{
    const auto text = attribute(tag, name);
    return text ? NumberText(*text, file).number() : otherwise;
}

[[noreturn]] void refuse_ink(const std::string& file)
{
    throw Error({.what = "the drawing has too much ink",
                 .file = file,
                 .expected = fmt::format("at most {} points and strokes {:.0f} times as long as it is wide", kMaxPoints,
                                         kMaxLength)});
}

/// Follows the commands of a path's "d" and gives its strokes, one for each move.
class PathReader {
 public:
    PathReader(std::string_view d, const std::string& file) : text_(d, file), file_(file) {}

    std::vector<std::vector<glm::dvec2>> strokes()
    {
        char command = 'M';
        while (!text_.is_at_end()) {
            if (text_.is_at_letter())
                command = text_.letter();
            else if (command == 'Z' || command == 'z')
                throw Error({.what = "a number follows the Z of a path", .file = file_, .expected = "a command"});
            follow(command);
            if (command == 'M') command = 'L';
            if (command == 'm') command = 'l';
        }
        return std::move(strokes_);
    }

 private:
    void follow(char command)
    {
        const char kind = static_cast<char>(std::toupper(command));
        const glm::dvec2 origin = command == kind ? glm::dvec2(0.0) : at_;
        glm::dvec2 handle = at_;
        switch (kind) {
            case 'M':
                at_ = start_ = text_.point(origin);
                strokes_.push_back({at_});
                count_point();
                break;
            case 'L':
                line_to(text_.point(origin));
                break;
            case 'H':
                line_to({origin.x + text_.number(), at_.y});
                break;
            case 'V':
                line_to({at_.x, origin.y + text_.number()});
                break;
            case 'Z':
                line_to(start_);
                break;
            case 'C': {
                const glm::dvec2 first = text_.point(origin);
                handle = text_.point(origin);
                curve_to(first, handle, text_.point(origin));
                break;
            }
            case 'S': {
                const glm::dvec2 first = 2.0 * at_ - handle_;
                handle = text_.point(origin);
                curve_to(first, handle, text_.point(origin));
                break;
            }
            case 'Q': {
                const glm::dvec2 control = text_.point(origin);
                const glm::dvec2 end = text_.point(origin);
                handle = end + 2.0 / 3.0 * (control - end);
                curve_to(at_ + 2.0 / 3.0 * (control - at_), handle, end);
                break;
            }
            default:
                throw Error({.what = std::string("the path has the command '") + command + "'",
                             .file = file_,
                             .expected = "one of M L H V C S Q Z, in upper or lower case"});
        }
        const bool is_curve = kind == 'C' || kind == 'S' || kind == 'Q';
        handle_ = is_curve ? handle : at_;
    }

    void line_to(const glm::dvec2& to)
    {
        if (strokes_.empty()) strokes_.push_back({at_});
        strokes_.back().push_back(to);
        at_ = to;
        count_point();
    }

    void count_point()
    {
        if (++point_count_ > kMaxPoints) refuse_ink(file_);
    }

    void curve_to(const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d)
    {
        const glm::dvec2 a = at_;
        for (int i = 1; i <= kCurvePieces; ++i) {
            const double t = static_cast<double>(i) / kCurvePieces;
            const double u = 1.0 - t;
            line_to(u * u * u * a + 3.0 * u * u * t * b + 3.0 * u * t * t * c + t * t * t * d);
        }
    }

    NumberText text_;
    const std::string& file_;
    std::vector<std::vector<glm::dvec2>> strokes_;
    std::size_t point_count_ = 0;
    glm::dvec2 at_{0.0}, start_{0.0}, handle_{0.0};
};

std::vector<std::vector<glm::dvec2>> strokes_of(std::string_view name, std::string_view tag, const std::string& file)
{
    if (name == "path") return PathReader(attribute(tag, "d").value_or(""), file).strokes();
    if (name == "line")
        return {{{number_of(tag, "x1", 0.0, file), number_of(tag, "y1", 0.0, file)},
                 {number_of(tag, "x2", 0.0, file), number_of(tag, "y2", 0.0, file)}}};
    if (name != "polyline" && name != "polygon") return {};
    std::vector<glm::dvec2> points;
    for (NumberText text(attribute(tag, "points").value_or(""), file); !text.is_at_end();)
        points.push_back(text.point(glm::dvec2(0.0)));
    if (name == "polygon" && !points.empty()) points.push_back(points.front());
    return {points};
}

struct Frame {
    glm::dvec2 origin{0.0};
    glm::dvec2 size{0.0};
};

Frame frame_of(std::string_view tag, const std::string& file)
{
    Frame frame;
    if (const auto box = attribute(tag, "viewBox")) {
        NumberText text(*box, file);
        frame.origin = text.point(glm::dvec2(0.0));
        frame.size = text.point(glm::dvec2(0.0));
    } else {
        frame.size = {number_of(tag, "width", 0.0, file), number_of(tag, "height", 0.0, file)};
    }
    if (!(frame.size.x > 0.0 && frame.size.y > 0.0))
        throw Error({.what = "the drawing has no size", .file = file, .expected = "a viewBox, or width and height"});
    const double height = frame.size.y / frame.size.x;
    if (!(height <= kMostHigh && height >= 1.0 / kMostHigh))
        throw Error({.what = fmt::format("the drawing is {:g} times as high as wide", height),
                     .file = file,
                     .expected = fmt::format("from 1/{0:g} to {0:g}", kMostHigh)});
    return frame;
}

/// How much was drawn so far. A drawing from a stranger must not be drawn for hours.
struct DrawnInk {
    double length = 0.0;
    std::size_t points = 0;

    void add(const std::vector<glm::dvec2>& stroke, const std::string& file)
    {
        points += stroke.size();
        for (std::size_t i = 1; i < stroke.size(); ++i) length += glm::distance(stroke[i - 1], stroke[i]);
        if (points > kMaxPoints || !(length <= kMaxLength)) refuse_ink(file);
    }
};

/// Says which shapes and attributes of the drawing are passed over, each once.
class PassedOver {
 public:
    void note(std::string_view name, std::string_view tag)
    {
        static constexpr std::string_view kShapes[]{"rect", "circle", "ellipse", "use", "text", "image"};
        if (std::find(std::begin(kShapes), std::end(kShapes), name) != std::end(kShapes))
            names_.insert(fmt::format("<{}>", name));
        if (attribute(tag, "transform")) names_.insert("transform");
    }
    void warn(const std::string& file) const
    {
        if (!names_.empty())
            log_warning(fmt::format("{}: {} passed over: only paths, lines and polygons as they stand are strokes",
                                    file, fmt::join(names_, ", ")));
    }

 private:
    std::set<std::string> names_;
};

void require_near(const std::vector<glm::dvec2>& points, const std::string& file)
{
    for (const glm::dvec2& point : points)
        if (!(std::abs(point.x) <= kFarthest && std::abs(point.y) <= kFarthest))
            throw Error({.what = "a stroke leaves the drawing too far",
                         .file = file,
                         .expected = fmt::format("within {:g} times its width", kFarthest)});
}

void add_strokes(SvgDrawing& drawing, DrawnInk& ink, std::string_view name, std::string_view tag, const Frame& frame,
                 double& pen, const std::string& file)
{
    std::vector<std::vector<glm::dvec2>> strokes = strokes_of(name, tag, file);
    if (strokes.empty()) return;
    const double width = number_of(tag, "stroke-width", 1.0, file);
    const bool has_priority = attribute(tag, "data-priority").has_value();
    const double priority = number_of(tag, "data-priority", 0.0, file);
    for (std::vector<glm::dvec2>& points : strokes) {
        if (points.empty()) continue;
        if (drawing.strokes.size() == kMaxStrokes)
            throw Error({.what = "the drawing has too many strokes",
                         .file = file,
                         .expected = "at most " + std::to_string(kMaxStrokes)});
        for (glm::dvec2& point : points) point = (point - frame.origin) / frame.size.x;
        require_near(points, file);
        ink.add(points, file);
        if (pen <= 0.0) pen = width > 0.0 ? width : 1.0;
        drawing.strokes.push_back({.points = std::move(points),
                                   .width = std::clamp(width / pen, 0.1, 10.0),
                                   .priority = priority,
                                   .has_priority = has_priority});
    }
}

}  // namespace

SvgDrawing parse_svg_strokes(const std::string& text, const std::string& file)
{
    SvgDrawing drawing;
    Frame frame;
    DrawnInk ink;
    PassedOver passed_over;
    double pen = 0.0;
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
        if (text.compare(at, 4, "<!--") == 0) {
            at = std::min(text.find("-->", at), text.size() - 1);
            continue;
        }
        const std::size_t end = text.find('>', at);
        if (end == std::string::npos) break;
        const std::string_view tag(text.data() + at, end - at);
        const std::string_view name = tag.substr(1, std::min(tag.find_first_of(" \t\r\n/", 1), tag.size()) - 1);
        if (name == "svg") frame = frame_of(tag, file);
        passed_over.note(name, tag);
        if (frame.size.x > 0.0) add_strokes(drawing, ink, name, tag, frame, pen, file);
        at = end;
    }
    if (frame.size.x <= 0.0)
        throw Error({.what = "the file is no drawing", .file = file, .expected = "an SVG, PNG or JPEG file"});
    if (drawing.strokes.empty())
        throw Error(
            {.what = "the drawing has no strokes", .file = file, .expected = "path, line, polyline or polygon"});
    passed_over.warn(file);
    drawing.height_share = frame.size.y / frame.size.x;
    return drawing;
}

SvgDrawing read_svg_strokes(const std::filesystem::path& file)
{
    return parse_svg_strokes(read_text_file(file, kMaxBytes), file.string());
}

}  // namespace hw
