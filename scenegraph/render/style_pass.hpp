#pragma once

#include "hatchway/render/frame.hpp"

namespace hw {

/// In which part of the frame a style draws.
enum class PassStage : std::uint8_t {
    images,   ///< Nothing reaches the picture.
    base,     ///< An object's first style: opaque faces cover. They are collected in FrameResults::opaque_faces.
    over,     ///< Its second: faces at equal depth, mixed in by presence.
    blended,  ///< Faces of glTF BLEND materials.
};

/// The host's side of Pass: one call of one style, or of one image pass.
class StylePass final : public Pass {
 public:
    /// `maps` are those of the style's needs, for objects without maps of that kind; they must outlive the pass.
    StylePass(const Frame& frame, PassStage stage, const StyleReads& reads, const std::map<MapKind, int>& maps);

    const View& view() const override { return frame_.view.camera; }
    Layer layer() const override { return stage_ == PassStage::blended ? Layer::blended : Layer::opaque; }
    Image image(const ImageKey& key) const override;
    Image render(const TargetDesc& target, Program program, const Uniforms& uniforms, Items items) override;
    Image filter(const TargetDesc& target, Program program, const Uniforms& uniforms) override;
    void surfaces(Program program, const Uniforms& uniforms, Items items) override;
    void lines(const LineLook& look, Items items) override;

 private:
    GpuTarget* transient(const TargetDesc& target);
    /// Items that styles hand back are theirs to get wrong: those that this frame did not make are refused, once told.
    std::vector<DrawItem> of_this_frame(Items items) const;
    FaceCall call_of(Program program, const Uniforms& uniforms, Items items) const;

    const Frame& frame_;
    PassStage stage_;
    StyleReads reads_;
    const std::map<MapKind, int>& style_maps_;
};

}  // namespace hw
