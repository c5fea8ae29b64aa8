// What the device makes of numbers of triangles, against the same rule on the processor.
#include "measure/edges/id_reference.hpp"

#include <gtest/gtest.h>

#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/io/model/import.hpp"
#include "measure/edges/edge_cases.hpp"
#include "measure/edges/edge_drawing.hpp"
#include "tests/shared_data.hpp"

namespace hw::test {
namespace {

constexpr glm::ivec2 kSize(700, 450);

/// One view of a scene: the edges and what they are made of.
class Drawn {
 public:
    Drawn(const Scene& scene, const CameraPlace& camera)
        : view(camera_view(camera, kSize, scene.bounds_world)), reference(scene), drawing_(*context_, plugins_, scene)
    {
    }

    Pixels edges(const std::string& name, const std::string& storage)
    {
        return drawing_.draw(view, {"edge_map", {{"operator", name}, {"storage", storage}}});
    }
    /// What the edges of that operator, drawn last, are made of.
    IdImage image(const std::string& name)
    {
        return drawing_.ids({"triangle_ids", {{"planes", name == "ids"}}}, kSize);
    }
    std::size_t unlike(const std::string& name, const std::string& storage)
    {
        const Pixels map = edges(name, storage);
        return reference.unlike(map, image(name), view, {.is_of_2011 = name == "ids_2011"});
    }

    View view;
    IdReference reference;

 private:
    std::unique_ptr<Context> context_ = make_headless_context();
    PluginRegistry plugins_;
    EdgeDrawing drawing_;
};

void expect_alike(const Scene& scene, const CameraPlace& camera, const std::string& what)
{
    Drawn drawn(scene, camera);
    for (const char* name : {"ids", "ids_2011"})
        for (const char* storage : {"vertices", "lists"})
            EXPECT_EQ(drawn.unlike(name, storage), 0u) << what << ", " << name << ' ' << storage;
}

TEST(id_reference, is_what_the_device_does_on_known_scenes_and_on_a_fan)
{
    for (const EdgeCase& known : edge_cases()) expect_alike(known.scene, known.camera, known.name);
    const EdgeCase fan = cylinder_fan(64);
    expect_alike(fan.scene, fan.camera, fan.name);
}

TEST(id_reference, is_what_the_device_does_on_models_and_on_hard_meshes)
{
    std::vector<std::filesystem::path> files;
    for (const char* folder : {"models", "hard"}) {
        HATCHWAY_NEEDS_DATA(std::filesystem::exists(kSharedData / folder), "models");
        for (const auto& entry : std::filesystem::directory_iterator(kSharedData / folder))
            if (entry.path().extension() == ".glb") files.push_back(entry.path());
    }
    for (const std::filesystem::path& file : sampled(files, 5)) {
        const Scene scene = import_model(file, file.parent_path());
        expect_alike(scene, overview_camera(scene.bounds_world, 14.0 / 9.0), file.filename().string());
    }
}

TEST(id_reference, sees_one_wrong_pixel_and_one_wrong_number)
{
    const EdgeCase known = edge_cases().front();
    Drawn drawn(known.scene, known.camera);
    Pixels map = drawn.edges("ids", "vertices");
    IdImage image = drawn.image("ids");
    ASSERT_EQ(drawn.reference.unlike(map, image, drawn.view, {}), 0u);
    map.at(20, 20)[1] = 0;
    EXPECT_EQ(drawn.reference.unlike(map, image, drawn.view, {}), 1u);
    map.at(20, 20)[1] = 255;
    image.ids[std::size_t(kSize.x) * 100 + 100] = 0;
    EXPECT_EQ(drawn.reference.unlike(map, image, drawn.view, {}), 4u) << "its four neighbours end there";
}

}  // namespace
}  // namespace hw::test
