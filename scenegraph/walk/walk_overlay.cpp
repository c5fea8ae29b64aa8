#include "hatchway/walk/walk_overlay.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hatchway/walk/controls.hpp"

namespace hw {
namespace {

constexpr float kEdge = 8.0f;
constexpr float kGlyphWidth = 12.0f, kLineHeight = 16.0f;  // of OverlayText
constexpr std::size_t kMostProblems = 4, kMostCameras = 9;
constexpr glm::vec4 kProblemColour(1.0f, 0.75f, 0.7f, 1.0f), kProblemBackground(0.45f, 0.0f, 0.0f, 0.85f);

float height_of(const std::string& text)
{
    return kLineHeight * static_cast<float>(1 + std::count(text.begin(), text.end(), '\n'));
}

/// Stacks blocks of text from the top left corner downwards.
class Column {
 public:
    Column(Overlay& overlay, float width) : overlay_(overlay), columns_((width - 2.0f * kEdge) / kGlyphWidth) {}

    void add(const std::string& text, const OverlayText& look = {})
    {
        OverlayText block = look;
        block.text = wrapped(text, std::max<std::size_t>(columns_, 16));
        block.position_px = {kEdge, top_};
        top_ += height_of(block.text) + 0.5f * kLineHeight;
        overlay_.texts.push_back(std::move(block));
    }

 private:
    Overlay& overlay_;
    std::size_t columns_;
    float top_ = kEdge;
};

std::string help_text(const WalkFacts& facts)
{
    std::string text;
    for (const KeyHelp& line : key_help()) text += fmt::format("{:<16}{}\n", line.keys, line.effect);
    const std::size_t count = std::min(facts.cameras.size(), kMostCameras);
    if (count > 0) text += "\nCameras";
    for (std::size_t i = 0; i < count; ++i) text += fmt::format("  {} {}", i + 1, facts.cameras[i]);
    return text.back() == '\n' ? text.substr(0, text.size() - 1) : text;
}

std::string statistics_text(const FrameStats& stats)
{
    return fmt::format(
        "leaves {} of {}   objects {} of {}   triangles {}   lines {}   draw calls {}\n"
        "ms: visibility {:.1f}   products {:.1f}   images {:.1f}   surfaces {:.1f}   lines {:.1f}   "
        "resolve {:.1f}   all {:.1f}",
        stats.leaves_visible, stats.leaves_total, stats.objects_visible, stats.objects_total, stats.triangles,
        stats.lines, stats.draw_calls, stats.visibility_ms, stats.products_ms, stats.images_ms, stats.surfaces_ms,
        stats.lines_ms, stats.resolve_ms, stats.total_ms);
}

std::string rate_text(double fps)
{
    return fps < 9.95 ? fmt::format("{:.1f} fps", fps) : fmt::format("{:.0f} fps", fps);
}

std::string hint(const WalkFacts& facts)
{
    if (facts.is_playing_path) return "Playing the path; Esc or any move stops it";
    if (facts.is_mouse_captured) return "Esc frees the mouse   F1 help";
    return "The mouse is free: click to look   F1 help   Q quit";
}

std::string object_line(const WalkFacts& facts)
{
    std::string line = facts.object.empty() ? ""
                                            : fmt::format("{}: {}, certainty {:.3g}   Tab changes", facts.object,
                                                          facts.style, facts.certainty);
    if (facts.has_unsaved) line += std::string(line.empty() ? "" : "   ") + "Ctrl+S saves the changes";
    return line;
}

/// Lines at the bottom edge, from the last upwards; a right-hand one shares a line with its left neighbour if both fit.
class BottomLines {
 public:
    BottomLines(Overlay& overlay, float width) : overlay_(overlay), columns_((width - 4.0f * kEdge) / kGlyphWidth) {}

    void add_left(const std::string& text)
    {
        put(text, kEdge);
        used_ = text.size();
    }
    void add_right(const std::string& text)
    {
        if (used_ + text.size() <= columns_) --line_;
        put(text, -kEdge);
        used_ = columns_;
    }

 private:
    void put(const std::string& text, float x)
    {
        OverlayText block;
        block.text = text;
        block.position_px = {x, -kEdge - static_cast<float>(line_++) * (kLineHeight + 4.0f)};
        overlay_.texts.push_back(std::move(block));
    }

    Overlay& overlay_;
    std::size_t columns_;
    std::size_t used_ = 0;
    int line_ = 0;
};

void add_bottom_lines(const WalkFacts& facts, Overlay& overlay)
{
    const std::string gait = facts.is_flying ? "flying" : "walking";
    BottomLines lines(overlay, facts.width);
    lines.add_left(hint(facts));
    lines.add_right(fmt::format("{}   {}, {}", gait, rate_text(facts.fps), facts.quality));
    if (const std::string line = object_line(facts); !line.empty()) lines.add_left(line);
    if (!facts.activity.empty()) lines.add_left(facts.activity);
}

}  // namespace

Overlay walk_overlay(const WalkFacts& facts)
{
    Overlay overlay;
    overlay.has_cross_hair = true;
    Column column(overlay, facts.width);
    for (std::size_t i = 0; i < std::min(facts.problems.size(), kMostProblems); ++i)
        column.add(facts.problems[i], {.colour = kProblemColour, .background = kProblemBackground});
    if (facts.problems.size() > kMostProblems)
        column.add(fmt::format("and {} more", facts.problems.size() - kMostProblems), {.colour = kProblemColour});
    for (const std::string& notice : facts.notices) column.add(notice);
    if (facts.are_statistics_shown) column.add(statistics_text(facts.stats));
    if (facts.is_help_shown) column.add(help_text(facts));

    add_bottom_lines(facts, overlay);
    return overlay;
}

std::string wrapped(const std::string& text, std::size_t columns)
{
    std::string result;
    std::size_t line_start = 0, last_space = std::string::npos;
    for (const char c : text) {
        result += c;
        if (c == ' ') last_space = result.size() - 1;
        if (c == '\n') {
            line_start = result.size();
            last_space = std::string::npos;
        }
        if (result.size() - line_start <= columns) continue;
        if (last_space != std::string::npos && last_space > line_start) {
            result[last_space] = '\n';
            line_start = last_space + 1;
        } else {
            result.insert(result.size() - 1, 1, '\n');
            line_start = result.size() - 1;
        }
        last_space = std::string::npos;
    }
    return result;
}

}  // namespace hw
