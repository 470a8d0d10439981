#include "base/os/file_identity.h"

#include <fstream>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "base/os/descriptor.h"

namespace gsim::os::file_identity_test {
namespace {

namespace fs = std::filesystem;

class FileIdentityTest : public testing::Test {
  protected:
    FileIdentityTest() {
        std::string name = (fs::temp_directory_path() / "file_identity_test_XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
        std::ofstream(folder_ / "a") << "a";
    }
    ~FileIdentityTest() override { fs::remove_all(folder_); }

    fs::path folder_;
};

TEST_F(FileIdentityTest, IsEqualForAllNamesOfFile) {
    fs::create_symlink("a", folder_ / "symbolic");
    fs::create_hard_link(folder_ / "a", folder_ / "hard");
    fs::create_directory_symlink(".", folder_ / "here");
    const auto a = file_identity(folder_ / "a");
    ASSERT_TRUE(a);
    for (const char* name : {"symbolic", "hard", "./a", "here/a", "here/./a"})
        EXPECT_EQ(file_identity(folder_ / name), a) << name;
    std::ofstream(folder_ / "b") << "a";
    EXPECT_NE(file_identity(folder_ / "b"), a);
    const Descriptor open(::open((folder_ / "a").c_str(), O_RDONLY | O_CLOEXEC));
    EXPECT_EQ(open_file_identity(open.number()), a);
}

TEST_F(FileIdentityTest, MissingFileIsIdentifiedByFolderAndName) {
    fs::create_directory_symlink(".", folder_ / "here");
    const auto b = file_identity(folder_ / "b");
    ASSERT_TRUE(b);
    EXPECT_EQ(file_identity(folder_ / "here/./b"), b);
    EXPECT_NE(file_identity(folder_ / "c"), b);
    EXPECT_FALSE(file_identity(folder_ / "no/b"));
}

// Systems give the number of a file that is gone to the next one.
TEST_F(FileIdentityTest, DiffersForFileCreatedAfterRemoval) {
    for (int i = 0; i < 100; ++i) {
        const auto gone = file_identity(folder_ / "a");
        fs::remove(folder_ / "a");
        std::ofstream(folder_ / "b") << "b";
        EXPECT_NE(file_identity(folder_ / "b"), gone);
        fs::rename(folder_ / "b", folder_ / "a");
    }
}

// The case occurs if another run writes the file between two checks.
TEST_F(FileIdentityTest, IsKeptAfterReplacementOfFile) {
    fs::create_symlink("a", folder_ / "symbolic");
    const auto before = file_identity(folder_ / "a");
    std::ofstream(folder_ / "b") << "b";
    fs::rename(folder_ / "b", folder_ / "a");
    EXPECT_EQ(file_identity(folder_ / "a"), before);
    EXPECT_EQ(file_identity(folder_ / "symbolic"), before);
    fs::remove(folder_ / "a");
    EXPECT_EQ(file_identity(folder_ / "a"), before);
}

TEST_F(FileIdentityTest, DevicesAndFoldersHaveNoIdentity) {
    EXPECT_FALSE(file_identity("/dev/null"));
    EXPECT_FALSE(file_identity(folder_));
    EXPECT_FALSE(file_identity(folder_ / ""));
}

}  // namespace
}  // namespace gsim::os::file_identity_test
