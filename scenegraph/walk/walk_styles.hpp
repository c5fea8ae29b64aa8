#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "hatchway/stage/stage.hpp"
#include "hatchway/walk/style_edits.hpp"

namespace hw {

/// The author's hand on a stage: styles of objects are tried out, taken back, and saved into the level file. Each call
/// returns what to tell the author, and throws hw::Error when a style does not work: all is then as before.
class WalkStyles {
 public:
    /// `stage` must outlive this, and be told of by stage_changed() when it reloaded.
    explicit WalkStyles(Stage& stage);

    std::string cycle(ObjectId object, int step);
    /// Hides an object and what no rule can tell from it; shows everything again that is hidden, as one step.
    std::string hide(ObjectId object);
    std::string show_all();
    std::string undo();
    std::string redo();

    bool has_unsaved() const { return edits_.has_unsaved(); }

    /// What is unsaved, as text for offer(); empty when nothing is. An offer that was not taken up is part of it.
    std::string unsaved_text() const;

    /// Offers what a walk before left as unsaved_text(): redo() takes it up once nothing else is to be redone. Throws
    /// hw::Error for a text that does not fit.
    std::string offer(const std::string& unsaved_text);

    /// Writes what is unsaved into the level file's "assign". What others saved there meanwhile stays, and is told.
    /// Throws hw::Error; the file is then as it was.
    std::string save();

    /// Writes a level file for a stage that shows a bare model: its looks as they are shown, and the start. Throws
    /// hw::Error when that file exists or cannot be written.
    std::string save_as(const std::filesystem::path& level_file, const StartPlace& start,
                        const std::vector<std::string>& style_overrides);

    /// After a reload of the stage: unsaved edits are put on top of what the files say now.
    void stage_changed();

 private:
    /// Shows the level with these edits, and only then holds on to them. Returns `message`.
    std::string adopt(StyleEdits next, const std::string& message);
    std::string told(const std::string& before, const StyleEdit& edit, const StyleChoice& choice) const;
    std::string take_up_offer();

    Stage& stage_;
    std::vector<ObjectKey> keys_;  ///< Of the scene that `edits_` count in.
    StyleEdits edits_;
    bool has_extra_rules_ = false;
    std::vector<AssignRule> offered_;  ///< Of a walk before, not taken up yet.
    std::string known_text_;           ///< Of the level file, when the stage read it or this wrote it.
};

/// Where a bare model's level file would stand: "teapot.glb" gives "teapot.level.json" beside it. A name that would be
/// too long for a file system loses its end.
std::filesystem::path level_file_for(const std::filesystem::path& model);

/// Whether `file` is a level file and not a bare model.
bool is_level_file(const std::filesystem::path& file);

}  // namespace hw
