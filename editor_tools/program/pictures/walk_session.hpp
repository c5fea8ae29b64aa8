#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hatchway/gl/window.hpp"
#include "hatchway/stage/stage.hpp"
#include "hatchway/walk/autosave.hpp"
#include "hatchway/walk/controls.hpp"
#include "hatchway/walk/frame_pacing.hpp"
#include "hatchway/walk/pick.hpp"
#include "hatchway/walk/player.hpp"
#include "hatchway/walk/stillness.hpp"
#include "hatchway/walk/walk_overlay.hpp"
#include "hatchway/walk/walk_styles.hpp"
#include "program/arguments.hpp"
#include "program/pictures/world_shown.hpp"

namespace hw {

struct WalkOptions {
    LevelArguments level;
    std::string camera;          ///< Where to start; empty: the level's start.
    double target_fps = 0.0;     ///< 0: 30 on a software renderer, else 60.
    std::optional<int> samples;  ///< Fixed; else they follow from the frame rate.
    ShowArguments show;
};

/// A walk through a level in a window, until the window closes.
class WalkSession {
 public:
    /// Opens the level. Throws hw::Error.
    WalkSession(Window& window, WalkOptions options);

    /// Draws frames until the walker quits.
    void run();

 private:
    using Clock = std::chrono::steady_clock;

    /// Something to tell for a few seconds.
    struct Notice {
        std::string text;
        double until_s = 0.0;
    };
    struct Playing {
        CameraPath path;
        double since_s = 0.0;
    };

    void open(const StageOptions& stage_options);
    void build_worlds();
    void build_own_collision();
    void follow_hidden();
    const CollisionWorld& collision() const { return own_collision_ ? *own_collision_ : pick_world_.still; }
    void place(const Camera& camera);

    void frame();
    void take_input(double seconds);
    void move(const PlayerInput& input, double seconds);
    void obey(const CommandCall& call);
    void go_to_camera(int number);
    void play_path();
    void quit();
    std::string save_level();
    std::string save_picture();
    void reload();
    void keep_unsaved();
    /// What stillness asks for, and the words over it.
    void draw();
    void draw_picture(const FrameQuality& quality);
    Overlay overlay_now();

    double now_s() const;
    Camera camera() const;
    double view_time_s() const;
    View view(glm::ivec2 size_px, float px_scale) const;
    std::optional<ObjectId> aimed_object() const;
    WalkFacts facts(const std::optional<ObjectId>& aimed, float width);
    void tell(const std::string& text, double seconds = 4.0);
    /// Runs `action` and tells what it returns, or what it threw.
    template <typename Action>
    void tell_result(Action action);

    Window& window_;
    WalkOptions options_;
    std::unique_ptr<Stage> stage_;
    std::unique_ptr<WalkStyles> styles_;
    std::optional<Autosave> autosave_;
    std::vector<Leak> leaks_;  ///< Where they are to be shown.
    PickWorld pick_world_;
    std::vector<ObjectId> hidden_;                 ///< As `pick_world_` was built.
    std::optional<CollisionWorld> own_collision_;  ///< Where some objects do not collide; else what is picked.
    std::vector<char> collides_;                   ///< For each object, as `own_collision_` was built.
    PlayerBody body_;
    PlayerState player_;
    double fov_deg_ = 60.0;
    std::optional<Camera> shown_as_is_;  ///< A camera that no walker has, parallel or rolled; until he moves.
    ControlState controls_;
    std::optional<Playing> playing_;

    PacingState pacing_;
    PacingGoal goal_;
    Stillness stillness_;
    bool has_changed_ = true;  ///< What the picture shows, since the last frame.
    // Of the picture that was drawn last.
    FrameQuality quality_;
    FrameStats stats_;
    Camera shown_camera_;
    Overlay overlay_;  ///< Over it in the window.

    double frame_s_ = 1.0 / 60.0;  ///< A mean of late, for the rate on screen.
    Clock::time_point start_ = Clock::now();
    double last_frame_s_ = 0.0;

    std::vector<Notice> notices_;
    bool is_help_shown_ = false;
    bool are_statistics_shown_ = false;
    double quit_asked_until_s_ = -1.0;
    double save_asked_until_s_ = -1.0;
    double keep_next_s_ = 0.0;
    bool are_changes_kept_ = false;  ///< The autosave has what the styles have.
    bool is_discarded_ = false;      ///< The walker said to quit without saving.
};

}  // namespace hw
