#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "hatchway/gl/context.hpp"
#include "hatchway/render/renderer.hpp"
#include "hatchway/render/view/camera_view.hpp"

namespace hw::test {

/// A box with flat normals around the origin.
MeshData box_mesh(const glm::vec3& size);
/// A flat square in the xz plane, looking up.
MeshData floor_mesh(float side);
/// A sphere with smooth normals.
MeshData sphere_mesh(float radius, int rings);

/// Adds an object with a node and a material of its own; returns its id.
ObjectId add_object(Scene& scene, MeshData mesh, const glm::dmat4& world_from_object, const Material& material);
Material painted(const glm::vec3& colour);

/// Draws faces in one colour, or as paper, and lines when it has any.
class TestStyle final : public Style {
 public:
    explicit TestStyle(glm::vec3 colour) : colour_(colour) {}
    Needs needs() const override;
    void prepare(ProgramCache& programs) override;
    void surfaces(Pass& pass, Items items) override;
    void lines(Pass& pass, Items items) override;

    std::optional<LineLook> look;  ///< Lines are drawn with this.
    float crease_rad = 0.7f;
    bool intersections = false;  ///< Lines where objects cut each other are among them.
    bool shows_images = false;   ///< Takes colours from normal_depth instead.
    ShadowNeed shadow = ShadowNeed::none;
    bool lightmap = false;
    std::string fragment_file = "test_flat.frag";

 private:
    glm::vec3 colour_;
    Program program_;
};

/// A renderer on a headless context; fails the test on GL errors.
class RendererTest : public testing::Test {
 protected:
    RendererTest();
    ~RendererTest() override;

    /// Gives every object the first style.
    void load(Style& style);
    void load(std::vector<NamedStyle> styles, std::vector<StyledObject> objects);
    void prepare(Style& style);
    View view_from(const glm::dvec3& eye, const glm::dvec3& target, glm::ivec2 size_px = {320, 240}) const;
    Pixels draw(const View& view, const FrameOptions& options = {});

    std::unique_ptr<Context> context_;
    std::unique_ptr<Renderer> renderer_;
    Scene scene_;
    SceneInput input_;  ///< What load() adds to.
    FrameStats stats_;
};

/// Writes a picture for looking at when the variable HATCHWAY_TEST_PICTURES names a folder.
void keep_picture(const Pixels& pixels, const std::string& name);

int count_unlike(const Pixels& a, const Pixels& b, int tolerance = 0);
/// The same as a share of the pixels of `a` that are not paper.
double share_unlike(const Pixels& a, const Pixels& b, int tolerance = 0);
/// Pixels darker than the threshold.
int count_dark(const Pixels& pixels, int below = 128);

}  // namespace hw::test
