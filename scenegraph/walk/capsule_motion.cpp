// Collide and slide, with two departures. On the ground, horizontal speed belongs to the walker: floors only lift, and
// everything too steep is a vertical wall, so that slopes neither slow nor launch. And whether something carries is
// asked of the face behind the touch, not of the touch: a ball that rolls over the edge of a step touches it at a steep
// angle.
#include "hatchway/walk/capsule_motion.hpp"

#include <glm/geometric.hpp>

namespace hw {
namespace {

constexpr int kMaxTouches = 6;
constexpr double kNothing = 1e-9;  // metres: shorter ways are not moved
constexpr double kHair = 1e-6;     // of a way: a micrometre a metre
constexpr double kLevelCosine = 0.99;
constexpr double kProbeInset_m = 0.03;  // behind an edge that is touched: narrower ledges carry nobody
constexpr double kProbeLift_m = 0.05;
constexpr double kProbeReach_m = 0.12;
constexpr double kSureShare = 0.9;  // of the radius: what catches the rim of a body alone stops no fall
constexpr Capsule kProbe{.radius_m = 0.01, .height_m = 0.02};

const glm::dvec3 kUp(0.0, 1.0, 0.0);

/// Obstacles met in one move, as planes that the rest of the way must not enter.
struct Planes {
    glm::dvec3 normal[kMaxTouches];
    int count = 0;

    void add(const glm::dvec3& n) { normal[count++] = n; }
};

bool enters_any(const Planes& planes, const glm::dvec3& way)
{
    for (int i = 0; i < planes.count; ++i)
        if (glm::dot(way, planes.normal[i]) < 0.0) return true;
    return false;
}

/// `way` without what enters the plane, and a hair away from it: rounding must not make the next sweep stop at once.
glm::dvec3 along_plane(const glm::dvec3& way, const glm::dvec3& normal)
{
    return way - normal * (glm::dot(way, normal) - kHair * glm::length(way));
}

/// The part of `way` that enters no plane: along one plane, along the crease of two, or nothing.
glm::dvec3 clipped(const glm::dvec3& way, const Planes& planes)
{
    if (!enters_any(planes, way)) return way;
    for (int i = 0; i < planes.count; ++i) {
        const glm::dvec3& n = planes.normal[i];
        if (glm::dot(way, n) >= 0.0) continue;
        const glm::dvec3 along = along_plane(way, n);
        if (!enters_any(planes, along)) return along;
    }
    for (int i = 0; i < planes.count; ++i) {
        for (int j = 0; j < i; ++j) {
            const glm::dvec3 crease = glm::cross(planes.normal[i], planes.normal[j]);
            const double length = glm::length(crease);
            if (length < 1e-6) continue;
            const glm::dvec3 off = glm::normalize(planes.normal[i] + planes.normal[j]);
            const glm::dvec3 along =
                crease * (glm::dot(way, crease) / (length * length)) + off * kHair * glm::length(way);
            if (!enters_any(planes, along)) return along;
        }
    }
    return glm::dvec3(0.0);
}

glm::dvec3 horizontal(const glm::dvec3& v)
{
    return {v.x, 0.0, v.z};
}

/// Whether ground of this kind carries: by the angle of the touch, else by the face just behind the touched edge.
bool carries(const CollisionWorld& world, const Gait& gait, const SweepHit& hit)
{
    if (hit.normal.y >= gait.steepest_cosine) return true;
    const glm::dvec3 inward = -horizontal(hit.normal);
    if (hit.normal.y < 0.02 || glm::length(inward) < 1e-6) return false;
    const double scale = gait.capsule.radius_m / Capsule{}.radius_m;
    const Capsule probe{kProbe.radius_m * scale, kProbe.height_m * scale};
    const glm::dvec3 behind = hit.point_world + glm::normalize(inward) * kProbeInset_m * scale;
    const glm::dvec3 above = behind + kUp * kProbeLift_m * scale;
    const SweepHit below = sweep_capsule(world, above, above - kUp * kProbeReach_m * scale, probe);
    return below.is_hit && below.normal.y >= gait.steepest_cosine;
}

/// The rest of a horizontal way behind the walls, lifted over the floors that it runs into.
glm::dvec3 lifted(const glm::dvec3& way, const Planes& walls, const Planes& floors)
{
    glm::dvec3 result = clipped(horizontal(way), walls);
    double lift = 0.0;
    for (int i = 0; i < floors.count; ++i)
        lift = glm::max(lift, -glm::dot(horizontal(floors.normal[i]), result) / floors.normal[i].y);
    if (floors.count > 0) result.y = lift + kHair * glm::length(result);
    return result;
}

/// Moves as far along `way` as nothing is met.
SweepHit advance(const CollisionWorld& world, const Gait& gait, const glm::dvec3& way, Motion& motion)
{
    const SweepHit hit = sweep_capsule(world, motion.foot_world, motion.foot_world + way, gait.capsule);
    motion.foot_world = hit.foot_world;
    motion.has_touched |= hit.is_hit;
    return hit;
}

/// Slides a horizontal way; floors lift it, walls turn it.
Motion slide_level(const CollisionWorld& world, const Gait& gait, const glm::dvec3& foot_world, const glm::dvec3& way)
{
    Motion motion{.foot_world = foot_world, .velocity = way};
    Planes walls, floors;
    glm::dvec3 rest = way;
    for (int touch = 0; touch < kMaxTouches && glm::length(rest) > kNothing; ++touch) {
        const SweepHit hit = advance(world, gait, rest, motion);
        if (!hit.is_hit) break;
        const glm::dvec3 flat = horizontal(hit.normal);
        if (hit.normal.y >= gait.steepest_cosine)
            floors.add(hit.normal);
        else if (glm::length(flat) > 1e-3)
            walls.add(glm::normalize(flat));
        else
            break;  // a level ceiling over a rising floor: no way on
        rest = lifted(horizontal(rest) * (1.0 - hit.fraction), walls, floors);
    }
    motion.velocity = clipped(way, walls);
    return motion;
}

enum class Landing { on_ground, never };

Motion slide_free(const CollisionWorld& world, const Gait& gait, const glm::dvec3& foot_world, const glm::dvec3& way,
                  Landing landing)
{
    Motion motion{.foot_world = foot_world, .velocity = way};
    Planes planes;
    glm::dvec3 rest = way;
    for (int touch = 0; touch < kMaxTouches && glm::length(rest) > kNothing; ++touch) {
        const SweepHit hit = advance(world, gait, rest, motion);
        if (!hit.is_hit) break;
        planes.add(hit.normal);
        motion.velocity = clipped(way, planes);
        if (landing == Landing::on_ground && way.y <= 0.0 && carries(world, gait, hit)) {
            motion.is_carried = true;
            motion.is_firm = hit.normal.y > kLevelCosine;
            break;
        }
        rest = clipped(rest * (1.0 - hit.fraction), planes);
    }
    return motion;
}

/// Height of what carries the foot; its own height in the air.
double support_height(const CollisionWorld& world, const Gait& gait, const glm::dvec3& foot_world)
{
    const glm::dvec3 below = foot_world - kUp * 3.0 * kCollisionSkin;
    const SweepHit hit = sweep_capsule(world, foot_world, below, gait.capsule);
    return hit.is_hit ? hit.point_world.y : foot_world.y;
}

/// Up by a step, forward, down again. Carried only when it ends on ground that carries. The height of a step is that of
/// its edge over the ground: the round foot would roll over edges much higher than it is lifted.
Motion step_up(const CollisionWorld& world, const Gait& gait, const glm::dvec3& foot_world, const glm::dvec3& way)
{
    const glm::dvec3 raised = sweep_capsule(world, foot_world, foot_world + kUp * gait.step_m, gait.capsule).foot_world;
    Motion motion = slide_level(world, gait, raised, way);
    const glm::dvec3 floor_level(motion.foot_world.x, foot_world.y, motion.foot_world.z);
    const SweepHit down = sweep_capsule(world, motion.foot_world, floor_level, gait.capsule);
    motion.foot_world = down.foot_world;
    if (!down.is_hit) return motion;
    const double rise = down.point_world.y - support_height(world, gait, foot_world);
    motion.is_carried = rise <= gait.step_m && carries(world, gait, down);
    return motion;
}

double progress(const Motion& motion, const glm::dvec3& from, const glm::dvec3& way)
{
    return glm::dot(horizontal(motion.foot_world - from), way);
}

glm::dvec3 per_second(const glm::dvec3& way, double seconds)
{
    return way / seconds;
}

}  // namespace

Motion move_through_air(const CollisionWorld& world, const Gait& gait, const glm::dvec3& foot_world,
                        const glm::dvec3& velocity, double seconds)
{
    Motion motion = slide_free(world, gait, foot_world, velocity * seconds, Landing::on_ground);
    motion.velocity = per_second(motion.velocity, seconds);
    return motion;
}

Motion move_in_flight(const CollisionWorld& world, const Gait& gait, const glm::dvec3& foot_world,
                      const glm::dvec3& velocity, double seconds)
{
    Motion motion = slide_free(world, gait, foot_world, velocity * seconds, Landing::never);
    motion.velocity = per_second(motion.velocity, seconds);
    return motion;
}

Motion move_on_ground(const CollisionWorld& world, const Gait& gait, const glm::dvec3& foot_world,
                      const glm::dvec3& velocity, double seconds)
{
    const glm::dvec3 way = horizontal(velocity) * seconds;
    Motion motion = slide_level(world, gait, foot_world, way);
    if (motion.has_touched) {
        const Motion stepped = step_up(world, gait, foot_world, way);
        // A hair more than the plain slide, or rounding would hop in front of every wall.
        if (stepped.is_carried && progress(stepped, foot_world, way) > progress(motion, foot_world, way) + 1e-12)
            motion = stepped;
    }
    const Motion settled = settle(world, gait, motion.foot_world, gait.step_m + 2.0 * kCollisionSkin);
    if (settled.is_carried) motion.foot_world = settled.foot_world;
    motion.is_carried = settled.is_carried;
    motion.is_firm = settled.is_firm;
    motion.velocity = per_second(motion.velocity, seconds);
    return motion;
}

bool stops_a_fall(const CollisionWorld& world, const Gait& gait, const glm::dvec3& foot_world)
{
    if (world.nodes.empty()) return false;
    Gait narrow = gait;
    narrow.capsule.radius_m *= kSureShare;
    const double lowest = world.nodes.front().bounds.min.y;
    const auto fall = [&](double drop_m) {
        return slide_free(world, narrow, foot_world, -kUp * drop_m, Landing::on_ground);
    };
    if (fall(gait.step_m).is_carried) return true;  // most often; a short way costs little
    const double drop_m = foot_world.y - lowest + gait.capsule.height_m;
    if (drop_m <= 0.0) return false;
    const Motion end = fall(drop_m);
    return end.is_carried || end.foot_world.y > lowest;
}

Motion settle(const CollisionWorld& world, const Gait& gait, const glm::dvec3& foot_world, double drop_m)
{
    // Battered walls stop the way down before the floor does: slide off them, but not away down a slope.
    Motion motion = slide_free(world, gait, foot_world, -kUp * drop_m, Landing::on_ground);
    const double drift = glm::length(horizontal(motion.foot_world - foot_world));
    motion.is_carried = motion.is_carried && drift < 0.2 * gait.capsule.radius_m;
    if (!motion.is_carried) motion.foot_world = foot_world;
    motion.velocity = glm::dvec3(0.0);
    return motion;
}

}  // namespace hw
