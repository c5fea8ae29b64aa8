#include "program/output_files.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/files/folder_handle.hpp"
#include "hatchway/io/level/file.hpp"

namespace hw {
namespace fs = std::filesystem;
namespace {

/// One spelling for all names of a file: absolute, symbolic links followed.
fs::path one_spelling(const fs::path& file)
{
    std::error_code failed;
    const fs::path absolute = fs::absolute(file, failed);
    fs::path spelling = failed ? file : fs::weakly_canonical(absolute, failed);
    if (failed) spelling = file.lexically_normal();
    return spelling.has_filename() ? spelling : spelling.parent_path();
}

constexpr unsigned kFolderMode = 0777;  // less what the process's mask takes

fs::path without_last_slash(const fs::path& folder)
{
    return folder.has_filename() ? folder : folder.parent_path();
}

bool is_inside(const fs::path& path, const fs::path& folder)
{
    return std::ranges::mismatch(folder, path).in1 == folder.end();
}

/// The user's own home and the root hold links that no project brought.
bool may_be_project(const fs::path& folder)
{
    const char* home = std::getenv("HOME");
    return folder.has_relative_path() && (home == nullptr || folder != one_spelling(home));
}

/// Throws hw::Error where the way to `folder` goes through a link that lies in the working folder, in one of `projects`
/// or in a marked project, or below: links come with a stranger's archive, and what is written must not end up where
/// they lead. Links above are the user's own.
void require_no_brought_link(const fs::path& folder, const std::string& option, std::vector<fs::path> projects)
{
    std::error_code failed;
    projects.push_back(fs::current_path(failed));
    for (fs::path& project : projects) project = one_spelling(project.empty() ? "." : project);
    fs::path part;
    for (const fs::path& name : fs::absolute(folder, failed)) {
        const fs::path above = one_spelling(part);
        part /= name;
        if (!fs::is_symlink(fs::symlink_status(part, failed)) || !may_be_project(above)) continue;
        const fs::path marked = marked_project(part);
        const bool is_brought =
            (!marked.empty() && may_be_project(marked)) || std::ranges::any_of(projects, [&](const fs::path& project) {
                return may_be_project(project) && is_inside(above, project);
            });
        if (is_brought)
            throw Error({.what = option + ": goes through a link that the project may have brought",
                         .file = part.string(),
                         .expected = "the folder itself: " + fs::read_symlink(part, failed).string()});
    }
}

}  // namespace

void require_folder(const fs::path& folder, const std::string& option)
{
    std::error_code failed;
    const fs::path place = folder.empty() ? fs::path(".") : folder;
    const auto refuse = [&](const std::string& why) {
        return Error({.what = option + ": " + why + place.string(), .expected = "a folder that lets files be written"});
    };
    if (!fs::is_directory(place, failed)) throw refuse("there is no folder ");
    if (::access(place.c_str(), W_OK | X_OK) != 0) throw refuse("nothing can be written into the folder ");
    require_no_brought_link(place, option, {});
}

void require_writable(const fs::path& file, const std::string& option)
{
    if (file.empty()) return;
    // Files are replaced by renaming, so the folder's permission decides.
    require_folder(file.parent_path(), option);
    std::error_code failed;
    if (fs::is_directory(fs::symlink_status(file, failed)))  // a link to one is replaced
        throw Error(
            {.what = option + ": is a folder", .file = file.string(), .expected = "a file that can be written"});
}

void require_writable_folder(const fs::path& folder, const std::string& option)
{
    std::error_code failed;
    const fs::file_status status = fs::symlink_status(without_last_slash(folder), failed);
    if (fs::is_directory(status)) return require_folder(folder, option);
    if (fs::exists(status))
        throw Error({.what = option + (fs::is_symlink(status) ? ": is a link" : ": is no folder"),
                     .file = folder.string(),
                     .expected = "a folder, or a new name"});
    require_folder(without_last_slash(folder).parent_path(), option);
}

void require_distinct(const std::vector<OutputFile>& outputs, const std::vector<fs::path>& inputs)
{
    for (auto output = outputs.begin(); output != outputs.end(); ++output) {
        if (output->file.empty()) continue;
        const fs::path spelling = one_spelling(output->file);
        const auto refuse = [&](const std::string& why) {
            return Error(
                {.what = output->option + ": " + why, .file = output->file.string(), .expected = "another name"});
        };
        for (const fs::path& input : inputs)
            if (!input.empty() && one_spelling(input) == spelling) throw refuse("is a file that is read");
        for (auto other = outputs.begin(); other != output; ++other)
            if (!other->file.empty() && one_spelling(other->file) == spelling)
                throw refuse("is the file of " + other->option);
    }
}

void require_outputs(const std::vector<OutputFile>& outputs, const std::vector<fs::path>& inputs)
{
    std::vector<fs::path> projects;
    for (const fs::path& input : inputs) projects.push_back(input.empty() ? input : find_project_root(input));
    for (const OutputFile& output : outputs) {
        require_writable(output.file, output.option);
        if (!output.file.empty()) require_no_brought_link(output.file.parent_path(), output.option, projects);
    }
    require_distinct(outputs, inputs);
}

void require_unread(const std::vector<OutputFile>& outputs)
{
    require_distinct(outputs, files_read());
}

bool is_in_folder(const fs::path& file, const fs::path& folder)
{
    return one_spelling(file).parent_path() == one_spelling(folder);
}

void make_folder(const fs::path& folder)
{
    std::error_code missing;
    const fs::path place = without_last_slash(folder);
    if (fs::is_directory(fs::symlink_status(place, missing))) return;
    FolderHandle(place.parent_path()).made_folder(place.filename().string(), kFolderMode);
}

}  // namespace hw
