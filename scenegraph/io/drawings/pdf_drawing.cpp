#include "hatchway/io/drawings/pdf_drawing.hpp"

#include <cairo-pdf.h>

#include <memory>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"

namespace hw {
namespace {

constexpr double kPointsPerPixel = 72.0 / 96.0;
constexpr const char* kDate = "2001-01-01T00:00:00Z";  // the same drawing has the same bytes on any day

struct CairoFree {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
};

cairo_status_t append_bytes(void* into, const unsigned char* bytes, unsigned int count)
{
    static_cast<std::string*>(into)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
}

void draw_line(cairo_t* cairo, const VectorLine& line)
{
    const std::vector<glm::dvec2> points = rounded_points(line);
    if (points.size() < 2) return;
    cairo_set_line_width(cairo, line.width_px);
    cairo_move_to(cairo, points[0].x, points[0].y);
    for (std::size_t i = 1; i < points.size(); ++i) cairo_line_to(cairo, points[i].x, points[i].y);
    if (line.is_closed) cairo_close_path(cairo);
    cairo_stroke(cairo);
}

void draw_group(cairo_t* cairo, const VectorGroup& group)
{
    const glm::dvec3 colour(group.colour_srgb);
    cairo_set_source_rgba(cairo, colour.r, colour.g, colour.b, group.opacity);
    const double dash = 3.0 * group.width_px;
    cairo_set_dash(cairo, &dash, group.is_hidden ? 1 : 0, 0.0);
    for (const VectorLine& line : group.lines) draw_line(cairo, line);
}

void draw(cairo_t* cairo, const VectorDrawing& drawing)
{
    const glm::dvec3 paper(drawing.paper_srgb);
    cairo_scale(cairo, kPointsPerPixel, kPointsPerPixel);
    cairo_set_source_rgb(cairo, paper.r, paper.g, paper.b);
    cairo_paint(cairo);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    for (const VectorObject& object : drawing.objects)
        for (const VectorGroup& group : object.groups) draw_group(cairo, group);
    cairo_show_page(cairo);
}

}  // namespace

void write_pdf(const std::filesystem::path& file, const VectorDrawing& drawing)
{
    std::string bytes;
    const glm::dvec2 size = kPointsPerPixel * glm::dvec2(drawing.size_px);
    const std::unique_ptr<cairo_surface_t, CairoFree> surface(
        cairo_pdf_surface_create_for_stream(append_bytes, &bytes, size.x, size.y));
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, drawing.title.c_str());
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, kDate);
    const std::unique_ptr<cairo_t, CairoFree> cairo(cairo_create(surface.get()));
    draw(cairo.get(), drawing);
    cairo_surface_finish(surface.get());
    const cairo_status_t status = cairo_surface_status(surface.get());
    if (status != CAIRO_STATUS_SUCCESS)
        throw Error({.what = std::string("the PDF cannot be drawn: ") + cairo_status_to_string(status),
                     .file = file.string(),
                     .fault = Fault::ours});
    write_file_atomically(file, bytes);
}

}  // namespace hw
