// Edge map: an image of the visible edges, from discontinuities of normals and depth.
// Sources: Nienhaus, Doellner. Edge-Enhancement. Journal of WSCG 11, 2003, section 4.1.2, for `diagonal` and `c1`;
// Diktas, Sahiner. ID-Based Rendering of Silhouettes on GPU. 2011, for `ids_2011`; README.md for `second` and `ids`.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "hatchway/style/style.hpp"

namespace {

enum class Operator { second, diagonal, c1, c1_three_passes, ids, ids_2011 };
constexpr std::array<std::string_view, 6> kOperators{"second", "diagonal", "c1", "c1_three_passes", "ids", "ids_2011"};
enum class Storage { vertices, lists };
constexpr std::array<std::string_view, 2> kStorages{"vertices", "lists"};
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
                        "What finds edges: second differences of 1 / depth; of the paper of 2003 the diagonal "
                        "neighbours, or all eight in one pass or in three; numbers of triangles and their planes, or "
                        "of the paper of 2011 numbers alone.",
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
        visitor.real({"gap",
                      "Of second: steps in depth of this share of the distance are whole edges, of half some. Of ids, "
                      "between triangles lower than small_px: larger ones are edges."},
                     gap_, 1e-5f, 1.0f);
        visitor.whole({"radius_px", "Of those of 2003: distance of the compared pixels."}, radius_px_, 1, 8);
        visitor.whole({"passes", "Of c1_three_passes: after how many it stops, to look at what they add up to."},
                      passes_, 1, 3);
        visitor.choice(
            {"storage", "Of ids: whether corners of triangles are compared, or lists of neighbours read.", rebuild},
            storage_, kStorages);
        visitor.real({"small_px",
                      "Of ids: triangles of one object that are lower than this may lie close together without a "
                      "common corner."},
                     small_px_, 0.0f, 64.0f);
    }

    hw::Needs needs() const override
    {
        hw::Needs needs{.images = {source()}};
        if (is_of_ids()) needs.images.push_back({"triangle_corners", {}});
        if (is_of_ids() && storage_ == Storage::lists) needs.images.push_back({"triangle_stars", {}});
        return needs;
    }

    void prepare(hw::ProgramCache& programs) override
    {
        static constexpr std::array kFiles{
            "second_difference.frag", "diagonal.frag", "c1.frag", "c1.frag", "ids.frag", "ids.frag"};
        const char* file = kFiles[static_cast<std::size_t>(operator_)];
        std::string defines = format_ == Format::rgba8 ? "#define NORMAL_DEPTH_BYTES 1\n" : "";
        if (operator_ == Operator::c1_three_passes) {
            part_ = programs.full_screen("c1_part.frag", defines);
            defines += "#define IN_THREE_PASSES 1\n";
        }
        if (operator_ == Operator::ids_2011) defines += "#define IDS_OF_2011 1\n";
        if (is_of_ids() && storage_ == Storage::lists) defines += "#define TRIANGLES_BY_STARS 1\n";
        find_ = programs.full_screen(file, defines);
        find_wide_ = programs.full_screen(file, defines + "#define TO_BE_WIDENED 1\n");
        if (is_ours()) settle_ = programs.full_screen("settle.frag");
        const std::string settled = is_ours() ? "#define IS_SETTLED 1\n" : "";
        along_rows_ = programs.full_screen("widen.frag", "#define ALONG_ROWS 1\n" + settled);
        along_columns_ = programs.full_screen("widen.frag");
    }

    hw::Images make(hw::Pass& pass, hw::Items) override
    {
        const float px_scale = pass.view().px_scale;
        // Those of ids tell borders, too.
        const hw::TargetOutput made = of(is_of_ids() ? hw::PixelFormat::rgba8 : hw::PixelFormat::rg8, 1.0f);
        if (!is_widened(px_scale)) return found(pass, find_, {made});
        const hw::TargetOutput bytes = of(hw::PixelFormat::rgba8, 0.0f), two_bytes = of(hw::PixelFormat::rg8, 0.5f);
        const hw::Images edges = found(pass, find_wide_, {bytes, two_bytes});
        hw::Uniforms along_rows = widening(edges[0], edges[0], edges[1], px_scale);
        if (is_ours()) along_rows.set("settled", settled(pass, edges));
        const hw::Images rows = pass.filter({.outputs = {bytes, bytes}}, along_rows_, along_rows);
        return pass.filter({.outputs = {made, two_bytes}}, along_columns_,
                           widening(rows[0], rows[1], edges[1], px_scale));
    }

 private:
    static hw::TargetOutput of(hw::PixelFormat format, float clear)
    {
        return {.format = format, .filter = hw::PixelFilter::nearest, .clear = glm::vec4(clear)};
    }
    bool is_of_ids() const { return operator_ == Operator::ids || operator_ == Operator::ids_2011; }
    /// Ours know the nearer side.
    bool is_ours() const { return operator_ == Operator::second || operator_ == Operator::ids; }

    /// One pass finds edges one pixel wide; those of the papers are as wide as what they compare.
    bool is_widened(float px_scale) const
    {
        const float radius_px = is_of_ids() ? 1.0f / px_scale : static_cast<float>(radius_px_);
        const float found_px = is_ours() ? 1.0f / px_scale : 2.0f * radius_px;
        return std::max(width_px_, inner_width_px_) > found_px || halo_px_ > 0.0f;
    }

    hw::ImageKey source() const
    {
        if (is_of_ids()) return {"triangle_ids", {{"planes", operator_ == Operator::ids}}};
        return {"normal_depth",
                {{"format", std::string(kFormats[static_cast<std::size_t>(format_)])},
                 {"normal", std::string(kNormals[static_cast<std::size_t>(normal_)])}}};
    }

    hw::Images found(hw::Pass& pass, hw::Program find, const std::vector<hw::TargetOutput>& outputs) const
    {
        if (is_of_ids()) return pass.filter({.outputs = outputs}, find, of_ids(pass));
        const hw::DepthRange range = pass.depth_range(source());
        const hw::Uniforms uniforms = hw::Uniforms(of_operator(pass.view().px_scale))
                                          .set("normal_depth", pass.image(source()))
                                          .set("depth_range_m", glm::vec2(range.near_m, range.far_m))
                                          .set("reach_px", reach_px(pass.view().px_scale));
        if (operator_ != Operator::c1_three_passes) return pass.filter({.outputs = outputs}, find, uniforms);
        hw::Image sum;
        for (int part = 0; part + 1 < passes_; ++part)
            sum = pass.filter({.outputs = {of(hw::PixelFormat::rg8, 0.0f)}}, part_,
                              hw::Uniforms(uniforms).set("part", part).set("sum_before", sum))[0];
        return pass.filter({.outputs = outputs}, find,
                           hw::Uniforms(uniforms).set("part", passes_ - 1).set("sum_before", sum));
    }

    hw::Uniforms of_ids(hw::Pass& pass) const
    {
        hw::Uniforms uniforms;
        uniforms.set("triangle_ids", pass.image(source()))
            .set("triangle_corners", pass.image({"triangle_corners", {}}))
            .set("reach_px", reach_px(pass.view().px_scale));
        if (operator_ == Operator::ids)
            uniforms.set("planes", pass.image(source(), 1)).set("gap", gap_).set("small_px", small_px_);
        if (storage_ == Storage::lists)
            uniforms.set("triangle_stars", pass.image({"triangle_stars", {}}))
                .set("star_triangles", pass.image({"triangle_stars", {}}, 1));
        return uniforms;
    }

    hw::Uniforms of_operator(float px_scale) const
    {
        if (!is_ours())
            return hw::Uniforms().set("radius_px", std::max(1, static_cast<int>(px_scale * radius_px_ + 0.5f)));
        const glm::vec2 cosines(std::cos(std::min(1.04f * crease_rad_, 3.14159f)), std::cos(0.96f * crease_rad_));
        return hw::Uniforms().set("crease_cosines", cosines).set("gap", gap_);
    }

    /// Coverage reaches so far from the middle of inner edges, and from profile edges to the nearer side and beyond.
    glm::vec3 reach_px(float px_scale) const
    {
        glm::vec3 reach(0.5f * inner_width_px_, width_px_, halo_px_);
        // The papers' operators mark both sides of an edge, a pixel at least: half of the width lies on each.
        if (!is_ours())
            reach = glm::max(0.5f * glm::vec3(inner_width_px_, width_px_, 0.0f), glm::vec3(1.0f, 1.0f, 0.0f));
        return px_scale * reach;
    }

    /// How far from the centres of their pixels profile edges are; the papers' operators do not know which side is
    /// nearer.
    hw::Image settled(hw::Pass& pass, const hw::Images& edges) const
    {
        return pass.filter({.outputs = {of(hw::PixelFormat::r8, 0.5f)}}, settle_,
                           hw::Uniforms().set("edges", edges[0]).set("steps", edges[1]))[0];
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
    int radius_px_ = 1, passes_ = 3;
    Storage storage_ = Storage::vertices;
    float small_px_ = 4.0f;
    hw::Program find_, find_wide_, settle_, part_, along_rows_, along_columns_;
};

}  // namespace

HW_IMAGE_PASS(edge_map, "R: 1 - inner edge, G: 1 - profile edge, B of ids: 1 - border; 1 is no edge", EdgeMap)
