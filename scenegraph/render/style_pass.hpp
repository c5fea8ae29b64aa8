#pragma once

#include <string>

#include "hatchway/render/frame.hpp"

namespace hw {

/// In which part of the frame a style draws.
enum class PassStage : std::uint8_t {
    images,   ///< Nothing reaches the picture.
    base,     ///< An object's first style: opaque faces cover. They are collected in FrameResults::opaque_faces.
    over,     ///< Its second: faces at equal depth, mixed in by presence.
    lines,    ///< The lines of both, over all of these.
    blended,  ///< Faces of glTF BLEND materials.
};

/// The host's side of Pass: one call of one style, or of one image pass.
class StylePass final : public Pass {
 public:
    /// What draws, its needs and the maps that these name. Both must outlive the frame's results.
    struct Drawer {
        std::string who;  ///< In messages: the style "NAME".
        const Needs& needs;
        const std::map<MapKind, int>& maps;
    };
    StylePass(const Frame& frame, PassStage stage, const Drawer& drawer)
        : frame_(frame), stage_(stage), drawer_(drawer), view_(frame.view.camera)
    {
        if (!drawer.needs.clock) view_.time_s = 0.0;
    }

    const View& view() const override { return view_; }
    Layer layer() const override { return stage_ == PassStage::blended ? Layer::blended : Layer::opaque; }
    Items opaque_scene() const override { return frame_.whole().opaque; }
    Image image(const ImageKey& key, std::size_t output) const override;
    DepthRange depth_range(const ImageKey& key) const override;
    Images render(const TargetDesc& target, Program program, const Uniforms& uniforms, Items items) override;
    Images filter(const TargetDesc& target, Program program, const Uniforms& uniforms) override;
    void surfaces(Program program, const Uniforms& uniforms, Items items) override;
    void lines(const LineLook& look, Items items) override;
    void lines(Program pen, const Uniforms& uniforms, const LineLook& look, Items items) override;
    void cover(Program program, const Uniforms& uniforms) override;

 private:
    /// Items that styles hand back are theirs to get wrong: those that this frame did not make are refused, once told.
    std::vector<DrawItem> of_this_frame(Items items) const;
    /// Null when the device has no such target.
    GpuTarget* transient(const TargetDesc& target, bool has_depth);
    /// After a pass into transient targets.
    void return_to_picture() const;
    /// In a rehearsal: which uniforms go nowhere.
    void remark_unheard(Program program, const Uniforms& uniforms) const;
    FaceCall call_of(Program program, const Uniforms& uniforms, Items items) const;
    void draw_lines(const LinePen& pen, const LineLook& look, Items items);

    const Frame& frame_;
    PassStage stage_;
    Drawer drawer_;
    View view_;  ///< As the style is told it.
};

}  // namespace hw
