#pragma once

#include <functional>

#include "tests/render/test_scenes.hpp"
#include "tests/temporary_folder.hpp"

namespace hw::test {

/// A style whose calls are functions of the test; those that are not set do nothing.
struct ScriptedStyle final : Style {
    Needs needs() const override { return needed; }
    void prepare(ProgramCache&) override {}
    void images(Pass& pass, Items items) override
    {
        if (makes_images) makes_images(pass, items);
    }
    void surfaces(Pass& pass, Items items) override
    {
        if (draws_surfaces) draws_surfaces(pass, items);
    }
    void lines(Pass& pass, Items items) override
    {
        if (draws_lines) draws_lines(pass, items);
    }

    Needs needed;
    std::function<void(Pass&, Items)> makes_images, draws_surfaces, draws_lines;
};

/// Shaders that stand in the test that uses them.
class ShaderFolder {
 public:
    explicit ShaderFolder(Renderer& renderer) : cache_(renderer.program_cache(folder_.path())) {}

    Program surface(const std::string& text) { return cache_.surface(written(text)); }
    Program full_screen(const std::string& text) { return cache_.full_screen(written(text)); }
    Program line(const std::string& text) { return cache_.line(written(text)); }
    ProgramCache& cache() { return cache_; }
    const std::filesystem::path& path() const { return folder_.path(); }

 private:
    std::string written(const std::string& text)
    {
        const std::string name = "shader_" + std::to_string(count_++) + ".frag";
        folder_.write(name, text);
        return name;
    }

    TemporaryFolder folder_;
    ProgramCache& cache_;
    int count_ = 0;
};

}  // namespace hw::test
