// Edge map: an image of the visible edges, from discontinuities of normals and depth.
// Sources: Nienhaus, Doellner. Edge-Enhancement. Journal of WSCG 11, 2003, section 4.1.2, for `diagonal` and `c1`;
// README.md for `second`.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "hatchway/style/style.hpp"

namespace {

enum class Operator { second, diagonal, c1, c1_three_passes };
constexpr std::array<std::string_view, 4> kOperators{"second", "diagonal", "c1", "c1_three_passes"};
enum class Format { rgba32f, rgba16f, rgba8 };
constexpr std::array<std::string_view, 3> kFormats{"rgba32f", "rgba16f", "rgba8"};
enum class Normal { face, geometric, shading };
constexpr std::array<std::string_view, 3> kNormals{"face", "geometric", "shading"};

class EdgeMap final : public hw::ImagePass {
 public:
    void visit_params(hw::ParamVisitor& visitor) override
    {
        using enum hw::ParamChange;
        visitor.choice({"operator",
                        "What finds edges: second differences of 1 / depth, or of the paper of 2003 the diagonal "
                        "neighbours, or all eight in one pass or in three.",
                        rebuild},
                       operator_, kOperators);
        visitor.choice({"format", "Of the image of normals and depths.", rebuild}, format_, kFormats);
        visitor.choice(
            {"normal", "Which normals are compared: of triangles, interpolated, or with normal maps.", rebuild},
            normal_, kNormals);
        visitor.real({"width_px", "Of profile edges, on the nearer side.", rebuild}, width_px_, 1.0f, 8.0f);
        visitor.real({"inner_width_px", "Of inner edges, half on each side.", rebuild}, inner_width_px_, 1.0f, 8.0f);
        visitor.real({"halo_px", "How far profile edges reach beyond their object.", rebuild}, halo_px_, 0.0f, 8.0f);
        visitor.angle(
            {"crease_deg", "Of second: folds by this are half an edge, by 4 % less none, by 4 % more a whole one."},
            crease_rad_, 1.0f, 180.0f);
        visitor.real({"gap", "Of second: steps in depth of this share of the distance are whole edges, of half some."},
                     gap_, 1e-5f, 1.0f);
        visitor.whole({"radius_px", "Of the others: distance of the compared pixels."}, radius_px_, 1, 8);
    }

    hw::Needs needs() const override { return {.images = {source()}}; }

    void prepare(hw::ProgramCache& programs) override
    {
        static constexpr std::array kFiles{"second_difference.frag", "diagonal.frag", "c1.frag", "c1.frag"};
        const char* file = kFiles[static_cast<std::size_t>(operator_)];
        std::string defines = format_ == Format::rgba8 ? "#define NORMAL_DEPTH_BYTES 1\n" : "";
        if (operator_ == Operator::c1_three_passes) {
            part_ = programs.full_screen("c1_part.frag", defines);
            defines += "#define IN_THREE_PASSES 1\n";
        }
        find_ = programs.full_screen(file, defines);
        find_wide_ = programs.full_screen(file, defines + "#define TO_BE_WIDENED 1\n");
        along_rows_ = programs.full_screen("widen.frag", "#define ALONG_ROWS 1\n");
        along_columns_ = programs.full_screen("widen.frag");
    }

    hw::Images make(hw::Pass& pass, hw::Items) override
    {
        const float px_scale = pass.view().px_scale;
        if (!is_widened(px_scale)) return found(pass, find_, {of(hw::PixelFormat::rg8, 1.0f)});
        const hw::TargetOutput bytes = of(hw::PixelFormat::rgba8, 0.0f), two_bytes = of(hw::PixelFormat::rg8, 0.5f);
        const hw::Images edges = found(pass, find_wide_, {bytes, two_bytes});
        const hw::Images rows =
            pass.filter({.outputs = {bytes, bytes}}, along_rows_, widening(edges[0], edges[0], edges[1], px_scale));
        return pass.filter({.outputs = {of(hw::PixelFormat::rg8, 1.0f), two_bytes}}, along_columns_,
                           widening(rows[0], rows[1], edges[1], px_scale));
    }

 private:
    static hw::TargetOutput of(hw::PixelFormat format, float clear)
    {
        return {.format = format, .filter = hw::PixelFilter::nearest, .clear = glm::vec4(clear)};
    }
    bool is_second() const { return operator_ == Operator::second; }

    /// One pass finds edges one pixel wide; those of the paper are as wide as what they compare.
    bool is_widened(float px_scale) const
    {
        const float found_px = is_second() ? 1.0f / px_scale : 2.0f * static_cast<float>(radius_px_);
        return std::max(width_px_, inner_width_px_) > found_px || halo_px_ > 0.0f;
    }

    hw::ImageKey source() const
    {
        return {"normal_depth",
                {{"format", std::string(kFormats[static_cast<std::size_t>(format_)])},
                 {"normal", std::string(kNormals[static_cast<std::size_t>(normal_)])}}};
    }

    hw::Images found(hw::Pass& pass, hw::Program find, const std::vector<hw::TargetOutput>& outputs) const
    {
        const hw::DepthRange range = pass.depth_range(source());
        const hw::Uniforms uniforms = hw::Uniforms(of_operator(pass.view().px_scale))
                                          .set("normal_depth", pass.image(source()))
                                          .set("depth_range_m", glm::vec2(range.near_m, range.far_m))
                                          .set("reach_px", reach_px(pass.view().px_scale));
        if (operator_ != Operator::c1_three_passes) return pass.filter({.outputs = outputs}, find, uniforms);
        hw::Image sum;
        for (int part = 0; part < 2; ++part)
            sum = pass.filter({.outputs = {of(hw::PixelFormat::rg8, 0.0f)}}, part_,
                              hw::Uniforms(uniforms).set("part", part).set("sum_before", sum))[0];
        return pass.filter({.outputs = outputs}, find, hw::Uniforms(uniforms).set("sum_before", sum));
    }

    hw::Uniforms of_operator(float px_scale) const
    {
        if (!is_second())
            return hw::Uniforms().set("radius_px", std::max(1, static_cast<int>(px_scale * radius_px_ + 0.5f)));
        const glm::vec2 cosines(std::cos(std::min(1.04f * crease_rad_, 3.14159f)), std::cos(0.96f * crease_rad_));
        return hw::Uniforms().set("crease_cosines", cosines).set("gap", gap_);
    }

    /// Coverage reaches so far from the middle of inner edges, and from profile edges to the nearer side and beyond.
    glm::vec3 reach_px(float px_scale) const
    {
        glm::vec3 reach(0.5f * inner_width_px_, width_px_, halo_px_);
        // The paper's operators mark both sides of an edge, a pixel at least: half of the width lies on each.
        if (!is_second())
            reach = glm::max(0.5f * glm::vec3(inner_width_px_, width_px_, 0.0f), glm::vec3(1.0f, 1.0f, 0.0f));
        return px_scale * reach;
    }

    hw::Uniforms widening(hw::Image inner, hw::Image profile, hw::Image steps, float px_scale) const
    {
        return hw::Uniforms()
            .set("inner_edges", inner)
            .set("profile_edges", profile)
            .set("steps", steps)
            .set("reach_px", reach_px(px_scale));
    }

    Operator operator_ = Operator::second;
    Format format_ = Format::rgba32f;
    Normal normal_ = Normal::face;
    float width_px_ = 1.0f, inner_width_px_ = 1.0f, halo_px_ = 0.0f;
    float crease_rad_ = glm::radians(40.0f), gap_ = 0.01f;
    int radius_px_ = 1;
    hw::Program find_, find_wide_, part_, along_rows_, along_columns_;
};

}  // namespace

HW_IMAGE_PASS(edge_map, "R: 1 - inner edge, G: 1 - profile edge; 1 is no edge", EdgeMap)
