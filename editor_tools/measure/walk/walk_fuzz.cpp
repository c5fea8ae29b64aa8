#include "measure/walk/walk_fuzz.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <unordered_set>

#include "measure/share_work.hpp"
#include "measure/walk/walk_hands.hpp"

namespace hw::measure {
namespace {

constexpr double kCell_m = 0.5;
constexpr double kFlightToggle = 0.01;  // of an input, in walks that fly
constexpr std::size_t kMostFaults = 8;
constexpr double kFastestWheel = 10.0, kFastestFall_mps = 60.0;
constexpr double kAttempt_s = 2.0, kAttemptFrame_s = 1.0 / 60.0;
constexpr int kDirections = 16;

std::uint64_t cell_of(const glm::dvec3& foot)
{
    const glm::dvec3 cell = glm::floor(foot / kCell_m);
    const auto bits = [](double v) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(v)) & 0x1fffffu; };
    return bits(cell.x) << 42u | bits(cell.y) << 21u | bits(cell.z);
}

/// One walk and its judge.
class Walk {
 public:
    Walk(const WalkOracle& oracle, const Walker& walker, const PlayerBody& body, std::span<const PlayerState> starts,
         const WalkFuzzOptions& options, std::uint32_t number)
        : oracle_(oracle),
          walker_(walker),
          body_(body),
          starts_(starts),
          options_(options),
          number_(number),
          hands_((options.seed - 1) * options.walks + number + 1),
          flies_(options.flying > 0 && number % options.flying == options.flying - 1),
          scale_(body.eye_m / PlayerBody{}.eye_m)
    {
        judged_ = {body.gait.capsule.radius_m, body.gait.capsule.height_m, body.gait.step_m};
        begin_at(number);
    }

    void run(std::uint64_t inputs)
    {
        for (; counts.inputs < inputs; ++counts.inputs) {
            PlayerInput input = hands_.next();
            if (flies_ && hands_.happens(kFlightToggle)) state_ = with_flight_toggled(state_, body_);
            for (int left = hands_.frames(); left > 0; --left) {
                hands_.move_mouse(input);
                frame(input, hands_.frame_s());
            }
            if (!flies_ && still_s_ > options_.patience_s) judge_stillness();
        }
    }

    WalkCounts counts;
    std::unordered_set<std::uint64_t> cells;

 private:
    void begin_at(std::uint64_t place)
    {
        state_ = starts_[place % starts_.size()];
        anchor_ = state_.foot_world;
        still_s_ = 0.0;
    }

    void fault(std::uint64_t WalkCounts::*counter, const char* what, const glm::dvec3& foot)
    {
        ++(counts.*counter);
        if (counts.faults.size() < kMostFaults)
            counts.faults.push_back({what, number_, counts.inputs, foot, oracle_.depth(foot, judged_)});
    }

    void frame(const PlayerInput& input, double seconds)
    {
        const PlayerState before = state_;
        state_ = walker_(before, input, seconds);
        ++counts.frames;
        counts.walked_s += seconds;
        const double way_m = glm::distance(before.foot_world, state_.foot_world);
        const double depth_m = oracle_.depth(state_.foot_world, judged_);
        counts.worst_depth_m = std::max(counts.worst_depth_m, depth_m);
        if (depth_m > options_.tolerance_m) fault(&WalkCounts::penetrations, "penetrations", state_.foot_world);
        if (state_.put_back_count == before.put_back_count) counts.way_m += way_m;
        const bool looks_wrong = depth_m > options_.tolerance_m || way_m > farthest_m(seconds) ||
                                 state_.put_back_count != before.put_back_count ||
                                 oracle_.crossed(before.foot_world, state_.foot_world, judged_);
        if (looks_wrong) judge_ticks(before, input, seconds);
        judge_eye();
        if (!flies_ && state_.is_flying) {
            fault(&WalkCounts::lost, "lost", state_.foot_world);
            begin_at(number_ + counts.stuck + counts.lost);
        }
        cells.insert(cell_of(state_.foot_world / scale_));
        still_s_ += seconds;
        if (glm::distance(anchor_, state_.foot_world) > options_.freedom_m * scale_) {
            anchor_ = state_.foot_world;
            still_s_ = 0.0;
        }
    }

    double farthest_m(double seconds) const
    {
        const double fastest_mps = std::max(body_.walk_mps, body_.fly_mps) * body_.fast_factor * kFastestWheel;
        return (fastest_mps + kFastestFall_mps * scale_) * seconds + 2.0 * body_.gait.step_m;
    }

    /// Walks a frame again, tick by tick. What the mouse turned must not be turned twice.
    void judge_ticks(PlayerState state, PlayerInput input, double seconds)
    {
        constexpr double kOver_s = 1e-9;  // a tick's end, however it is rounded
        while (seconds > 0.0) {
            const double part_s = std::min(seconds, kPlayerTick_s - state.rest_s + kOver_s);
            const PlayerState next = walker_(state, input, part_s);
            judge_way(state, next);
            input.look_left_rad = input.look_up_rad = 0.0;
            seconds -= part_s;
            state = next;
        }
    }

    void judge_way(const PlayerState& from, const PlayerState& to)
    {
        const glm::dvec3 &foot = from.foot_world, &end = to.foot_world;
        if (to.put_back_count != from.put_back_count) {
            const bool fell_out =
                !oracle_.has_ground_below(foot) || oracle_.depth(foot, judged_) > options_.tolerance_m;
            if (fell_out)
                fault(&WalkCounts::put_back, "put_back", foot);
            else
                fault(&WalkCounts::thrown, "thrown", foot);
            return;
        }
        if (glm::distance(foot, end) > farthest_m(kPlayerTick_s)) fault(&WalkCounts::thrown, "thrown", foot);
        const auto normal = oracle_.crossed(foot, end, judged_);
        if (!normal) return;
        if (std::abs(normal->y) > std::sqrt(0.5))
            fault(&WalkCounts::floors_crossed, "floors_crossed", foot);
        else
            fault(&WalkCounts::walls_crossed, "walls_crossed", foot);
    }

    void judge_eye()
    {
        const glm::dvec3& foot = state_.foot_world;
        const glm::dvec3 top = foot + glm::dvec3(0.0, judged_.height_m - judged_.radius_m, 0.0);
        const glm::dvec3 eye = foot + glm::dvec3(0.0, body_.eye_m + state_.eye_offset_m, 0.0);
        if (oracle_.is_parted(top, eye) || (eye.y < foot.y && oracle_.is_parted(foot, eye)))
            fault(&WalkCounts::eyes_parted, "eyes_parted", foot);
    }

    /// From where random inputs led nowhere, every direction is tried, at a walk and with jumps.
    void judge_stillness()
    {
        still_s_ = 0.0;
        const PlayerInput gaits[] = {{.forward = 1.0},
                                     {.forward = 1.0, .wants_jump = true},
                                     {.forward = 1.0, .is_fast = true, .wants_jump = true}};
        for (const PlayerInput& gait : gaits)
            for (int direction = 0; direction < kDirections; ++direction)
                if (gets_away(gait, direction * glm::two_pi<double>() / kDirections)) return;
        fault(&WalkCounts::stuck, "stuck", state_.foot_world);
        begin_at(number_ + counts.stuck + counts.lost);
    }

    bool gets_away(const PlayerInput& input, double yaw_rad) const
    {
        PlayerState state = state_;
        state.yaw_rad = state.last_yaw_rad = yaw_rad;
        for (double time_s = 0.0; time_s < kAttempt_s; time_s += kAttemptFrame_s) {
            state = walker_(state, input, kAttemptFrame_s);
            if (glm::distance(state.foot_world, state_.foot_world) > options_.freedom_m * scale_) return true;
        }
        return false;
    }

    const WalkOracle& oracle_;
    const Walker& walker_;
    const PlayerBody& body_;
    std::span<const PlayerState> starts_;
    const WalkFuzzOptions& options_;
    std::uint32_t number_;
    WalkHands hands_;
    bool flies_;
    double scale_;
    JudgedBody judged_;
    PlayerState state_;
    glm::dvec3 anchor_{0.0};
    double still_s_ = 0.0;
};

void add(WalkCounts& sum, const WalkCounts& part)
{
    for (const auto counter : {&WalkCounts::inputs, &WalkCounts::frames, &WalkCounts::put_back, &WalkCounts::lost,
                               &WalkCounts::penetrations, &WalkCounts::walls_crossed, &WalkCounts::floors_crossed,
                               &WalkCounts::thrown, &WalkCounts::eyes_parted, &WalkCounts::stuck})
        sum.*counter += part.*counter;
    sum.walked_s += part.walked_s;
    sum.way_m += part.way_m;
    sum.worst_depth_m = std::max(sum.worst_depth_m, part.worst_depth_m);
    const std::size_t room = kMostFaults - std::min(kMostFaults, sum.faults.size());
    sum.faults.insert(sum.faults.end(), part.faults.begin(),
                      part.faults.begin() + static_cast<std::ptrdiff_t>(std::min(room, part.faults.size())));
}

}  // namespace

WalkCounts fuzz_walk(const WalkOracle& oracle, const Walker& walker, const PlayerBody& body,
                     std::span<const PlayerState> starts, const WalkFuzzOptions& options)
{
    WalkCounts sum;
    if (starts.empty()) return sum;
    std::vector<Walk> walks;
    for (std::uint32_t i = 0; i < options.walks; ++i) walks.emplace_back(oracle, walker, body, starts, options, i);
    share_work(walks.size(), options.threads, [&](std::size_t i) {
        walks[i].run(options.inputs * (i + 1) / walks.size() - options.inputs * i / walks.size());
    });
    std::unordered_set<std::uint64_t> cells;
    for (const Walk& walk : walks) {
        add(sum, walk.counts);
        cells.insert(walk.cells.begin(), walk.cells.end());
    }
    sum.cells = cells.size();
    return sum;
}

}  // namespace hw::measure
