// Edge map: an image of the visible edges, from discontinuities of normals and depth.
// Source: Nienhaus, Doellner. Edge-Enhancement. Journal of WSCG 11, 2003, section 4.1.2.
#include <array>

#include "hatchway/style/style.hpp"

namespace {

enum class Operator { diagonal, c1 };
constexpr std::array<std::string_view, 2> kOperators{"diagonal", "c1"};

class EdgeMap final : public hw::ImagePass {
 public:
    void visit_params(hw::ParamVisitor& visitor) override
    {
        visitor.choice(
            {"operator", "How depth is compared: diagonal neighbours, or all eight (C1).", hw::ParamChange::rebuild},
            operator_, kOperators);
        visitor.real({"depth_scale", "How strongly a step in depth, as a share of the distance, counts."}, depth_scale_,
                     0.1f, 1000.0f);
        visitor.real({"width_px", "Distance of the compared pixels: half the width of an edge."}, width_px_, 0.25f,
                     8.0f);
    }

    hw::Needs needs() const override
    {
        hw::Needs needs;
        needs.images.push_back({"normal_depth", {}});
        return needs;
    }

    void prepare(hw::ProgramCache& programs) override
    {
        program_ = programs.full_screen("edge_map.frag", operator_ == Operator::c1 ? "#define OPERATOR_C1 1\n" : "");
    }

    hw::Images make(hw::Pass& pass, hw::Items) override
    {
        hw::Uniforms uniforms;
        uniforms.set("normal_depth", pass.image({"normal_depth", {}}))
            .set("depth_scale", depth_scale_)
            .set("width_px", width_px_);
        return pass.filter({.outputs = {{.format = hw::PixelFormat::rg8, .clear = glm::vec4(1.0f)}}}, program_,
                           uniforms);
    }

 private:
    Operator operator_ = Operator::diagonal;
    float depth_scale_ = 30.0f;
    float width_px_ = 0.75f;
    hw::Program program_;
};

}  // namespace

HW_IMAGE_PASS(edge_map, "Edges from discontinuities of normals (R) and depth (G); 1 is no edge", EdgeMap)
