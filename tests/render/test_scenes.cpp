#include "tests/render/test_scenes.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>

#include "hatchway/gl/headless_context.hpp"
#include "hatchway/io/images/images.hpp"

namespace hw::test {
namespace {

constexpr const char* kShaderFolder = HATCHWAY_SOURCE_DIR "/tests/render/shaders";

void add_quad(MeshData& mesh, const std::array<glm::vec3, 4>& corners)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const glm::vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[3] - corners[0]));
    for (const glm::vec3& corner : corners) {
        mesh.positions.push_back(corner);
        mesh.normals.push_back(normal);
    }
    for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + i);
}

}  // namespace

MeshData box_mesh(const glm::vec3& size)
{
    MeshData mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 n(0.0f);
            glm::vec3 u(0.0f);
            n[axis] = side;
            u[(axis + 1) % 3] = 1.0f;
            const glm::vec3 v = glm::cross(n, u);
            const glm::vec3 half = 0.5f * size;
            add_quad(mesh, {(n - u - v) * half, (n + u - v) * half, (n + u + v) * half, (n - u + v) * half});
        }
    return mesh;
}

MeshData floor_mesh(float side)
{
    const float h = 0.5f * side;
    MeshData mesh;
    add_quad(mesh, {glm::vec3(-h, 0, h), glm::vec3(h, 0, h), glm::vec3(h, 0, -h), glm::vec3(-h, 0, -h)});
    return mesh;
}

MeshData sphere_mesh(float radius, int rings)
{
    MeshData mesh;
    const int columns = 2 * rings;
    for (int ring = 0; ring <= rings; ++ring)
        for (int column = 0; column < columns; ++column) {
            const double polar = M_PI * ring / rings;
            const double around = 2.0 * M_PI * column / columns;
            const bool is_pole = ring == 0 || ring == rings;
            const double sine = is_pole ? 0.0 : std::sin(polar);
            const glm::vec3 n(sine * std::cos(around), std::cos(polar), sine * std::sin(around));
            mesh.positions.push_back(radius * n);
            mesh.normals.push_back(n);
        }
    const auto at = [&](int ring, int column) { return static_cast<std::uint32_t>(ring * columns + column % columns); };
    for (int ring = 0; ring < rings; ++ring)
        for (int column = 0; column < columns; ++column) {
            const std::uint32_t a = at(ring, column), b = at(ring, column + 1);
            const std::uint32_t c = at(ring + 1, column), d = at(ring + 1, column + 1);
            if (ring > 0) mesh.indices.insert(mesh.indices.end(), {a, b, c});
            if (ring < rings - 1) mesh.indices.insert(mesh.indices.end(), {b, d, c});
        }
    mesh.has_own_normals = true;
    return mesh;
}

Material painted(const glm::vec3& colour)
{
    Material material;
    material.base_colour = glm::vec4(colour, 1.0f);
    material.metallic = 0.0f;
    return material;
}

ObjectId add_object(Scene& scene, MeshData mesh, const glm::dmat4& world_from_object, const Material& material)
{
    Box bounds;
    for (const glm::vec3& position : mesh.positions) bounds.add(glm::dvec3(position));
    Object object;
    object.node = static_cast<int>(scene.nodes.size());
    object.mesh = static_cast<int>(scene.meshes.size());
    object.material = static_cast<int>(scene.materials.size());
    object.bounds_world = transformed(bounds, world_from_object);
    scene.bounds_world.add(object.bounds_world);
    Node node;
    node.local = node.world_from_node = world_from_object;
    scene.nodes.push_back(node);
    scene.meshes.push_back(std::move(mesh));
    scene.materials.push_back(material);
    scene.objects.push_back(object);
    return static_cast<ObjectId>(scene.objects.size() - 1);
}

Needs TestStyle::needs() const
{
    Needs needs;
    if (look) needs.edges = EdgeNeed{.crease_rad = crease_rad, .intersections = intersections};
    if (shows_images) needs.images.push_back({"normal_depth", {}});
    needs.shadow = shadow;
    needs.lightmap = lightmap;
    return needs;
}

void TestStyle::prepare(ProgramCache& programs)
{
    program_ = programs.surface(fragment_file, shows_images ? "#define SHOWS_IMAGE 1\n" : "");
}

void TestStyle::surfaces(Pass& pass, Items items)
{
    Uniforms uniforms;
    uniforms.set("flat_colour", colour_);
    if (shows_images) uniforms.set("normal_depth", pass.image({"normal_depth", {}}));
    pass.surfaces(program_, uniforms, items);
}

void TestStyle::lines(Pass& pass, Items items)
{
    if (look) pass.lines(*look, items);
}

RendererTest::RendererTest() : context_(make_headless_context()), renderer_(std::make_unique<Renderer>(*context_)) {}

RendererTest::~RendererTest()
{
    renderer_.reset();
    EXPECT_THAT(context_->take_errors(), testing::IsEmpty());
}

void RendererTest::prepare(Style& style)
{
    style.prepare(renderer_->program_cache(kShaderFolder));
}

void RendererTest::load(Style& style)
{
    StyledObject look;
    look.style = 0;
    load({{"only", &style}}, std::vector<StyledObject>(scene_.objects.size(), look));
}

void RendererTest::load(std::vector<NamedStyle> styles, std::vector<StyledObject> objects)
{
    for (const NamedStyle& style : styles) prepare(*style.style);
    input_.scene = &scene_;
    input_.styles = std::move(styles);
    input_.objects = std::move(objects);
    renderer_->load(input_);
}

View RendererTest::view_from(const glm::dvec3& eye, const glm::dvec3& target, glm::ivec2 size_px) const
{
    return camera_view({eye, target, 60.0}, size_px, scene_.bounds_world);
}

Pixels RendererTest::draw(const View& view, const FrameOptions& options)
{
    stats_ = renderer_->draw(view, options);
    return renderer_->read_picture();
}

void keep_picture(const Pixels& pixels, const std::string& name)
{
    if (const char* folder = std::getenv("HATCHWAY_TEST_PICTURES"))
        write_png(std::filesystem::path(folder) / (name + ".png"), pixels);
}

int count_unlike(const Pixels& a, const Pixels& b, int tolerance)
{
    int count = 0;
    for (std::size_t i = 0; i < a.bytes.size(); i += 3) {
        int largest = 0;
        for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, std::abs(a.bytes[i + c] - b.bytes[i + c]));
        count += largest > tolerance ? 1 : 0;
    }
    return count;
}

double share_unlike(const Pixels& a, const Pixels& b, int tolerance)
{
    const auto pixels = static_cast<int>(a.bytes.size() / 3);
    const int inked =
        count_unlike(a, {a.width, a.height, a.channels, std::vector<std::uint8_t>(a.bytes.size(), 255)}, 5);
    EXPECT_GT(inked, pixels / 200) << "almost nothing is drawn";
    return static_cast<double>(count_unlike(a, b, tolerance)) / std::max(inked, 1);
}

int count_dark(const Pixels& pixels, int below)
{
    int count = 0;
    for (std::size_t i = 0; i < pixels.bytes.size(); i += 3)
        count += pixels.bytes[i] < below && pixels.bytes[i + 1] < below && pixels.bytes[i + 2] < below ? 1 : 0;
    return count;
}

}  // namespace hw::test
