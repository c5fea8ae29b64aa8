#pragma once

#include <span>

#include "hatchway/plugin_host/style_set.hpp"
#include "hatchway/render/renderer.hpp"
#include "measure/edges/id_reference.hpp"

namespace hw {

/// Draws images of a scene, all of which is in them.
class EdgeDrawing {
 public:
    /// The context must be current in every call; all must outlive this.
    EdgeDrawing(Context& context, const PluginRegistry& plugins, const Scene& scene,
                std::span<const MeshChunks> chunks = {});

    /// The bytes of an image. `images_s`, when not null, receives what making it took, what it reads included: the
    /// less of two.
    Pixels draw(const View& view, const ImageKey& key, double* images_s = nullptr);

    /// What the frame that was drawn last made of triangle_ids.
    IdImage ids(const ImageKey& key, glm::ivec2 size_px);

    /// What it takes to draw all faces plainly: the less of two.
    double plain_s(const View& view);

 private:
    /// Draws nothing into the picture, or plain faces.
    struct PlainStyle final : Style {
        Needs needs() const override { return {}; }
        void prepare(ProgramCache& programs) override { program = programs.surface("plain.frag"); }
        void surfaces(Pass& pass, Items items) override
        {
            if (is_drawn) pass.surfaces(program, {}, items);
        }
        Program program;
        bool is_drawn = false;
    };

    Renderer renderer_;
    StyleSet set_;
    PlainStyle style_;
};

/// The same view with the picture turned by a right angle, counter-clockwise.
View turned(const View& view);
/// A picture so turned.
Pixels turned(const Pixels& picture);

}  // namespace hw
