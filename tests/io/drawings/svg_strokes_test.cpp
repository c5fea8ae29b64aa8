#include "hatchway/io/drawings/svg_strokes.hpp"

#include <gtest/gtest.h>

#include "hatchway/core/error.hpp"

using namespace hw;

namespace {

SvgDrawing parsed(const std::string& body)
{
    return parse_svg_strokes("<?xml version=\"1.0\"?>\n<svg viewBox=\"0 0 200 100\">" + body + "</svg>", "wall.svg");
}

std::string refusal(const std::string& text)
{
    try {
        parse_svg_strokes(text, "wall.svg");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(svg_strokes, coordinates_are_in_units_of_the_drawing_s_width)
{
    const SvgDrawing drawing = parsed("<line x1='100' y1=\"50\" x2='200' y2='100' data-priority='3'/>");
    ASSERT_EQ(drawing.strokes.size(), 1u);
    EXPECT_EQ(drawing.strokes[0].points[0], glm::dvec2(0.5, 0.25));
    EXPECT_EQ(drawing.strokes[0].points[1], glm::dvec2(1.0, 0.5));
    EXPECT_EQ(drawing.strokes[0].priority, 3.0);
    EXPECT_EQ(drawing.height_share, 0.5);
}

TEST(svg_strokes, a_path_may_move_lines_may_be_relative_and_a_z_closes)
{
    const SvgDrawing drawing = parsed("<path d='M0,0 h20v20 H 0 z m100-0 l 10 10,10-10'/>");
    ASSERT_EQ(drawing.strokes.size(), 2u);
    EXPECT_EQ(drawing.strokes[0].points.size(), 5u);
    EXPECT_EQ(drawing.strokes[0].points.back(), drawing.strokes[0].points.front());
    EXPECT_EQ(drawing.strokes[1].points.back(), glm::dvec2(0.6, 0.0));
}

TEST(svg_strokes, curves_pass_through_the_point_that_their_formula_gives)
{
    const SvgDrawing drawing = parsed("<path d='M0 0 C 0 100 200 100 200 0 S 400 -100 400 0 Q 500 0 500 100'/>");
    const auto& points = drawing.strokes[0].points;
    EXPECT_EQ(points.size(), 49u);
    EXPECT_NEAR(points[8].x, 0.5, 1e-12);
    EXPECT_NEAR(points[8].y, 0.375, 1e-12);
    EXPECT_LT(points[24].y, 0.0);
}

TEST(svg_strokes, widths_are_relative_to_the_first_stroke)
{
    const SvgDrawing drawing =
        parsed("<polyline points='0,0 10,10' stroke-width='2'/><polygon points='0 0 9 0 9 9' stroke-width='3'/>");
    EXPECT_EQ(drawing.strokes[0].width, 1.0);
    EXPECT_EQ(drawing.strokes[1].width, 1.5);
    EXPECT_EQ(drawing.strokes[1].points.size(), 4u);
}

TEST(svg_strokes, what_is_no_stroke_is_passed_over)
{
    EXPECT_EQ(parsed("<!-- <line x1='1'/> --><rect width='9'/><g><line x2='5'/></g><text>&gt;</text>").strokes.size(),
              1u);
}

TEST(svg_strokes, wrong_drawings_are_refused_with_the_reason)
{
    EXPECT_NE(refusal("hello").find("is no drawing"), std::string::npos);
    EXPECT_NE(refusal("<svg><line/></svg>").find("no size"), std::string::npos);
    EXPECT_NE(refusal("<svg viewBox='0 0 1 1'></svg>").find("no strokes"), std::string::npos);
    EXPECT_NE(refusal("<svg viewBox='0 0 1 1'><path d='M0 0 A 1 1'/></svg>").find("'A'"), std::string::npos);
    EXPECT_NE(refusal("<svg viewBox='0 0 1 1'><path d='M0 zero'/></svg>").find("is no number"), std::string::npos);
    EXPECT_NE(refusal("<svg viewBox='0 0 1 1'><path d='L'/></svg>").find("a number should follow"), std::string::npos);
    EXPECT_NE(refusal("<svg viewBox='0 0 1e99 1'>").find("is no number"), std::string::npos);
}

TEST(svg_strokes, more_ink_than_paper_holds_is_refused)
{
    const std::string begin = "<svg viewBox='0 0 100 100'>";
    std::string lines;
    for (int i = 0; i < 4100; ++i) lines += "<line x2='100'/>";
    EXPECT_NE(refusal(begin + lines + "</svg>").find("too much ink"), std::string::npos);
    EXPECT_NE(refusal(begin + "<path d='M0 0 C1e7 -1e7 -1e7 1e7 100 100'/></svg>").find("too much ink"),
              std::string::npos);
    std::string points;
    for (int i = 0; i < 200100; ++i) points += i % 2 ? "0 0 " : "0.1 0 ";
    EXPECT_NE(refusal(begin + "<polyline points='" + points + "'/></svg>").find("too much ink"), std::string::npos);
}
