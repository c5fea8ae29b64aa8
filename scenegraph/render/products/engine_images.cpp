#include "hatchway/render/products/engine_images.hpp"

#include <algorithm>
#include <array>

#include "hatchway/param/param_reader.hpp"
#include "hatchway/render/products/triangle_tables.hpp"

namespace hw {
namespace {

/// Objects of other styles that lie wholly behind all objects whose style needs the image hide none of them, and are
/// left out.
std::vector<DrawItem> without_what_lies_behind(const Pass& pass, Items items, float far_m)
{
    const View& view = pass.view();
    const glm::dmat4 to_view(view.view_from_world);
    const glm::dvec3 along = -glm::dvec3(to_view[0][2], to_view[1][2], to_view[2][2]);
    std::vector<DrawItem> kept;
    for (const DrawItem& item : items) {
        const Box& bounds = item.bounds_world();
        const double nearest_m =
            glm::dot(bounds.centre() - view.eye_world, along) - 0.5 * glm::dot(glm::abs(along), bounds.size());
        if (bounds.is_empty() || nearest_m <= far_m) kept.push_back(item);
    }
    return kept;
}

class NormalDepth final : public ImagePass {
 public:
    explicit NormalDepth(const ImageKey& key) : key_(key) {}

    void visit_params(ParamVisitor& visitor) override
    {
        static constexpr std::array<std::string_view, 3> kFormats{"rgba32f", "rgba16f", "rgba8"};
        static constexpr std::array<std::string_view, 3> kNormals{"geometric", "shading", "face"};
        visitor.choice(
            {"format", "Of the image: rgba8 holds depth over the range of the objects.", ParamChange::rebuild}, format_,
            kFormats);
        visitor.choice(
            {"normal", "Which: interpolated, the same with the normal map, or the triangle's.", ParamChange::rebuild},
            normal_, kNormals);
    }
    Needs needs() const override { return {}; }
    void prepare(ProgramCache& programs) override
    {
        static constexpr std::array<std::string_view, 3> kOfNormal{"", "#define NORMAL_SHADING 1\n",
                                                                   "#define NORMAL_FACE 1\n"};
        std::string defines(kOfNormal[static_cast<std::size_t>(normal_)]);
        defines.append(format_ == Format::rgba8 ? "#define NORMAL_DEPTH_BYTES 1\n" : "");
        program_ = programs.surface("images/normal_depth.frag", defines);
    }
    Images make(Pass& pass, Items) override
    {
        static constexpr std::array kFormats{PixelFormat::rgba32f, PixelFormat::rgba16f, PixelFormat::rgba8};
        const DepthRange range = pass.depth_range(key_);
        const bool is_bytes = format_ == Format::rgba8;
        const TargetOutput output{.format = kFormats[static_cast<std::size_t>(format_)],
                                  .filter = PixelFilter::nearest,
                                  .clear = is_bytes ? glm::vec4(0.5f, 0.5f, 0.5f, 1.0f) : glm::vec4(0.0f)};
        Uniforms uniforms;
        if (is_bytes) uniforms.set("depth_range_m", glm::vec2(range.near_m, range.far_m));
        return pass.render({.outputs = {output}}, program_, uniforms,
                           without_what_lies_behind(pass, pass.opaque_scene(), range.far_m));
    }

 private:
    enum class Format { rgba32f, rgba16f, rgba8 };
    enum class Normal { geometric, shading, face };

    ImageKey key_;
    Format format_ = Format::rgba32f;
    Normal normal_ = Normal::geometric;
    Program program_;
};

/// The numbers of objects or triangles.
class Ids final : public ImagePass {
 public:
    explicit Ids(bool of_triangles) : of_triangles_(of_triangles) {}

    void visit_params(ParamVisitor& visitor) override
    {
        if (of_triangles_)
            visitor.flag({"planes", "A second output: how the triangle's plane goes on.", ParamChange::rebuild},
                         with_planes_);
    }
    Needs needs() const override { return {.streams = {.triangle_id = of_triangles_}}; }
    void prepare(ProgramCache& programs) override
    {
        std::string defines = of_triangles_ ? "#define IDS_OF_TRIANGLES 1\n" : "";
        if (with_planes_) defines += "#define IDS_WITH_PLANES 1\n";
        program_ = programs.surface("images/ids.frag", defines);
    }
    Images make(Pass& pass, Items) override
    {
        TargetDesc target{.outputs = {{.format = PixelFormat::r32ui}}};
        if (with_planes_) target.outputs.push_back({.format = PixelFormat::rgba32f});
        return pass.render(target, program_, {}, pass.opaque_scene());
    }

 private:
    bool of_triangles_;
    bool with_planes_ = false;
    Program program_;
};

std::unique_ptr<ImagePass> engine_image(const ImageKey& key, const Scene& scene)
{
    if (key.pass == "normal_depth") return std::make_unique<NormalDepth>(key);
    if (key.pass == "object_ids") return std::make_unique<Ids>(false);
    if (key.pass == "triangle_ids") return std::make_unique<Ids>(true);
    if (key.pass == "triangle_corners") return triangle_corners_image(scene);
    if (key.pass == "triangle_stars") return triangle_stars_image(scene);
    return nullptr;
}

}  // namespace

ImagePassSource with_engine_images(ImagePassSource others, ProgramCache& programs, const Scene& scene)
{
    return [others = std::move(others), &programs, &scene](const ImageKey& key) -> std::unique_ptr<ImagePass> {
        std::unique_ptr<ImagePass> pass = engine_image(key, scene);
        if (pass == nullptr) return others ? others(key) : nullptr;
        ParamSettings params;
        for (const auto& [name, value] : key.params) params[name] = {value, "/images/" + key.pass + "/" + name};
        ParamReader reader(params, "");
        pass->visit_params(reader);
        reader.refuse_unknown();
        pass->prepare(programs);
        return pass;
    };
}

}  // namespace hw
