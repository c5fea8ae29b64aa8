// What `measure frame` reports of a PVS that is broken on purpose, with a wrong value that is known.
#include "measure/frame/frame_series.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include "hatchway/world/visibility/visibility.hpp"
#include "tests/render/test_scenes.hpp"

namespace hw::test {
namespace {

/// Two walls that fill the left and the right half of the picture; a floor that they hide makes room for the eye.
class frame_series : public RendererTest {
 protected:
    frame_series() : style_(glm::vec3(1.0f))
    {
        const glm::dmat4 upright = glm::rotate(glm::dmat4(1.0), glm::radians(90.0), glm::dvec3(1, 0, 0));
        for (const double x : {-10.0, 10.0})
            add_object(scene_, floor_mesh(20.0f), glm::translate(glm::dmat4(1.0), glm::dvec3(x, 0, -2)) * upright,
                       painted({0.2f, 0.4f, 0.1f}));
        add_object(scene_, floor_mesh(20.0f), glm::translate(glm::dmat4(1.0), glm::dvec3(0, -10, 4)),
                   painted({0.5f, 0.5f, 0.5f}));
        scene_.bounds_world = {};
        for (const Object& object : scene_.objects) {
            scene_.bounds_world.add(object.bounds_world.min);
            scene_.bounds_world.add(object.bounds_world.max);
        }
        for (MeshData& mesh : scene_.meshes) chunks_.push_back(split_into_chunks(mesh));
        visibility_ = build_visibility(scene_, {}, chunks_, {});
        input_.visibility = &visibility_;
        input_.chunks = chunks_;
    }

    void lose(std::uint32_t slot)
    {
        for (int cell = 0; cell < visibility_.slot_rows.leaf_count(); ++cell)
            visibility_.slot_rows.hide(cell, static_cast<int>(slot));
    }

    /// Of the frames with the PVS against those without.
    double unlike_share()
    {
        load(style_);
        const std::vector<View> views{view_from({0, 0, 0}, {0, 0, -1}), view_from({0, 0.5, 0}, {0, 0.5, -1})};
        const std::array<measure::FrameVariant, 2> variants{{{renderer_.get(), false}, {renderer_.get(), true}}};
        const std::vector<measure::FrameSeries> series = measure::draw_in_turn(variants, views, 1);
        EXPECT_EQ(series[1].frames.size(), views.size());
        EXPECT_EQ(series[0].unlike_share, 0.0) << "the first variant is what pictures are compared with";
        return series[1].unlike_share;
    }

    TestStyle style_;
    std::vector<MeshChunks> chunks_;
    Visibility visibility_;
};

TEST_F(frame_series, whole_rows_change_no_pixel)
{
    EXPECT_EQ(unlike_share(), 0.0);
}

TEST_F(frame_series, a_row_that_lost_one_of_two_walls_changes_half_of_the_pixels)
{
    lose(0);
    EXPECT_NEAR(unlike_share(), 0.5, 1.0 / 320.0);
}

TEST_F(frame_series, rows_that_lost_both_walls_change_all_pixels)
{
    lose(0);
    lose(1);
    EXPECT_EQ(unlike_share(), 1.0);
}

}  // namespace
}  // namespace hw::test
