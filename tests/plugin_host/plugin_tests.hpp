#pragma once

#include <filesystem>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/plugin_host/plugin_registry.hpp"
#include "hatchway/plugin_host/static_plugins.hpp"
#include "hatchway/style/style.hpp"

namespace hw::test {

inline const std::filesystem::path kMisbehaving = HATCHWAY_BUILD_DIR "/tests/plugin_host/misbehaving";

/// The message of the hw::Error that `action` throws; empty when it throws none.
inline std::string refusal(const std::function<void()>& action)
{
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

/// Lines that are neither blank nor a comment.
inline int lines_of_code(const std::string& source)
{
    std::istringstream lines(source);
    int count = 0;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t first = line.find_first_not_of(" \t");
        if (first != std::string::npos && line.compare(first, 2, "//") != 0) ++count;
    }
    return count;
}

/// The project's own plugins and those that misbehave.
inline const PluginRegistry& test_registry()
{
    static const PluginRegistry registry = [] {
        set_log_level(LogLevel::off);
        return PluginRegistry(PluginPlaces{
            .has_installed = false, .folders = {kMisbehaving}, .compiled_in = static_plugins(), .trial = Trial::none});
    }();
    return registry;
}

/// Counts what is asked of it and compiles nothing.
struct FakeProgramCache final : ProgramCache {
    Program surface(std::string_view file, std::string_view defines) override
    {
        asked.emplace_back(std::string(file) + "|" + std::string(defines));
        if (file == fails_for) throw Error({.what = "does not compile", .file = std::string(file)});
        return {1};
    }
    Program full_screen(std::string_view file, std::string_view defines) override { return surface(file, defines); }
    Program line(std::string_view file, std::string_view defines) override { return surface(file, defines); }
    Image texture(std::string_view) override { return {1, {1, 1}}; }

    std::vector<std::string> asked;
    std::string fails_for;
};

/// Counts what styles draw.
struct FakePass final : Pass {
    const View& view() const override { return a_view; }
    Layer layer() const override { return a_layer; }
    Items opaque_scene() const override { return {}; }
    DepthRange depth_range(const ImageKey&) const override { return {}; }
    void cover(Program, const Uniforms&) override {}
    Image image(const ImageKey&, std::size_t) const override { return {}; }
    Images render(const TargetDesc&, Program, const Uniforms&, Items) override { return made(1); }
    Images filter(const TargetDesc&, Program, const Uniforms& uniforms) override
    {
        last_uniforms = uniforms;
        return made(2);
    }
    static Images made(std::uint32_t id)
    {
        Images images;
        images.add({id, {1, 1}});
        return images;
    }
    void surfaces(Program program, const Uniforms& uniforms, Items items) override
    {
        drawn_surfaces += items.size();
        last_program = program;
        last_uniforms = uniforms;
    }
    void lines(Program, const Uniforms&, const LineLook& look, Items items) override { lines(look, items); }
    void lines(const LineLook& look, Items items) override
    {
        drawn_lines += items.size();
        for (const DrawItem& item : items) line_items.push_back(item);
        line_looks.insert(line_looks.end(), items.size(), look);
    }

    View a_view;
    Layer a_layer = Layer::opaque;
    std::size_t drawn_surfaces = 0;
    std::size_t drawn_lines = 0;
    Program last_program;
    Uniforms last_uniforms;
    std::vector<LineLook> line_looks;  ///< One for each of `line_items`.
    std::vector<DrawItem> line_items;
};

}  // namespace hw::test
