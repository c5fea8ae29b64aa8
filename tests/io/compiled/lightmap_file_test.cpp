#include "hatchway/io/compiled/lightmap_file.hpp"

#include <sys/stat.h>

#include "tests/io/expect_error.hpp"
#include "tests/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;

/// What find_lightmap() warns of for a level in a project of its own.
class lightmap_beside : public testing::Test {
 protected:
    lightmap_beside()
    {
        folder_.write("outside", "bytes");
        level_ = folder_.write("project/hall.level.json", "{}");
        lightmap_ = hw::lightmap_path(level_);
    }
    std::string warning() const
    {
        testing::internal::CaptureStderr();
        EXPECT_FALSE(hw::find_lightmap(level_, hw::Scene{}));
        return testing::internal::GetCapturedStderr();
    }

    TemporaryFolder folder_;
    fs::path level_, lightmap_;
};

}  // namespace

TEST_F(lightmap_beside, none_is_no_matter)
{
    EXPECT_EQ(warning(), "");
}

TEST_F(lightmap_beside, a_folder_is_named_in_a_warning)
{
    fs::create_directory(lightmap_);
    EXPECT_THAT(warning(), testing::HasSubstr("hall.level.json.lightmap: is not a regular file"));
}

TEST_F(lightmap_beside, a_fifo_is_named_in_a_warning_and_never_replaced)
{
    ASSERT_EQ(::mkfifo(lightmap_.c_str(), 0600), 0);
    EXPECT_THAT(warning(), testing::HasSubstr("is not a regular file"));
    EXPECT_THAT(error_of([&] { hw::write_lightmap(lightmap_, {}); }).what, testing::HasSubstr("not a regular file"));
    EXPECT_TRUE(fs::is_fifo(lightmap_));
}

TEST_F(lightmap_beside, a_link_is_not_read_and_is_replaced_not_what_it_leads_to)
{
    folder_.write("project/source.cpp", "bytes");
    for (const char* other : {"../outside", "source.cpp"}) {
        fs::remove(lightmap_);
        fs::create_symlink(other, lightmap_);
        EXPECT_THAT(warning(), testing::HasSubstr("goes through the link"));
        hw::write_lightmap(lightmap_, {});
        EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(lightmap_)));
        EXPECT_EQ(hw::read_text_file(lightmap_.parent_path() / other, 100), "bytes");
    }
}
