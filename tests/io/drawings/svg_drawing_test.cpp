#include "hatchway/io/drawings/svg_drawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "hatchway/core/files/files.hpp"
#include "hatchway/io/drawings/pdf_drawing.hpp"
#include "tests/temporary_folder.hpp"

namespace {

hw::VectorDrawing drawing()
{
    const hw::VectorLine across{{{0.0, 10.0}, {100.0, 10.0}}, false, 1.2};
    const hw::VectorLine ring{{{10.0, 1.0}, {20.0, 1.0}, {15.123, 9.0}}, true, 1.2};
    const hw::VectorLine dot{{{5.0, 5.0}, {5.001, 5.0}}, false, 1.2};
    hw::VectorGroup ridges{.line_type = "ridge", .width_px = 1.2, .lines = {across, ring, dot}};
    hw::VectorGroup hidden{.line_type = "border", .is_hidden = true, .width_px = 1.0, .lines = {across}};
    return {.size_px = {100, 50},
            .title = "a & b",
            .objects = {{"Hall/<Arch>", {hidden, ridges}}, {"Hall/<Arch>", {ridges}}}};
}

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

}  // namespace

TEST(vector_drawing, svg_has_a_group_for_each_line_type_inside_one_for_each_object)
{
    const std::string svg = hw::svg_text(drawing());
    EXPECT_EQ(count(svg, "<g class=\"object Hall__Arch_\""), 1u);
    EXPECT_EQ(count(svg, "<g class=\"object Hall__Arch__2\""), 1u);  // objects of one name are told apart
    EXPECT_EQ(count(svg, "<g class=\"Hall__Arch_ ridge\""), 1u);
    EXPECT_EQ(count(svg, "<g class=\"Hall__Arch_ border hidden\""), 1u);
    EXPECT_EQ(count(svg, "stroke-dasharray"), 1u);
    EXPECT_EQ(count(svg, "<title>a &amp; b</title>"), 1u);
    EXPECT_EQ(count(svg, "inkscape:label=\"Hall/&lt;Arch&gt;\""), 2u);
}

TEST(vector_drawing, svg_writes_control_characters_of_names_out)
{
    hw::VectorDrawing named = drawing();
    named.objects[0].name = "a\u009b\x7f\u202e\u2028\x1b\n<b";
    const std::string svg = hw::svg_text(named);
    EXPECT_EQ(count(svg, "inkscape:label=\"a\\x9b\\x7f\\u202e\\u2028\\x1b\\n&lt;b\""), 1u);
    for (const char* raw : {"\u009b", "\x7f", "\u202e", "\u2028", "\x1b"}) EXPECT_EQ(count(svg, raw), 0u);
}

TEST(vector_drawing, svg_coordinates_have_two_decimals_and_what_has_no_length_is_left_out)
{
    const std::string svg = hw::svg_text(drawing());
    EXPECT_EQ(count(svg, "M10,1L20,1 15.12,9Z"), 2u);
    EXPECT_EQ(count(svg, "M5,5"), 0u);
}

TEST(vector_drawing, svg_does_not_depend_on_the_order_in_which_lines_were_found)
{
    hw::VectorDrawing turned = drawing();
    for (hw::VectorObject& object : turned.objects)
        for (hw::VectorGroup& group : object.groups) std::reverse(group.lines.begin(), group.lines.end());
    EXPECT_EQ(hw::svg_text(turned), hw::svg_text(drawing()));
}

TEST(vector_drawing, pdf_is_a_page_of_the_drawings_size)
{
    const TemporaryFolder folder;
    hw::write_pdf(folder.path() / "drawing.pdf", drawing());
    const std::string pdf = hw::read_text_file(folder.path() / "drawing.pdf", 1 << 20);
    EXPECT_EQ(pdf.rfind("%PDF-1.", 0), 0u);
    EXPECT_NE(pdf.find("/MediaBox [ 0 0 75 37.5 ]"), std::string::npos);
}

TEST(vector_drawing, pdf_is_the_same_bytes_on_any_day)
{
    const TemporaryFolder folder;
    hw::write_pdf(folder.path() / "one.pdf", drawing());
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    hw::write_pdf(folder.path() / "two.pdf", drawing());
    EXPECT_EQ(hw::read_text_file(folder.path() / "one.pdf", 1 << 20),
              hw::read_text_file(folder.path() / "two.pdf", 1 << 20));
}
