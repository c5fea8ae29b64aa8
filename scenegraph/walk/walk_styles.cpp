#include "hatchway/walk/walk_styles.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/files/folder_handle.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/io/json/out.hpp"
#include "hatchway/io/level/edit.hpp"
#include "hatchway/io/level/file.hpp"
#include "hatchway/world/hidden_objects.hpp"

namespace hw {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMaxNameBytes = 255;  // of Linux's file systems

std::vector<StyleAssignment> assignments_of(const std::vector<AssignRule>& rules)
{
    std::vector<StyleAssignment> assignments;
    for (const AssignRule& rule : rules)
        assignments.push_back({.nodes = rule.nodes,
                               .style = rule.style.value_or(""),
                               .materials = rule.materials,
                               .over = rule.over.value_or(""),
                               .presence = rule.presence.value_or(PresenceField{}),
                               .visible = rule.visible});
    return assignments;
}

JsonValue place(const glm::dvec3& p)
{
    return JsonValue::array().push(p.x).push(p.y).push(p.z);
}

JsonValue first_assignments(const std::vector<std::string>& style_overrides)
{
    JsonValue assign = JsonValue::array();
    for (const std::string& override_text : style_overrides) {
        const std::size_t equals = override_text.rfind('=');
        assign.push(JsonValue::object()
                        .set("nodes", override_text.substr(0, equals))
                        .set("style", override_text.substr(equals + 1)));
    }
    return assign;
}

/// The text of a level file; empty for a bare model, and while an editor replaces the file.
std::string text_of(const Level& level)
{
    try {
        return is_level_file(level.file) ? read_text_file(level.file, limits::kMaxLevelFileBytes) : "";
    } catch (const Error&) {
        return {};
    }
}

JsonValue level_json(const fs::path& scene)
{
    JsonValue level = JsonValue::object();
    level.set("format", "hatchway-level/1").set("scene", scene.string());
    return level;
}

}  // namespace

WalkStyles::WalkStyles(Stage& stage)
    : stage_(stage), keys_(object_keys(stage.scene())), known_text_(text_of(stage.level()))
{
}

std::string WalkStyles::unsaved_text() const
{
    if (!edits_.has_unsaved() && offered_.empty()) return {};
    const Level& level = stage_.level();
    std::vector<AssignRule> rules = offered_;
    for (AssignRule& rule : rules_for(level, stage_.scene(), kFallbackStyle, edits_.unsaved()))
        rules.push_back(std::move(rule));
    if (rules.empty()) return {};
    std::error_code failed;
    const fs::path scene = fs::relative(level.scene_file, fs::absolute(level.file, failed).parent_path(), failed);
    return with_assignments(level_json(scene).text(), assignments_of(rules), level.file);
}

std::string WalkStyles::offer(const std::string& unsaved_text)
{
    offered_ = parse_level(unsaved_text, stage_.level().file).assign;
    return offered_.empty() ? "" : "Style changes of an earlier walk were not saved: Ctrl+Y brings them back";
}

std::string WalkStyles::take_up_offer()
{
    // Objects that no offered rule reaches keep this name, which no style can have.
    constexpr const char* kUntouched = "\n";
    Level level = stage_.level();
    level.assign = {{.nodes = "*", .style = kUntouched}};
    level.assign.insert(level.assign.end(), offered_.begin(), offered_.end());
    const std::vector<ObjectLook> looks = resolve_looks(level, stage_.scene(), kFallbackStyle);
    StyleEdits next = edits_;
    for (ObjectId id = 0; id < looks.size(); ++id) {
        const StyleChoice before = choice_of(stage_.looks()[id]);
        StyleChoice after = choice_of(looks[id]);
        if (looks[id].style == kUntouched)
            after.style = before.style, after.over = before.over, after.presence = before.presence;
        if (looks[id].visible_pointer.empty()) after.visible = before.visible;
        if (!(after == before)) next.push({id, before, after});
    }
    const std::string message = adopt(std::move(next), "The changes of the earlier walk are back, and unsaved");
    offered_.clear();
    return message;
}

std::string WalkStyles::cycle(ObjectId object, int step)
{
    const std::vector<std::string> names = stage_.style_names();
    if (names.empty()) return "There is no style to change to";
    StyleChoice before = choice_of(stage_.looks()[object]);
    before.visible.reset();
    const StyleEdit edit{object, before, {.style = next_style(names, before.style, step)}};
    StyleEdits next = edits_;
    next.push(edit);
    return adopt(std::move(next), told("", edit, edit.after));
}

std::string WalkStyles::hide(ObjectId object)
{
    const StyleEdit edit{object, {.style = "", .visible = true}, {.style = "", .visible = false}};
    StyleEdits next = edits_;
    next.push(edit);
    return adopt(std::move(next), told("", edit, edit.after) + "   Alt+H shows all");
}

std::string WalkStyles::show_all()
{
    StyleEdits next = edits_;
    const std::vector<ObjectId> hidden = hidden_objects(stage_.scene());
    for (const ObjectId object : hidden)
        next.push({.object = object,
                   .before = {.style = "", .visible = false},
                   .after = {.style = "", .visible = true},
                   .is_with_last = object != hidden.front()});
    if (hidden.empty()) return "Nothing is hidden";
    return adopt(std::move(next),
                 fmt::format("{} object{} shown again", hidden.size(), hidden.size() == 1 ? " is" : "s are"));
}

std::string WalkStyles::undo()
{
    StyleEdits next = edits_;
    const auto edit = next.undo();
    return edit ? adopt(std::move(next), told("Undone. ", *edit, edit->before)) : "Nothing to undo";
}

std::string WalkStyles::redo()
{
    StyleEdits next = edits_;
    const auto edit = next.redo();
    if (!edit && !offered_.empty()) return take_up_offer();
    return edit ? adopt(std::move(next), told("Redone. ", *edit, edit->after)) : "Nothing to redo";
}

std::string WalkStyles::save()
{
    // The file may have changed since the stage read it, and holds no styles of the command line.
    const fs::path file = stage_.level().file;
    const LevelTexts texts = edit_level_file(file, [this](const Level& level) {
        return assignments_of(rules_for(level, stage_.scene(), kFallbackStyle, edits_.unsaved()));
    });
    const bool is_shared = texts.before != known_text_;
    known_text_ = texts.after;
    edits_.mark_saved();
    if (texts.after == texts.before) return "Nothing to save";
    return "Saved into " + file.filename().string() +
           (is_shared ? "; it had been changed elsewhere: both changes are in it" : "");
}

std::string WalkStyles::save_as(const fs::path& level_file, const StartPlace& start,
                                const std::vector<std::string>& style_overrides)
{
    const FolderHandle folder(level_file.parent_path());
    const FolderLock lock(folder);
    std::error_code missing;
    if (fs::exists(fs::symlink_status(level_file, missing)))
        throw Error({.what = "is there already", .file = level_file.string(), .expected = "to be opened instead"});
    JsonValue level = level_json(stage_.level().scene_file.filename());
    level.set("start", JsonValue::object().set("position", place(start.position)).set("look_at", place(start.look_at)));
    level.set("assign", first_assignments(style_overrides));
    const Level plain = parse_level(level.text(), level_file);
    const auto rules = rules_for(plain, stage_.scene(), kFallbackStyle, edits_.unsaved());
    const std::string text = with_assignments(level.text(), assignments_of(rules), level_file);
    folder.write(level_file.filename().string(), std::as_bytes(std::span(text)));
    edits_.mark_saved();
    return "Saved as " + level_file.string();
}

void WalkStyles::stage_changed()
{
    StyleEdits next = edits_;
    std::vector<ObjectKey> keys = object_keys(stage_.scene());
    if (keys != keys_) next.renumber(matching_objects(keys_, keys));
    keys_ = std::move(keys);
    known_text_ = text_of(stage_.level());
    adopt(std::move(next), "");
}

std::string WalkStyles::adopt(StyleEdits next, const std::string& message)
{
    const auto rules = rules_for(stage_.level(), stage_.scene(), kFallbackStyle, next.unsaved());
    if (!rules.empty() || has_extra_rules_) stage_.set_extra_rules(rules);
    has_extra_rules_ = !rules.empty();
    edits_ = std::move(next);
    return message;
}

std::string WalkStyles::told(const std::string& before, const StyleEdit& edit, const StyleChoice& choice) const
{
    const std::string what = before + object_name(stage_.scene(), edit.object) + " is ";
    if (choice.style.empty()) return what + (choice.visible.value_or(true) ? "shown" : "hidden");
    const std::string over = choice.over.empty() ? "" : " under " + choice.over;
    return what + choice.style + over + fmt::format(", certainty {:.3g}", stage_.looks()[edit.object].certainty);
}

fs::path level_file_for(const fs::path& model)
{
    const std::string ending = ".level.json";
    std::string name = model.stem().string();
    std::size_t size = std::min(name.size(), kMaxNameBytes - ending.size());
    const auto is_inside_character = [&] { return (static_cast<unsigned char>(name[size]) & 0xc0) == 0x80; };  // UTF-8
    while (size > 0 && size < name.size() && is_inside_character()) --size;
    return model.parent_path() / (name.substr(0, size) + ending);
}

bool is_level_file(const fs::path& file)
{
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".json";
}

}  // namespace hw
