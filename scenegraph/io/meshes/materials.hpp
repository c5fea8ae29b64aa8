#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "hatchway/world/scene.hpp"

namespace hw {

/// The material of what has none: light grey, or white where vertices have colours. These formats do not say whether a
/// surface is closed, and scans are not: both sides of every material are drawn.
Material plain_material(bool has_vertex_colours);

/// Materials of OBJ's .mtl files: Kd, d or Tr, map_Kd. Colours are taken for sRGB, as the programs that write them
/// show them.
class ObjMaterials {
 public:
    /// Reads the files that `file` names, beside it and inside of `project_root`. What is missing, outside or broken is
    /// told and left out: the shape is there without it.
    ObjMaterials(const std::filesystem::path& file, const std::filesystem::path& project_root,
                 const std::vector<std::string>& material_files);

    /// Index into scene.materials of the material of that name, added with its texture when it is first asked for. One
    /// that no file has is a plain one of that name.
    int import_material(const std::string& name, bool has_vertex_colours, Scene& scene);

 private:
    struct Stated {
        Material material;
        std::string texture;  ///< As the file names it; empty: none.
    };
    void read(const std::string& file);
    void read_line(std::string_view line, Stated*& current);
    int import_texture(const std::string& texture, Scene& scene);
    std::filesystem::path resolve(const std::string& named) const;

    std::filesystem::path file_;
    std::filesystem::path project_root_;
    std::map<std::string, Stated> stated_;
    std::map<std::pair<std::string, bool>, int> imported_;
    std::map<std::string, int> textures_;
    std::uint64_t bytes_ = 0;
    std::uint64_t pixels_ = 0;
};

}  // namespace hw
