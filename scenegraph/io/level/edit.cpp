#include "hatchway/io/level/edit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/files/folder_handle.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/io/json/places.hpp"
#include "hatchway/io/json/text.hpp"
#include "hatchway/io/level/file.hpp"

namespace hw {
namespace {

using nlohmann::json;

constexpr std::size_t kFallbackIndent = 4;
constexpr int kMostTries = 20;

std::string quoted(const std::string& text)
{
    return json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string presence_text(const PresenceField& field)
{
    std::string text = fmt::format("{{\"constant\": {}", field.constant);
    if (field.height)
        text += fmt::format(", \"height\": {{\"from_m\": {}, \"to_m\": {}}}", field.height->from, field.height->to);
    if (field.time)
        text += fmt::format(", \"time\": {{\"from_s\": {}, \"to_s\": {}}}", field.time->from, field.time->to);
    return text + '}';
}

std::string entry_text(const StyleAssignment& assignment)
{
    std::string text = "{\"nodes\": " + quoted(assignment.nodes);
    if (!assignment.materials.empty()) text += ", \"materials\": " + quoted(assignment.materials);
    if (!assignment.style.empty()) text += ", \"style\": " + quoted(assignment.style);
    if (!assignment.over.empty())
        text += ", \"over\": " + quoted(assignment.over) + ", \"presence\": " + presence_text(assignment.presence);
    if (assignment.visible) text += fmt::format(", \"visible\": {}", *assignment.visible);
    return text + '}';
}

/// Whether an entry says nothing but what a later entry for the same nodes and materials says anew.
bool is_superseded(const json& entry, const StyleAssignment& assignment)
{
    for (const auto& [key, value] : entry.items()) {
        const bool is_of_style = key == "style" || key == "over" || key == "presence";
        const bool is_said_anew = is_of_style ? !assignment.style.empty() : key == "visible" && assignment.visible;
        if (key != "nodes" && key != "materials" && !is_said_anew) return false;
    }
    return entry.value("nodes", "") == assignment.nodes && entry.value("materials", "") == assignment.materials &&
           (entry.contains("style") || entry.contains("visible")) &&
           (!entry.contains("presence") || entry.contains("over"));
}

/// Removes an element of a list with the line that it stands on, if nothing else stands there.
void remove_line(std::string& text, const JsonPlace& element)
{
    const std::size_t line_start = text.rfind('\n', element.begin) + 1;  // npos + 1 is 0
    const std::size_t line_end = std::min(text.find('\n', element.end), text.size());
    const bool is_alone_before = text.find_first_not_of(" \t", line_start) == element.begin;
    const std::size_t rest = text.find_first_not_of(" \t\r", element.end);
    const bool has_comma = rest < line_end && text[rest] == ',';
    const bool is_alone_after = has_comma && text.find_first_not_of(" \t\r", rest + 1) >= line_end;
    if (is_alone_before && is_alone_after) text.erase(line_start, line_end + 1 - line_start);
}

/// Takes out the entries that `assignment` makes pointless. What shares its line with a comment or another entry stays,
/// and so does the last entry, which later loses to the one put after it: neither does harm.
void remove_superseded(std::string& text, const StyleAssignment& assignment)
{
    const std::optional<JsonPlace> list = member_place(text, "assign");
    if (!list) return;
    const std::vector<JsonPlace> elements = element_places(text, *list);
    for (std::size_t i = elements.size(); i-- > 0;) {
        const json entry = json::parse(elements[i].text(text), nullptr, true, true);
        if (is_superseded(entry, assignment)) remove_line(text, elements[i]);
    }
}

/// Replaces the last entry when it is for the same nodes: what happens when a key is pressed several times.
bool replace_last(std::string& text, const StyleAssignment& assignment)
{
    const std::optional<JsonPlace> list = member_place(text, "assign");
    if (!list) return false;
    const std::vector<JsonPlace> elements = element_places(text, *list);
    if (elements.empty()) return false;
    const std::string_view last = elements.back().text(text);
    if (last.find("//") != last.npos || last.find("/*") != last.npos) return false;
    if (!is_superseded(json::parse(last), assignment)) return false;
    text.replace(elements.back().begin, last.size(), entry_text(assignment));
    return true;
}

std::string indent_of(const std::string& text, std::size_t place)
{
    const std::size_t line_start = text.rfind('\n', place) + 1;
    const std::size_t first = text.find_first_not_of(" \t", line_start);
    return first == place ? text.substr(line_start, first - line_start) : std::string(kFallbackIndent, ' ');
}

void append_entry(std::string& text, const JsonPlace& list, const std::string& entry)
{
    const std::vector<JsonPlace> elements = element_places(text, list);
    if (elements.empty()) {
        text.insert(list.begin + 1, std::string("\n") + std::string(kFallbackIndent, ' ') + entry + "\n  ");
        return;
    }
    // After comments that follow the last entry, but before the line of the closing bracket.
    const std::size_t end = text.find_last_not_of(" \t\r\n", list.end - 2) + 1;
    text.insert(std::max(end, elements.back().end), std::string("\n") + indent_of(text, elements.back().begin) + entry);
    text.insert(elements.back().end, 1, ',');
}

void append_list(std::string& text, const std::string& entry)
{
    const JsonPlace root = root_place(text);
    const std::optional<JsonPlace> last = last_member_place(text);
    const std::string list = fmt::format("\n  \"assign\": [\n    {}\n  ]", entry);
    const std::size_t end = text.find_last_not_of(" \t\r\n", root.end - 2) + 1;
    text.insert(last ? std::max(end, last->end) : root.begin + 1, list + (last ? "" : "\n"));
    if (last) text.insert(last->end, 1, ',');
}

json assign_of(const json& level)
{
    return level.value("assign", json::array());
}

/// The new text must say what the old one said, superseded entries apart, and then the assignments.
bool says_the_same(const json& before, const json& after, std::span<const StyleAssignment> assignments)
{
    json old_rest = before;
    json new_rest = after;
    old_rest.erase("assign");
    new_rest.erase("assign");
    const auto is_kept = [&](const json& entry) {
        return std::ranges::none_of(assignments, [&](const auto& a) { return is_superseded(entry, a); });
    };
    json old_entries = json::array();
    json new_entries = json::array();
    for (const json& entry : assign_of(before))
        if (is_kept(entry)) old_entries.push_back(entry);
    for (const json& entry : assign_of(after))
        if (is_kept(entry)) new_entries.push_back(entry);
    if (old_rest != new_rest || old_entries != new_entries) return false;
    return assignments.empty() ||
           (!assign_of(after).empty() && assign_of(after).back() == json::parse(entry_text(assignments.back())));
}

}  // namespace

std::string with_assignments(std::string text, std::span<const StyleAssignment> assignments,
                             const std::filesystem::path& file)
{
    const json before = parse_json(text, file.string(), JsonComments::allowed);
    parse_level(text, file);
    for (const StyleAssignment& assignment : assignments) {
        HW_ASSERT(!assignment.nodes.empty() && (!assignment.style.empty() || assignment.visible));
        if (replace_last(text, assignment)) continue;
        remove_superseded(text, assignment);
        if (const std::optional<JsonPlace> list = member_place(text, "assign"))
            append_entry(text, *list, entry_text(assignment));
        else
            append_list(text, entry_text(assignment));
    }
    const json after = parse_json(text, file.string(), JsonComments::allowed);
    if (!says_the_same(before, after, assignments))
        throw Error({.what = "the level cannot be edited without changing what else it says",
                     .file = file.string(),
                     .pointer = "/assign",
                     .fault = Fault::ours});
    parse_level(text, file);
    return text;
}

LevelTexts edit_level_file(const std::filesystem::path& level_file, const AssignmentsFor& assignments_for)
{
    if (level_file.extension() != ".json")
        throw Error(
            {.what = "styles cannot be saved in a model", .file = level_file.string(), .expected = "a level (.json)"});
    const FolderHandle folder(level_file.parent_path());
    const FolderLock lock(folder);
    for (int i = 0; i < kMostTries; ++i) {
        const std::string before = read_text_file(level_file, limits::kMaxLevelFileBytes);
        const std::string after =
            with_assignments(before, assignments_for(parse_level(before, level_file)), level_file);
        // An editor takes no lock: what it wrote by now is read anew.
        if (read_text_file(level_file, limits::kMaxLevelFileBytes) != before) continue;
        if (after != before)
            folder.write(level_file.filename().string(), std::as_bytes(std::span(after.data(), after.size())));
        return {before, after};
    }
    throw Error({.what = "changes faster than it can be saved", .file = level_file.string()});
}

}  // namespace hw
