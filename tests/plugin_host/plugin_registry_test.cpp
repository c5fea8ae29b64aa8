#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/plugin_host/plugin_tests.hpp"
#include "tests/temporary_folder.hpp"

using namespace hw;
using namespace hw::test;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;

namespace {

std::string reason(const std::string& name)
{
    for (const RefusedPlugin& refused : test_registry().refused())
        if (refused.name == name) return refused.why;
    return "";
}

}  // namespace

TEST(plugin_registry, the_static_table_holds_the_built_in_plugins)
{
    const PluginRegistry registry({.has_installed = false, .compiled_in = static_plugins()});
    EXPECT_THAT(registry.names(PluginKind::style), IsSupersetOf({"hybrid", "pen_and_ink", "photoreal"}));
    EXPECT_THAT(registry.names(PluginKind::image_pass), Contains("edge_map"));
    for (const Plugin& plugin : registry.plugins()) EXPECT_FALSE(plugin.summary.empty()) << plugin.name;
}

TEST(plugin_registry, the_installation_s_libraries_are_found_and_equal_the_static_table)
{
    const PluginRegistry loaded;
    const PluginRegistry compiled_in({.has_installed = false, .compiled_in = static_plugins()});
    ASSERT_EQ(loaded.plugins().size(), compiled_in.plugins().size());
    for (std::size_t i = 0; i < loaded.plugins().size(); ++i) {
        EXPECT_EQ(loaded.plugins()[i].name, compiled_in.plugins()[i].name);
        EXPECT_NE(loaded.plugins()[i].entry, compiled_in.plugins()[i].entry);
        EXPECT_TRUE(std::filesystem::is_directory(loaded.plugins()[i].shader_folder))
            << loaded.plugins()[i].shader_folder;
    }
}

TEST(plugin_registry, a_plugin_of_version_1_is_refused_by_its_version_alone_with_one_sentence)
{
    EXPECT_EQ(
        reason("old_version"),
        "it was written for version 1 of the plugin interface, this program has version 2: change its source for that "
        "and build it anew");
}

TEST(plugin_registry, a_plugin_of_another_build_is_refused)
{
    EXPECT_THAT(reason("other_build"), HasSubstr("it was built by \"abi 1, glm 4\""));
}

TEST(plugin_registry, a_plugin_that_saw_other_headers_is_refused)
{
    EXPECT_THAT(reason("other_headers"), HasSubstr("headers 0123456789abcdef\", this program by"));
}

TEST(plugin_registry, a_library_without_an_entry_is_refused)
{
    EXPECT_THAT(reason("no_entry"), HasSubstr("HW_STYLE"));
}

TEST(plugin_registry, a_library_whose_entry_throws_is_refused)
{
    EXPECT_THAT(reason("throws_in_entry"), HasSubstr("throws"));
}

TEST(plugin_registry, a_library_that_calls_itself_otherwise_is_refused_and_hides_nothing)
{
    EXPECT_THAT(reason("other_name"), HasSubstr("it calls itself \"photoreal\""));
    ASSERT_NE(test_registry().find("photoreal", PluginKind::style), nullptr);
    EXPECT_TRUE(test_registry().find("photoreal", PluginKind::style)->library.empty());
}

TEST(plugin_registry, a_folder_that_is_missing_is_bad_input)
{
    const std::string message =
        refusal([] { PluginRegistry({.has_installed = false, .folders = {"/no/such/folder"}}); });
    EXPECT_EQ(message, "/no/such/folder: there is no such folder of plugins");
}

TEST(plugin_registry, names_are_lower_case_letters_digits_and_underscores)
{
    EXPECT_TRUE(is_plugin_name("pen_and_ink_2"));
    for (const char* name : {"", "Pen", "pen-and-ink", "../pen", "pen.so", "p\xc3\xa9n"})
        EXPECT_FALSE(is_plugin_name(name));
}

TEST(plugin_registry, a_plugin_is_found_only_as_its_own_kind)
{
    EXPECT_EQ(test_registry().find("edge_map", PluginKind::style), nullptr);
    EXPECT_NE(test_registry().find("edge_map", PluginKind::image_pass), nullptr);
}

TEST(plugin_registry, a_fifo_a_folder_and_a_library_that_is_cut_off_are_left_out)
{
    namespace fs = std::filesystem;
    const TemporaryFolder temporary;
    const fs::path& folder = temporary.path();
    ASSERT_EQ(::mkfifo((folder / "fifo.so").c_str(), 0600), 0);
    fs::create_directory(folder / "folder.so");
    const auto whole_bytes = fs::file_size(kMisbehaving / "throws_in_make.so");
    for (const int tenths : {1, 5, 9}) {
        const fs::path cut = folder / ("cut_" + std::to_string(tenths) + ".so");
        fs::copy_file(kMisbehaving / "throws_in_make.so", cut);
        fs::resize_file(cut, whole_bytes * tenths / 10);
    }
    fs::copy_file(kMisbehaving / "throws_in_make.so", folder / "throws_in_make.so");
    set_log_level(LogLevel::off);
    const PluginRegistry registry({.has_installed = false, .folders = {folder}, .trial = Trial::none});
    EXPECT_THAT(registry.names(PluginKind::style), ElementsAre("throws_in_make")) << "the whole one is good";
    ASSERT_EQ(registry.refused().size(), 5u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(registry.refused()[i].why, "the file is cut off");
    for (std::size_t i = 3; i < 5; ++i) EXPECT_EQ(registry.refused()[i].why, "it is not a regular file");
}

TEST(plugin_registry, a_folder_whose_name_is_too_long_is_bad_input)
{
    EXPECT_THAT(refusal([] { PluginRegistry({.has_installed = false, .folders = {"/" + std::string(5000, 'x')}}); }),
                HasSubstr("there is no such folder of plugins"));
}
