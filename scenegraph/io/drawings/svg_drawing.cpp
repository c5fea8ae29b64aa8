#include "hatchway/io/drawings/svg_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hatchway/core/files/files.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/core/unique_names.hpp"

namespace hw {
namespace {

/// Control characters are written out: XML allows none of most, and no reader of names should obey any.
std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : plain_text(text)) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else
            result += c;
    }
    return result;
}

std::string colour_text(const glm::vec3& srgb)
{
    const auto part = [](float x) { return static_cast<int>(std::lround(255.0f * std::clamp(x, 0.0f, 1.0f))); };
    return fmt::format("#{:02x}{:02x}{:02x}", part(srgb.r), part(srgb.g), part(srgb.b));
}

/// At most two decimals, none that say nothing.
std::string number_text(double value)
{
    std::string text = fmt::format("{:.2f}", value);
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

/// Names of objects as classes: each object gets one of its own.
class ClassNames {
 public:
    std::string of(const std::string& name)
    {
        // A class begins with no digit.
        std::string plain = name.empty() || (name[0] >= '0' && name[0] <= '9') ? "_" : "";
        for (const char c : name) {
            const bool is_word = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
            plain += is_word ? c : '_';
        }
        return names_.take(plain);
    }

 private:
    UniqueNames names_{{"object", "hidden", "silhouette", "ridge", "valley", "border", "artist", "intersection"}};
};

std::string path_text(const std::vector<glm::dvec2>& points, bool is_closed)
{
    std::string path;
    for (std::size_t i = 0; i < points.size(); ++i) {
        path += i == 0 ? "M" : i == 1 ? "L" : " ";
        path += number_text(points[i].x) + "," + number_text(points[i].y);
    }
    return is_closed ? path + "Z" : path;
}

void append_group(std::string& text, const VectorGroup& group, const std::string& object_class)
{
    struct Stroke {
        std::vector<glm::dvec2> points;
        const VectorLine* line;
    };
    std::vector<Stroke> strokes;
    for (const VectorLine& line : group.lines) {
        std::vector<glm::dvec2> points = rounded_points(line);
        if (points.size() > 1) strokes.push_back({std::move(points), &line});
    }
    if (strokes.empty()) return;
    std::stable_sort(strokes.begin(), strokes.end(), [](const Stroke& a, const Stroke& b) {
        return std::lexicographical_compare(
            a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
            [](const auto& p, const auto& q) { return p.y != q.y ? p.y < q.y : p.x < q.x; });
    });
    const std::string kind = group.line_type + (group.is_hidden ? " hidden" : "");
    text += fmt::format(
        "    <g class=\"{} {}\" inkscape:groupmode=\"layer\" inkscape:label=\"{}\" stroke=\"{}\" "
        "stroke-width=\"{}\"",
        object_class, kind, kind, colour_text(group.colour_srgb), number_text(group.width_px));
    if (group.opacity < 0.995) text += fmt::format(" stroke-opacity=\"{}\"", number_text(group.opacity));
    if (group.is_hidden)
        text += fmt::format(" stroke-dasharray=\"{} {}\"", number_text(3.0 * group.width_px),
                            number_text(3.0 * group.width_px));
    text += ">\n";
    for (const Stroke& stroke : strokes) {
        text += "      <path d=\"" + path_text(stroke.points, stroke.line->is_closed) + "\"";
        const std::string width = number_text(stroke.line->width_px);
        if (width != number_text(group.width_px)) text += " stroke-width=\"" + width + "\"";
        text += "/>\n";
    }
    text += "    </g>\n";
}

}  // namespace

std::string svg_text(const VectorDrawing& drawing)
{
    std::string text = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" "
        "width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" fill=\"none\" stroke-linecap=\"round\" "
        "stroke-linejoin=\"round\">\n",
        drawing.size_px.x, drawing.size_px.y);
    if (!drawing.title.empty()) text += "  <title>" + escaped(drawing.title) + "</title>\n";
    text += fmt::format("  <rect class=\"paper\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", drawing.size_px.x,
                        drawing.size_px.y, colour_text(drawing.paper_srgb));
    ClassNames names;
    for (const VectorObject& object : drawing.objects) {
        const std::string object_class = names.of(object.name);
        std::string groups;
        for (const VectorGroup& group : object.groups) append_group(groups, group, object_class);
        if (groups.empty()) continue;
        text += fmt::format("  <g class=\"object {}\" inkscape:groupmode=\"layer\" inkscape:label=\"{}\">\n",
                            object_class, escaped(object.name));
        text += groups + "  </g>\n";
    }
    return text + "</svg>\n";
}

void write_svg(const std::filesystem::path& file, const VectorDrawing& drawing)
{
    write_file_atomically(file, svg_text(drawing));
}

}  // namespace hw
