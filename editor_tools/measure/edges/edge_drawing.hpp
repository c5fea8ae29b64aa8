#pragma once

#include <span>

#include "hatchway/plugin_host/style_set.hpp"
#include "hatchway/render/renderer.hpp"

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

 private:
    /// Draws nothing into the picture.
    struct NoStyle final : Style {
        Needs needs() const override { return {}; }
        void prepare(ProgramCache&) override {}
    };

    Renderer renderer_;
    StyleSet set_;
    NoStyle style_;
};

/// The same view with the picture turned by a right angle, counter-clockwise.
View turned(const View& view);
/// A picture so turned.
Pixels turned(const Pixels& picture);

}  // namespace hw
