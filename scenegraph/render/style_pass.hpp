#pragma once

#include <map>
#include <vector>

#include "render/edge_store.hpp"
#include "render/line_drawer.hpp"
#include "render/shared_images.hpp"
#include "render/surface_drawer.hpp"

namespace hw {

/// Opaque faces that a style drew, kept to be drawn again as depth alone.
struct DrawnFaces {
    Program program;
    Uniforms uniforms;
    std::vector<DrawItem> items;
    const std::map<MapKind, int>* style_maps = nullptr;
};

/// What one frame's passes share.
struct FrameParts {
    const View* view = nullptr;
    const VisibleSet* visible = nullptr;
    const std::vector<StyledObject>* looks = nullptr;
    GpuTarget* picture = nullptr;
    GpuState* state = nullptr;
    ProgramStore* programs = nullptr;
    TargetPool* pool = nullptr;
    SurfaceDrawer* surfaces = nullptr;
    LineDrawer* lines = nullptr;
    EdgeStore* edges = nullptr;
    LineFrame line_frame;
    const GpuVertexArray* no_vertices = nullptr;
    SurfaceFeatures scene_features = 0;  ///< Number of lights.
    std::uint32_t shadow_texture = 0;
    const GpuLightmap* lightmap = nullptr;
    std::map<ImageKey, Image> images;
    bool has_lines = false;               ///< Some style of the scene draws lines, seen or not.
    std::vector<DrawnFaces> drawn_faces;  ///< Filled while `has_lines`.
    int transient_targets = 0;
};

/// In which part of the frame a style draws.
enum class PassStage : std::uint8_t {
    images,   ///< Nothing reaches the picture.
    base,     ///< An object's first style: opaque faces cover.
    over,     ///< Its second: faces at equal depth, mixed in by presence.
    blended,  ///< Faces of glTF BLEND materials.
};

/// Which light of the frame a style reads.
struct StyleLight {
    bool uses_shadow = false;
    bool uses_lightmap = false;
};

/// The host's side of Pass: one call of one style, or of one image pass.
class StylePass final : public Pass {
 public:
    /// `maps` are those of the style's needs, for objects without maps of that kind; they must outlive the pass.
    StylePass(FrameParts& frame, PassStage stage, const StyleLight& light, const std::map<MapKind, int>& maps);

    const View& view() const override { return *frame_.view; }
    Image image(const ImageKey& key) const override;
    Image render(const TargetDesc& target, Program program, const Uniforms& uniforms,
                 std::span<const DrawItem> items) override;
    Image filter(const TargetDesc& target, Program program, const Uniforms& uniforms) override;
    void surfaces(Program program, const Uniforms& uniforms, std::span<const DrawItem> items) override;
    void lines(const LineLook& look, std::span<const DrawItem> items) override;

 private:
    GpuTarget* transient(const TargetDesc& target);
    void draw_surfaces(Program program, const Uniforms& uniforms, std::span<const DrawItem> items,
                       const PipelineState& state);

    FrameParts& frame_;
    PassStage stage_;
    StyleLight light_;
    const std::map<MapKind, int>& style_maps_;
};

/// Lays the depth of all opaque faces anew, behind the faces by the one polygon offset, so that lines on them are seen.
/// The faces themselves are drawn without it: an offset that grows with the slope would let the upright side of a slab
/// shine through the floor beside it.
void lay_line_depth(FrameParts& frame);

}  // namespace hw
