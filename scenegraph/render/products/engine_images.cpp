#include "hatchway/render/products/engine_images.hpp"

#include <algorithm>
#include <array>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

struct EngineImageKind {
    std::string_view name;
    const char* fragment_file;
    PixelFormat format;
    bool numbers_triangles;
};

constexpr std::array<EngineImageKind, 3> kKinds{{
    {"normal_depth", "images/normal_depth.frag", PixelFormat::rgba32f, false},
    {"object_ids", "images/object_ids.frag", PixelFormat::r32ui, false},
    {"triangle_ids", "images/triangle_ids.frag", PixelFormat::r32ui, true},
}};

class EngineImage final : public ImagePass {
 public:
    explicit EngineImage(const EngineImageKind& kind) : kind_(kind) {}

    Needs needs() const override
    {
        Needs needs;
        needs.streams.triangle_id = kind_.numbers_triangles;
        return needs;
    }
    void prepare(ProgramCache& programs) override { program_ = programs.surface(kind_.fragment_file); }
    Images make(Pass& pass, Items) override
    {
        return pass.render({.outputs = {{.format = kind_.format}}}, program_, {}, pass.opaque_scene());
    }

 private:
    const EngineImageKind& kind_;
    Program program_;
};

}  // namespace

ImagePassSource with_engine_images(ImagePassSource others, ProgramCache& programs)
{
    return [others = std::move(others), &programs](const ImageKey& key) -> std::unique_ptr<ImagePass> {
        const auto kind = std::find_if(kKinds.begin(), kKinds.end(),
                                       [&](const EngineImageKind& candidate) { return candidate.name == key.pass; });
        if (kind == kKinds.end()) return others ? others(key) : nullptr;
        if (!key.params.empty())
            throw Error({.what = "the image " + key.pass + " is asked for with parameters", .expected = "none"});
        auto pass = std::make_unique<EngineImage>(*kind);
        pass->prepare(programs);
        return pass;
    };
}

}  // namespace hw
