#pragma once

#include <set>
#include <string>
#include <vector>

#include "hatchway/param/param_visitor.hpp"

namespace hw {

/// Checks a list of parameters against the rules that make it fit for level files: names are lower_snake_case, each
/// once, and none that a level file uses itself; every parameter has its sentence of help; a range is finite, goes
/// upwards and holds the default; choices have names. Visit a fresh instance, which holds the defaults.
class ParamRules final : public ParamVisitor {
 public:
    void real(const ParamInfo& info, float& value, float min, float max) override;
    void whole(const ParamInfo& info, int& value, int min, int max) override;
    void flag(const ParamInfo& info, bool& value) override;
    void colour(const ParamInfo& info, glm::vec3& value) override;
    void map(const ParamInfo& info, MapName& value, MapKind kind) override;
    void image(const ParamInfo& info, ImageFile& value) override;

    /// One sentence for each rule that is broken.
    const std::vector<std::string>& broken() const { return broken_; }

 private:
    void choice_of(const ParamInfo& info, int& index, std::span<const std::string_view> names) override;
    void check(const ParamInfo& info);
    void check_range(const ParamInfo& info, double value, double min, double max);
    void object(const ParamInfo& info, const std::string& what);

    std::set<std::string> names_;
    std::vector<std::string> broken_;
};

}  // namespace hw
