#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <optional>

#include "hatchway/style/style.hpp"

namespace hw {

/// Where something of a style rises: nowhere, between two heights, or from each object's foot to its top.
struct HeightRamp {
    enum class Over { none, height, object };

    /// What a style calls the three parameters, with their help.
    struct Infos {
        ParamInfo over, from, to;
    };

    Over over = Over::none;
    Ramp ramp;  ///< Heights in the world, metres; over an object shares of its height.

    void visit_params(ParamVisitor& visitor, const Infos& infos);

    /// In heights of the world; empty where nothing rises.
    std::optional<Ramp> of(const DrawItem& item) const;

    /// Calls draw(ramp, items) once for all items that share a ramp.
    template <typename Draw>
    void each(Items items, Draw&& draw) const;
};

/// The argument of hw_share_at() in presence.glsl.
inline glm::vec4 share_uniform(float constant, const std::optional<Ramp>& ramp)
{
    return ramp ? glm::vec4(constant, ramp->from, ramp->to, 1.0f) : glm::vec4(constant, 0.0f, 0.0f, 0.0f);
}

inline void HeightRamp::visit_params(ParamVisitor& visitor, const Infos& infos)
{
    static constexpr std::array<std::string_view, 3> kNames{"none", "height", "object"};
    visitor.choice(infos.over, over, kNames);
    visitor.real(infos.from, ramp.from, -1000.0f, 1000.0f);
    visitor.real(infos.to, ramp.to, -1000.0f, 1000.0f);
}

inline std::optional<Ramp> HeightRamp::of(const DrawItem& item) const
{
    if (over == Over::none) return {};
    if (over == Over::height || item.bounds_world().is_empty()) return ramp;
    const double foot = item.bounds_world().min.y;
    const double height = item.bounds_world().size().y;
    return Ramp{static_cast<float>(foot + ramp.from * height), static_cast<float>(foot + ramp.to * height)};
}

template <typename Draw>
void HeightRamp::each(Items items, Draw&& draw) const
{
    if (items.empty()) return;
    if (over != Over::object) return draw(of(items.front()), items);
    for (const DrawItem& item : items) draw(of(item), Items(&item, 1));
}

}  // namespace hw
