#include "hatchway/world/light/transport.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <limits>

#include "hatchway/world/light/material.hpp"
#include "hatchway/world/light/random.hpp"

namespace hw {
namespace {

constexpr int kSureBounces = 2;  // after these a path goes on by chance
constexpr int kMaxBounces = 64;
constexpr std::uint32_t kAsked = LampChoice::kMostAsked;
constexpr std::uint32_t kRaysToMany = 8;  // shadow rays of a place where not every lamp gets one
constexpr std::uint32_t kRaysOfStep = 3;  // along the path, to a lamp, to an emitter
constexpr float kBeforeLight = 0.9999f;   // shadow rays end a little before what they aim at

/// Numbers of the sequences of one sample: a path's step takes a block of its own.
enum Dimension : std::uint32_t { direction_of_path, emitter_point, lamp_point, choice, count_per_step };
constexpr std::uint32_t kFirstDimension = 16;  // those below belong to whoever chose the place

glm::vec2 number(const LightSampleId& sample, int step, std::uint32_t dimension)
{
    return sample_2d(sample.index, kFirstDimension + static_cast<std::uint32_t>(step) * count_per_step + dimension,
                     sample.seed);
}

/// One number of two, fine enough to choose among any number of lamps.
double fine_share(const glm::vec2& numbers)
{
    return numbers.x + 0x1p-24 * numbers.y;
}

/// The estimate of one sample, with what every part of it needs.
class Path {
 public:
    Path(const LightScene& scene, const LightSources& sources, const LightSampleId& sample)
        : scene_(scene), sources_(sources), sample_(sample)
    {
    }
    LightEstimate estimate(const LightReceiver& receiver) const;

 private:
    glm::vec3 from_lamps(const LightReceiver& place) const;
    glm::vec3 from_lamp(const Light& light, const LightReceiver& place, const glm::vec2& on_lamp) const;
    glm::vec3 from_one_lamp(const LightReceiver& place, const glm::vec2& choice, const glm::vec2& on_lamp) const;
    glm::vec3 from_chosen_lamp(const LightReceiver& place, double share, const glm::vec2& on_lamp) const;
    glm::vec3 from_emitters(const LightReceiver& place, int step) const;
    glm::vec3 from_sky(const glm::vec3& direction) const
    {
        return direction.y > 0.0f ? sources_.sky_luminance : sources_.ground_luminance;
    }
    glm::vec3 start(const LightReceiver& place) const
    {
        return place.position + place.face_normal * scene_.clearance_m();
    }
    glm::vec3 unshadowed(const Light& light, const LightReceiver& place, glm::vec3& to_light, float& distance) const;

    const LightScene& scene_;
    const LightSources& sources_;
    const LightSampleId& sample_;
};

/// Weight of one of two ways to choose the same direction: the power heuristic.
float weight(float own_density, float other_density)
{
    const float own = own_density * own_density;
    const float other = other_density * other_density;
    return own + other > 0.0f ? own / (own + other) : 0.0f;
}

/// Illuminance of the receiver by a light that nothing hides, zero where the light is behind the face.
glm::vec3 Path::unshadowed(const Light& light, const LightReceiver& place, glm::vec3& to_light, float& distance) const
{
    const glm::vec3 lux =
        unshadowed_illuminance(light, glm::dvec3(place.position) + scene_.origin_world(), to_light, distance);
    if (glm::dot(place.face_normal, to_light) <= 0.0f) return glm::vec3(0.0f);
    return lux * std::max(0.0f, glm::dot(place.shading_normal, to_light));
}

glm::vec3 Path::from_lamp(const Light& light, const LightReceiver& place, const glm::vec2& on_lamp) const
{
    glm::vec3 to_light;
    float distance = 0.0f;
    const glm::vec3 lux = unshadowed(light, place, to_light, distance);
    if (luminance_of(lux) <= 0.0f) return glm::vec3(0.0f);
    const glm::vec3 from = start(place);
    const bool is_sun = light.type == LightType::sun;
    const glm::vec3 spread = disc_point(to_light, on_lamp);
    const glm::vec3 way = is_sun ? to_light + spread * std::tan(sources_.sun_radius_rad)
                                 : to_light * distance + spread * std::min(sources_.lamp_radius_m, 0.5f * distance);
    const float length = glm::length(way);
    const float end = is_sun ? std::numeric_limits<float>::infinity() : length * kBeforeLight;
    return scene_.is_blocked(from, way / length, end) ? glm::vec3(0.0f) : lux;
}

/// At the path's beginning: all lamps, or of many some, each out of another part of what they may give.
glm::vec3 Path::from_lamps(const LightReceiver& place) const
{
    const auto on_lamp = [&](std::uint32_t i) {
        return glm::fract(number(sample_, 0, lamp_point) + number({0, sample_.seed + i}, 0, lamp_point));
    };
    glm::vec3 sum(0.0f);
    if (scene_.lamps().asks_all()) {
        for (std::uint32_t i = 0; i < sources_.lights.size(); ++i)
            sum += from_lamp(sources_.lights[i], place, on_lamp(i));
        return sum;
    }
    const double share = fine_share(number(sample_, 0, choice));
    for (std::uint32_t i = 0; i < kRaysToMany; ++i)
        sum += from_chosen_lamp(place, (i + share) / kRaysToMany, on_lamp(i));
    return sum / static_cast<float>(kRaysToMany);
}

glm::vec3 Path::from_chosen_lamp(const LightReceiver& place, double share, const glm::vec2& on_lamp) const
{
    const std::optional<LampChoice::Chosen> lamp = scene_.lamps().chosen(place.position, place.face_normal, share);
    if (!lamp) return glm::vec3(0.0f);
    return from_lamp(sources_.lights[lamp->light], place, on_lamp) / lamp->chance;
}

/// One lamp, enough where the path comes only now and then; of few, chosen by what it would give here.
glm::vec3 Path::from_one_lamp(const LightReceiver& place, const glm::vec2& choice, const glm::vec2& on_lamp) const
{
    if (!scene_.lamps().asks_all()) return from_chosen_lamp(place, fine_share(choice), on_lamp);
    const std::size_t count = sources_.lights.size();
    glm::vec3 to_light;
    float distance = 0.0f;
    std::array<float, kAsked> own;
    float total = 0.0f;
    for (std::size_t i = 0; i < count; ++i)
        total += own[i] = luminance_of(unshadowed(sources_.lights[i], place, to_light, distance));
    if (!(total > 0.0f)) return glm::vec3(0.0f);
    float left = choice.x * total;
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (own[i] <= 0.0f) continue;
        chosen = i;
        left -= own[i];
        if (left < 0.0f) break;
    }
    return from_lamp(sources_.lights[chosen], place, on_lamp) * total / own[chosen];
}

glm::vec3 Path::from_emitters(const LightReceiver& place, int step) const
{
    const std::span<const Emitter> emitters = scene_.emitters();
    if (emitters.empty()) return glm::vec3(0.0f);
    glm::vec2 share = number(sample_, step, emitter_point);
    const float sought = share.x * emitters.back().power_so_far;
    auto found = std::upper_bound(emitters.begin(), emitters.end(), sought,
                                  [](float value, const Emitter& emitter) { return value < emitter.power_so_far; });
    if (found == emitters.end()) --found;
    const float before = found == emitters.begin() ? 0.0f : (found - 1)->power_so_far;
    share.x = std::clamp((sought - before) / (found->power_so_far - before), 0.0f, 1.0f);
    LightHit shining = scene_.point_of(*found, share);
    const glm::vec3 from = start(place);
    const glm::vec3 way = shining.position - from;
    const float distance = glm::length(way);
    if (!(distance > 0.0f)) return glm::vec3(0.0f);
    const glm::vec3 direction = way / distance;
    const float cosine = glm::dot(place.shading_normal, direction);
    if (cosine <= 0.0f || glm::dot(place.face_normal, direction) <= 0.0f) return glm::vec3(0.0f);
    float cosine_there = -glm::dot(shining.normal, direction);
    if (cosine_there < 0.0f) shining.is_back = !scene_.is_double_sided(shining.object);
    cosine_there = std::abs(cosine_there);
    const glm::vec3 luminance = scene_.emission(shining) * sources_.emission_luminance;
    if (luminance_of(luminance) <= 0.0f || cosine_there < 1e-6f) return glm::vec3(0.0f);
    if (scene_.is_blocked(from, direction, distance * kBeforeLight)) return glm::vec3(0.0f);
    const float density = scene_.emitter_density(shining.object) * distance * distance / cosine_there;
    return luminance * (cosine / density * weight(density, cosine / glm::pi<float>()));
}

LightEstimate Path::estimate(const LightReceiver& receiver) const
{
    LightEstimate result;
    result.rays = static_cast<std::uint32_t>(std::min<std::size_t>(sources_.lights.size(), kAsked));
    result.illuminance = from_lamps(receiver) + from_emitters(receiver, 0);
    glm::vec3 carried(1.0f);  // what illuminance at the path's end adds at its beginning
    LightReceiver place = receiver;
    for (int step = 0; step < kMaxBounces; ++step) {
        result.rays += kRaysOfStep;
        const glm::vec3 direction = cosine_direction(place.shading_normal, number(sample_, step, direction_of_path));
        const float cosine = glm::dot(place.shading_normal, direction);
        if (glm::dot(place.face_normal, direction) <= 0.0f || cosine <= 0.0f) break;
        const std::optional<LightHit> hit = scene_.first_hit(start(place), direction);
        if (!hit) {
            result.illuminance += carried * glm::pi<float>() * from_sky(direction);
            break;
        }
        if (hit->is_back) {
            result.has_met_back = step == 0;
            break;
        }
        const glm::vec3 luminance = scene_.emission(*hit) * sources_.emission_luminance;
        if (luminance_of(luminance) > 0.0f) {
            const glm::vec3 way = hit->position - place.position;
            const float density = scene_.emitter_density(hit->object) * glm::dot(way, way) /
                                  std::max(1e-6f, -glm::dot(hit->normal, direction));
            result.illuminance += carried * glm::pi<float>() * luminance * weight(cosine / glm::pi<float>(), density);
        }
        carried *= scene_.albedo(*hit);
        const float chance = step < kSureBounces ? 1.0f : std::max(carried.r, std::max(carried.g, carried.b));
        if (!(number(sample_, step, choice).y < chance)) break;
        if (chance < 1.0f) carried /= chance;
        place = {hit->position, hit->normal, hit->normal};
        const glm::vec3 from_lamp =
            from_one_lamp(place, number(sample_, step + 1, choice), number(sample_, step + 1, lamp_point));
        result.illuminance += carried * (from_lamp + from_emitters(place, step + 1));
    }
    return result;
}

}  // namespace

glm::vec3 unshadowed_illuminance(const Light& light, const glm::dvec3& place_world, glm::vec3& to_light,
                                 float& distance)
{
    if (light.type == LightType::sun) {
        to_light = glm::vec3(-glm::normalize(light.direction_world));
        distance = std::numeric_limits<float>::infinity();
        return light.colour * light.intensity;
    }
    const glm::dvec3 way = light.position_world - place_world;
    const double squared = std::max(glm::dot(way, way), 1e-8);
    distance = static_cast<float>(std::sqrt(squared));
    to_light = glm::vec3(way / std::sqrt(squared));
    double falloff = 1.0 / std::max(squared, 1e-4);
    if (light.range_m > 0.0f) {
        const double share = squared / (static_cast<double>(light.range_m) * light.range_m);
        falloff *= std::clamp(1.0 - share * share, 0.0, 1.0);
    }
    if (light.type == LightType::spot) {
        const double inner = std::cos(light.inner_cone_rad);
        const double outer = std::cos(light.outer_cone_rad);
        const double cosine = -glm::dot(glm::normalize(light.direction_world), glm::dvec3(to_light));
        const double cone = std::clamp((cosine - outer) / std::max(0.001, inner - outer), 0.0, 1.0);
        falloff *= cone * cone;
    }
    return light.colour * static_cast<float>(light.intensity * falloff);
}

LightEstimate sample_light(const LightScene& scene, const LightSources& sources, const LightReceiver& receiver,
                           const LightSampleId& sample)
{
    return Path(scene, sources, sample).estimate(receiver);
}

}  // namespace hw
