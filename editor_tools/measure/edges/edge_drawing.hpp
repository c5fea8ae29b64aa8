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
    /// least of three.
    Pixels draw(const View& view, const ImageKey& key, double* images_s = nullptr);

    /// What the frame that was drawn last made of triangle_ids.
    IdImage ids(const ImageKey& key, glm::ivec2 size_px);

    /// What it takes to draw all faces plainly: the least of three.
    double plain_s(const View& view);

    /// The lines of the meshes, one pixel wide, as an edge map: G is black on contours and borders, R on all others.
    /// `lines_s`, when not null, receives what they add to a frame of plain faces: the least of three of each. What is
    /// prepared once, as edge tables, is not in it.
    Pixels object_lines(const View& view, double* lines_s = nullptr);

 private:
    /// Draws nothing into the picture, or plain faces, or lines.
    struct PlainStyle final : Style {
        Needs needs() const override { return needed; }
        void prepare(ProgramCache& programs) override { program = programs.surface("plain.frag"); }
        void surfaces(Pass& pass, Items items) override
        {
            if (is_drawn) pass.surfaces(program, {}, items);
        }
        void lines(Pass& pass, Items items) override
        {
            if (needed.edges) pass.lines(look, items);
        }
        Needs needed;
        LineLook look;
        Program program;
        bool is_drawn = false;
    };
    void wear(bool has_lines);

    Renderer renderer_;
    StyleSet set_;
    PlainStyle style_, line_style_;
    std::size_t objects_;
};

/// The same view with the picture turned by a right angle, counter-clockwise.
View turned(const View& view);
/// A picture so turned.
Pixels turned(const Pixels& picture);

}  // namespace hw
