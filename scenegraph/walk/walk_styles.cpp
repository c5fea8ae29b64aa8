#include "hatchway/walk/walk_styles.hpp"

#include <algorithm>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files.hpp"
#include "hatchway/io/json/out.hpp"
#include "hatchway/io/level/edit.hpp"
#include "hatchway/io/level/file.hpp"

namespace hw {
namespace fs = std::filesystem;
namespace {

std::vector<StyleAssignment> assignments_of(const std::vector<AssignRule>& rules)
{
    std::vector<StyleAssignment> assignments;
    for (const AssignRule& rule : rules)
        assignments.push_back({.nodes = rule.nodes,
                               .style = rule.style.value_or(""),
                               .materials = rule.materials,
                               .over = rule.over.value_or(""),
                               .presence = rule.presence.value_or(PresenceField{})});
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

}  // namespace

std::string WalkStyles::cycle(ObjectId object, int step)
{
    const std::vector<std::string> names = stage_.style_names();
    if (names.empty()) return "There is no style to change to";
    const StyleChoice before = choice_of(stage_.looks()[object]);
    const StyleEdit edit{object, before, {.style = next_style(names, before.style, step)}};
    StyleEdits next = edits_;
    next.push(edit);
    return adopt(std::move(next), told("", edit, edit.after));
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
    return edit ? adopt(std::move(next), told("Redone. ", *edit, edit->after)) : "Nothing to redo";
}

std::string WalkStyles::save()
{
    // The file may have changed since the stage read it, and holds no styles of the command line.
    const fs::path file = stage_.level().file;
    const Level level = read_level(file);
    const auto rules = rules_for(level, stage_.scene(), kFallbackStyle, edits_.unsaved());
    if (!rules.empty()) write_assignments(file, assignments_of(rules));
    edits_.mark_saved();
    return rules.empty() ? "Nothing to save" : "Saved into " + file.filename().string();
}

std::string WalkStyles::save_as(const fs::path& level_file, const StartPlace& start,
                                const std::vector<std::string>& style_overrides)
{
    if (fs::exists(level_file))
        throw Error({.what = "is there already", .file = level_file.string(), .expected = "to be opened instead"});
    JsonValue level = JsonValue::object();
    level.set("format", "hatchway-level/1").set("scene", stage_.level().scene_file.filename().string());
    level.set("start", JsonValue::object().set("position", place(start.position)).set("look_at", place(start.look_at)));
    level.set("assign", first_assignments(style_overrides));
    const Level plain = parse_level(level.text(), level_file);
    const auto rules = rules_for(plain, stage_.scene(), kFallbackStyle, edits_.unsaved());
    write_file_atomically(level_file, with_assignments(level.text(), assignments_of(rules), level_file));
    edits_.mark_saved();
    return "Saved as " + level_file.string();
}

void WalkStyles::stage_changed()
{
    StyleEdits next = edits_;
    std::vector<ObjectKey> keys = object_keys(stage_.scene());
    if (keys != keys_) next.renumber(matching_objects(keys_, keys));
    keys_ = std::move(keys);
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
    const std::string over = choice.over.empty() ? "" : " under " + choice.over;
    return before + object_name(stage_.scene(), edit.object) + " is " + choice.style + over;
}

fs::path level_file_for(const fs::path& model)
{
    fs::path file = model;
    return file.replace_extension(".level.json");
}

bool is_level_file(const fs::path& file)
{
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".json";
}

}  // namespace hw
