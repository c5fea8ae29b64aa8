#include "program/pictures/walk_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <thread>
#include <utility>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/folder_handle.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/io/images/images.hpp"
#include "hatchway/render/view/camera_view.hpp"
#include "hatchway/stage/whole_scene.hpp"
#include "hatchway/world/camera_path.hpp"
#include "hatchway/world/hidden_objects.hpp"
#include "hatchway/world/looks.hpp"
#include "program/level/level_doubts.hpp"
#include "program/pictures/picture_name.hpp"
#include "program/pictures/shots.hpp"
#include "program/pictures/walk_cameras.hpp"

namespace hw {
namespace fs = std::filesystem;
namespace {

constexpr double kSoftwareFps = 30.0, kDeviceFps = 60.0;
constexpr double kFpsPull_s = 0.4;        // the rate on screen follows frames in about this time
constexpr double kKeepEvery_s = 2.0;      // changes that are not saved outlive a kill when they are older
constexpr double kAskAgain_s = 5.0;       // a question waits so long for the second press
constexpr double kSmallestWindow_px = 1;  // a minimised window has none
constexpr double kLook_s = 0.25;          // how often a walk that stands still looks for files that changed
constexpr const char* kNothingAimed = "There is nothing under the cross-hair";

double aspect_of(const Window& window)
{
    const glm::ivec2 size = window.framebuffer_size_px();
    return size.y > 0 ? static_cast<double>(size.x) / size.y : 1.0;
}

/// On white paper, before there is a picture: opening a level may take seconds.
void show_opening(Window& window, const std::filesystem::path& file)
{
    window.set_title(file.filename().string() + " - Hatchway");
    Renderer(window).present({.texts = {{.text = "Opening " + file.filename().string()}}}, window.content_scale());
    window.swap();
    window.poll();
}

bool wants_to_move(const PlayerInput& input)
{
    return input.forward != 0.0 || input.right != 0.0 || input.up != 0.0 || input.turn_left != 0.0 ||
           input.turn_up != 0.0 || input.look_left_rad != 0.0 || input.look_up_rad != 0.0;
}

}  // namespace

WalkSession::WalkSession(Window& window, WalkOptions options) : window_(window), options_(std::move(options))
{
    const double usual_fps = window.device().is_software ? kSoftwareFps : kDeviceFps;
    goal_.target_fps = options_.target_fps > 0.0 ? options_.target_fps : usual_fps;
    show_opening(window_, options_.level.file);
    open(stage_options(options_.level, CompiledUse::in_background));
    warn_of_idle_styles(stage_->level(), stage_->scene(), options_.level.styles.size());
    Camera first = start_camera(stage_->level(), stage_->scene(), aspect_of(window));
    if (!options_.camera.empty())
        first = camera_named(options_.camera, stage_->level(), stage_->scene(), "no --camera: this level has none");
    place(first);
}

void WalkSession::open(const StageOptions& stage_options)
{
    stage_ = std::make_unique<Stage>(window_, stage_options);
    styles_ = std::make_unique<WalkStyles>(*stage_);
    autosave_.reset();  // its number is free again
    autosave_.emplace(stage_->level().file);
    tell_result([this] {
        const std::string left = autosave_->left();
        return left.empty() ? std::string() : styles_->offer(left);
    });
    build_worlds();
    window_.set_title(stage_->level().file.filename().string() + " - Hatchway");
}

void WalkSession::build_worlds()
{
    pick_world_ = build_pick_world(stage_->scene());
    hidden_ = hidden_objects(stage_->scene());
    leaks_ = options_.show.has_leaks ? told_leaks(stage_->level(), stage_->scene()).leaks : std::vector<Leak>();
    collides_.clear();
    build_own_collision();
    body_ = body_for(stage_->world().places.main_world, is_level_file(stage_->level().file));
}

void WalkSession::build_own_collision()
{
    std::vector<char> collides;
    for (const ObjectLook& look : stage_->looks()) collides.push_back(look.collides);
    if (collides == collides_) return;
    collides_ = std::move(collides);
    own_collision_.reset();
    if (std::find(collides_.begin(), collides_.end(), 0) != collides_.end())
        own_collision_ = build_collision_world(stage_->scene(), stage_->looks());
}

/// What is hidden neither is picked nor stops a walker.
void WalkSession::follow_hidden()
{
    if (hidden_objects(stage_->scene()) != hidden_) build_worlds();
}

void WalkSession::place(const Camera& camera)
{
    player_ = placed_at(camera, body_, collision());
    fov_deg_ = camera.fov_deg;
    const bool is_no_walkers = camera.orthographic_height_m || camera.roll_deg != 0.0;
    shown_as_is_ = is_no_walkers ? std::optional(camera) : std::nullopt;
    playing_.reset();
}

void WalkSession::run()
{
    start_ = Clock::now();  // a style's time does not pass while a level is opened
    while (!window_.should_close()) frame();
    if (styles_->has_unsaved())
        log_warning(std::string("closed with style changes that were not saved") +
                    (is_discarded_ ? "" : ": the next walk offers them"));
    tell_result([this] { autosave_->keep(is_discarded_ ? std::string() : styles_->unsaved_text()); });
}

void WalkSession::frame()
{
    const bool is_minimised = glm::any(glm::lessThan(window_.framebuffer_size_px(), glm::ivec2(kSmallestWindow_px)));
    if (is_minimised || stillness_.work == FrameWork::nothing) {
        window_.wait(kLook_s);
        last_frame_s_ = now_s();  // the walker stood still meanwhile
    }
    const double now = now_s();
    const double seconds = std::exchange(last_frame_s_, now);
    tell_result([&] { take_input(now - seconds); });
    keep_unsaved();
    reload();
    if (is_minimised) return;
    has_changed_ |= stats_.changes_with_time || !are_alike(camera(), shown_camera_);
    stillness_ = after_moment(stillness_, std::exchange(has_changed_, false), now);
    tell_result([this] { draw(); });
    if (stillness_.work == FrameWork::nothing) return;
    // A software renderer has no display to wait for, and would take the whole machine.
    const double spare_s = now + 1.0 / kDeviceFps - now_s();
    if (window_.device().is_software && spare_s > 0.0)
        std::this_thread::sleep_for(std::chrono::duration<double>(spare_s));
    const double frame_s = std::max(now_s() - now, 1e-4);
    frame_s_ = std::lerp(frame_s_, frame_s, 1.0 - std::exp(-frame_s / kFpsPull_s));
}

void WalkSession::take_input(double seconds)
{
    controls_.is_path_playing = playing_.has_value();
    const InputEvents events = window_.poll();
    const Controls controls = controls_after(controls_, events);
    controls_ = controls.state;
    has_changed_ |= !events.keys.empty() || events.needs_redraw || wants_to_move(controls.player) || playing_;
    for (const CommandCall& call : controls.commands) obey(call);
    follow_hidden();
    if (playing_ && wants_to_move(controls.player)) place(camera());
    if (shown_as_is_ && wants_to_move(controls.player)) {
        tell(shown_as_is_->orthographic_height_m ? "Walking shows perspective: the camera's parallel view is left"
                                                 : "Walking is upright: the camera's turned view is left");
        shown_as_is_.reset();
    }
    if (!playing_) move(controls.player, seconds);
    if (playing_ && now_s() - playing_->since_s > playing_->path.keys.back().t_s - playing_->path.keys.front().t_s)
        place(camera());
}

void WalkSession::move(const PlayerInput& input, double seconds)
{
    const PlayerState before = player_;
    player_ = step(player_, input, body_, collision(), seconds);
    if (player_.put_back_count != before.put_back_count) tell("You were caught in a wall: back where you stood last");
    if (player_.is_flying && !before.is_flying) tell("There is nothing below to stand on: you go on flying");
}

void WalkSession::obey(const CommandCall& call)
{
    are_changes_kept_ = false;
    const auto cycle = [this](int direction) -> std::string {
        const auto object = aimed_object();
        return object ? styles_->cycle(*object, direction) : kNothingAimed;
    };
    const auto hide_aimed = [this]() -> std::string {
        const auto object = aimed_object();
        return object ? styles_->hide(*object) : kNothingAimed;
    };
    switch (call.command) {
        case Command::quit:
            return quit();
        case Command::capture_mouse:
            return window_.capture_cursor(true);
        case Command::release_mouse:
            return window_.capture_cursor(false);
        case Command::toggle_flight:
            player_ = with_flight_toggled(player_, body_);
            return;
        case Command::go_to_camera:
            return go_to_camera(call.number);
        case Command::next_style:
            return tell_result([&] { return cycle(1); });
        case Command::previous_style:
            return tell_result([&] { return cycle(-1); });
        case Command::hide:
            return tell_result([&] { return hide_aimed(); });
        case Command::show_all:
            return tell_result([this] { return styles_->show_all(); });
        case Command::save_level:
            return tell_result([this] { return save_level(); });
        case Command::undo:
            return tell_result([this] { return styles_->undo(); });
        case Command::redo:
            return tell_result([this] { return styles_->redo(); });
        case Command::save_picture:
            return tell_result([this] { return save_picture(); });
        case Command::toggle_help:
            is_help_shown_ = !is_help_shown_;
            return;
        case Command::toggle_statistics:
            are_statistics_shown_ = !are_statistics_shown_;
            return;
        case Command::toggle_full_screen:
            return window_.set_full_screen(!window_.is_full_screen());
        case Command::play_path:
            return play_path();
        case Command::stop_path:
            return place(camera());
    }
}

void WalkSession::go_to_camera(int number)
{
    if (number == 0) return place(start_camera(stage_->level(), stage_->scene(), aspect_of(window_)));
    const std::vector<Camera> cameras = walk_cameras(stage_->level(), stage_->scene());
    const auto index = static_cast<std::size_t>(number - 1);
    if (index >= cameras.size())
        return tell(cameras.empty() ? "This level has no cameras" : fmt::format("There is no camera {}", number));
    place(cameras[index]);
    tell(cameras[index].name);
}

void WalkSession::play_path()
{
    if (playing_) return place(camera());
    const std::vector<CameraPath>& paths = stage_->level().paths;
    Playing playing{.path = turntable(stage_->scene(), aspect_of(window_)), .since_s = now_s()};
    const CameraPath* tour = find_named(paths, kTour);
    if (!paths.empty()) playing.path = tour ? *tour : paths.front();
    playing_ = std::move(playing);
}

void WalkSession::quit()
{
    is_discarded_ = styles_->has_unsaved() && now_s() < quit_asked_until_s_;
    if (!styles_->has_unsaved() || is_discarded_) return window_.close();
    quit_asked_until_s_ = now_s() + kAskAgain_s;
    tell("The level was changed: Ctrl+S saves them, the same key again quits without", kAskAgain_s);
}

std::string WalkSession::save_level()
{
    if (is_level_file(stage_->level().file)) return styles_->save();
    const fs::path level_file = level_file_for(stage_->level().file);
    if (now_s() > save_asked_until_s_) {
        save_asked_until_s_ = now_s() + kAskAgain_s;
        return "This is a bare model without a level file. Ctrl+S again writes " + level_file.string();
    }
    const Camera now = camera();
    const std::string message = styles_->save_as(level_file, {now.eye_world, now.target_world}, options_.level.styles);
    autosave_->keep(styles_->unsaved_text());
    options_.level.file = level_file;
    options_.level.styles.clear();
    const PlayerState kept = player_;
    open(stage_options(options_.level, CompiledUse::in_background));
    player_ = kept;
    return message;
}

std::string WalkSession::save_picture()
{
    // As it stands on the screen, at the window's full size and without words over it.
    const glm::ivec2 size_px = glm::max(window_.framebuffer_size_px(), glm::ivec2(1));
    stage_->draw(view(size_px, window_.content_scale()),
                 {.samples = options_.samples.value_or(4), .use_pvs = !options_.level.without_pvs});
    const fs::path folder = stage_->level().file.parent_path();
    const FolderLock lock{FolderHandle(folder)};
    const fs::path file = free_picture_name(folder, stage_->level().file);
    write_png(file, stage_->renderer().read_picture());
    std::error_code unknown;
    const std::string where = fs::absolute(file, unknown).string();
    log_info(where + ": the same view is " + camera_arguments(camera()));
    return "Saved " + (where.empty() ? file.string() : where);
}

void WalkSession::reload()
{
    tell_result([this] {
        const Reload changed = stage_->reload_changed();
        if (changed == Reload::nothing) return;
        has_changed_ = true;
        if (changed == Reload::world) build_worlds();
        follow_hidden();
        build_own_collision();
        if (changed == Reload::world) player_ = in_world(player_, body_, collision());
        styles_->stage_changed();
        are_changes_kept_ = false;
    });
}

void WalkSession::keep_unsaved()
{
    if (are_changes_kept_ || now_s() < keep_next_s_) return;
    keep_next_s_ = now_s() + kKeepEvery_s;
    tell_result([this] {
        autosave_->keep(styles_->unsaved_text());
        are_changes_kept_ = true;
    });
}

void WalkSession::draw()
{
    const FrameWork work = stillness_.work;
    const double before_s = now_s();
    if (work == FrameWork::paced)
        draw_picture(options_.samples ? FrameQuality{*options_.samples} : quality_of(pacing_));
    if (work == FrameWork::sharp) draw_picture({.samples = options_.samples.value_or(FrameQuality().samples)});
    const Overlay overlay = overlay_now();
    if (work == FrameWork::nothing && overlay == overlay_) return;
    overlay_ = overlay;
    stage_->renderer().present(overlay_, window_.content_scale());
    if (work == FrameWork::paced) pacing_ = after_frame(pacing_, goal_, 1000.0 * (now_s() - before_s));
    window_.swap();
}

void WalkSession::draw_picture(const FrameQuality& quality)
{
    const glm::vec2 window_size(window_.framebuffer_size_px());
    const glm::ivec2 size = glm::max(glm::ivec2(glm::round(window_size * quality.render_scale)), glm::ivec2(1));
    const View now = view(size, window_.content_scale() * quality.render_scale);
    quality_ = quality;
    shown_camera_ = camera();
    stats_ = stage_->draw(now, {.samples = quality.samples, .use_pvs = !options_.level.without_pvs, .is_timed = true});
}

Overlay WalkSession::overlay_now()
{
    const float content_scale = window_.content_scale();
    const glm::vec2 window_size = glm::vec2(window_.framebuffer_size_px()) / content_scale;
    Overlay overlay = walk_overlay(facts(aimed_object(), window_size.x));
    const View now = view(glm::max(window_.framebuffer_size_px(), glm::ivec2(1)), content_scale);
    overlay.lines = shown_lines(*stage_, options_.show, leaks_, now, window_size);
    return overlay;
}

double WalkSession::now_s() const
{
    return std::chrono::duration<double>(Clock::now() - start_).count();
}

Camera WalkSession::camera() const
{
    if (playing_) return camera_at(playing_->path, view_time_s());
    return shown_as_is_ ? *shown_as_is_ : camera_of(player_, body_, fov_deg_);
}

double WalkSession::view_time_s() const
{
    return playing_ ? playing_->path.keys.front().t_s + last_frame_s_ - playing_->since_s : last_frame_s_;
}

View WalkSession::view(glm::ivec2 size_px, float px_scale) const
{
    const Camera now = camera();
    View view = camera_view(camera_place(now), size_px, stage_->world().places.boxes_world, px_scale);
    view.time_s = view_time_s();
    return view;
}

std::optional<ObjectId> WalkSession::aimed_object() const
{
    const Camera now = camera();
    const auto hit = pick(pick_world_, now.eye_world, glm::normalize(now.target_world - now.eye_world));
    return hit ? std::optional(hit->object) : std::nullopt;
}

WalkFacts WalkSession::facts(const std::optional<ObjectId>& aimed, float width)
{
    std::erase_if(notices_, [this](const Notice& notice) { return notice.until_s < now_s(); });
    WalkFacts facts{.is_mouse_captured = controls_.is_mouse_captured,
                    .is_flying = player_.is_flying,
                    .is_playing_path = playing_.has_value(),
                    .is_help_shown = is_help_shown_,
                    .are_statistics_shown = are_statistics_shown_,
                    .has_unsaved = styles_->has_unsaved(),
                    .fps = 1.0 / frame_s_,
                    .quality = describe(quality_),
                    .stats = stats_,
                    .problems = stage_->messages(),
                    .activity = stage_->activity(),
                    .width = width};
    if (aimed) {
        const ObjectLook& look = stage_->looks()[*aimed];
        facts.object = object_name(stage_->scene(), *aimed);
        facts.certainty = look.certainty;
        facts.style = look.over.empty() ? look.style : look.style + " under " + look.over;
    }
    for (const Notice& notice : notices_) facts.notices.push_back(notice.text);
    if (is_help_shown_)
        for (const Camera& each : walk_cameras(stage_->level(), stage_->scene())) facts.cameras.push_back(each.name);
    return facts;
}

void WalkSession::tell(const std::string& text, double seconds)
{
    std::erase_if(notices_, [&](const Notice& notice) { return notice.text == text; });
    if (!text.empty()) notices_.push_back({text, now_s() + seconds});
}

template <typename Action>
void WalkSession::tell_result(Action action)
{
    try {
        if constexpr (std::is_void_v<decltype(action())>)
            action();
        else
            tell(action());
    } catch (const std::exception& error) {
        // Nothing ends a walk but the walker. What fails at every frame is written once.
        const std::string text = error.what();
        const bool is_told = std::ranges::any_of(notices_, [&](const Notice& notice) { return notice.text == text; });
        if (!is_told) log_error(text);
        tell(text, 2.0 * kAskAgain_s);
    }
}

}  // namespace hw
