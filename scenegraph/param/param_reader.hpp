#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hatchway/param/param_value.hpp"
#include "hatchway/param/param_visitor.hpp"

namespace hw {

/// Writes stated values into visited parameters. An unknown name, wrong type or value out of range throws hw::Error
/// with the file, the pointer, what was found and what is allowed.
class ParamReader final : public ParamVisitor {
 public:
    /// `file` is named in messages. Images that the settings name lie inside of `root` and are found from the folder of
    /// `file`; without a root they stay as stated. `settings` must outlive the reader.
    ParamReader(const ParamSettings& settings, std::string file, std::filesystem::path root = {});

    void real(const ParamInfo& info, float& value, float min, float max) override;
    void whole(const ParamInfo& info, int& value, int min, int max) override;
    void flag(const ParamInfo& info, bool& value) override;
    void colour(const ParamInfo& info, glm::vec3& value) override;
    void map(const ParamInfo& info, MapName& value, MapKind kind) override;
    void image(const ParamInfo& info, ImageFile& value) override;

    /// Call after the visit: throws when a setting was not visited, naming the parameters that exist.
    void refuse_unknown() const;

 private:
    void choice_of(const ParamInfo& info, int& index, std::span<const std::string_view> names) override;
    const ParamSetting* find(const ParamInfo& info);
    const double* number(const ParamInfo& info, double min, double max, bool whole);
    const std::string* text(const ParamInfo& info, const std::string& expected);

    const ParamSettings& settings_;
    std::string file_;
    std::filesystem::path root_;
    std::vector<std::string> visited_;
};

/// "#rrggbb" to sRGB channels in [0, 1]; false when the text is no colour.
bool parse_colour(const std::string& text, glm::vec3& colour);

}  // namespace hw
