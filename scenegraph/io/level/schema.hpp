#pragma once

#include <string>
#include <vector>

#include "hatchway/param/param_value.hpp"
#include "hatchway/param/param_visitor.hpp"

namespace hw {

enum class ParamType : unsigned char { real, whole, flag, colour, choice, map, image };

/// One parameter of a style as the JSON schema and the manual show it.
struct ParamSchema {
    std::string name;
    std::string help;
    ParamType type = ParamType::real;
    ParamChange change = ParamChange::live;
    double min = 0.0;  ///< Of real and whole.
    double max = 0.0;
    std::vector<std::string> choices;
    ParamValue default_value;
};

/// A style plugin as the JSON schema shows it.
struct StyleSchema {
    std::string name;
    std::string summary;
    std::vector<ParamSchema> params;
};

/// Collects the parameters of whatever it visits, in order, with their present values as defaults.
class SchemaCollector final : public ParamVisitor {
 public:
    void real(const ParamInfo& info, float& value, float min, float max) override;
    void whole(const ParamInfo& info, int& value, int min, int max) override;
    void flag(const ParamInfo& info, bool& value) override;
    void colour(const ParamInfo& info, glm::vec3& value) override;
    void map(const ParamInfo& info, MapName& value, MapKind kind) override;
    void image(const ParamInfo& info, ImageFile& value) override;

    const std::vector<ParamSchema>& params() const { return params_; }

 private:
    void choice_of(const ParamInfo& info, int& index, std::span<const std::string_view> names) override;
    std::vector<ParamSchema> params_;
};

/// The JSON schema (draft 7) of level files, made from the lists that read_level() reads by. `plugins` gives the
/// styles' parameters; a style of another plugin is left open. Ends with a newline; equal input gives equal text.
std::string level_schema(const std::vector<StyleSchema>& plugins);

}  // namespace hw
