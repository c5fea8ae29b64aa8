#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hatchway/world/level.hpp"
#include "hatchway/world/looks.hpp"

namespace hw {

/// The part of an object's look that an author changes while walking: its style, or whether it is visible, or both.
struct StyleChoice {
    std::string style;                 ///< Empty: says nothing of the style.
    std::string over = {};             ///< Empty: none.
    PresenceField presence = {};       ///< Of `over`.
    std::optional<bool> visible = {};  ///< Absent: says nothing of it.

    bool operator==(const StyleChoice& other) const;
};

/// One step of the author for one object. Undoing goes back to `before`, which says as much as `after`.
struct StyleEdit {
    ObjectId object = 0;
    StyleChoice before;
    StyleChoice after;
    bool is_with_last = false;  ///< Undone and redone together with the edit before it.
};

/// What the author did to the objects' styles, with its undo and redo. Plain data: the level that is shown and the
/// level file follow from it by rules_for().
class StyleEdits {
 public:
    /// Does `edit`; what was undone before can no longer be redone.
    void push(StyleEdit edit);
    /// The first edit of the step that was taken back or done again; nothing when there is none.
    std::optional<StyleEdit> undo();
    std::optional<StyleEdit> redo();

    /// The choices in which now differs from the last mark_saved(). What was saved and then undone is among them, with
    /// the choice that it had before.
    std::map<ObjectId, StyleChoice> unsaved() const;
    bool has_unsaved() const { return done_count_ != saved_count_ || !taken_back_.empty(); }
    void mark_saved();

    /// The model changed: objects got other numbers. Steps of objects that are gone are forgotten.
    void renumber(const std::map<ObjectId, ObjectId>& new_of_old);

 private:
    std::vector<StyleEdit> steps_;
    std::size_t done_count_ = 0;
    std::size_t saved_count_ = 0;
    std::map<ObjectId, StyleChoice> taken_back_;  ///< Of saved steps that were undone and then cut off by a new one.
};

/// All that there is to choose, as the look has it.
StyleChoice choice_of(const ObjectLook& look);

/// The style after `current` in the cycle of `names`, `step` = +1 or -1; the first when `current` is not among them.
/// `names` must not be empty.
std::string next_style(const std::vector<std::string>& names, const std::string& current, int step);

/// Rules that, appended to the level's "assign", give the objects in `wanted` what these choices say and leave all else
/// alone: first rules of styles, then of what is visible. A rule reaches children, so some of them may restate what a
/// child has. Objects that no rule can tell apart
/// (equal material names on one node) change together. Empty when the level already says so.
std::vector<AssignRule> rules_for(const Level& level, const Scene& scene, const std::string& fallback_style,
                                  const std::map<ObjectId, StyleChoice>& wanted);

/// How a rule names the node: its path where no other node has the same, else "#index". Characters with a meaning in
/// globs are escaped.
std::string node_selector(const Scene& scene, int node);

/// What stays of an object when the model is exported anew: its node's path and its material's name.
struct ObjectKey {
    std::string path;
    std::string material;

    auto operator<=>(const ObjectKey&) const = default;
};

/// One for each object of the scene.
std::vector<ObjectKey> object_keys(const Scene& scene);

/// New numbers of the objects of `before` that are in `after`, too. Equal keys match in their order.
std::map<ObjectId, ObjectId> matching_objects(const std::vector<ObjectKey>& before,
                                              const std::vector<ObjectKey>& after);

/// "Hall/Column_02" or, where a node has several primitives, "Hall/Column_02 (Plank)": for messages.
std::string object_name(const Scene& scene, ObjectId object);

}  // namespace hw
