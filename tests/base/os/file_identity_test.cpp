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

TEST_F(FileIdentityTest, IsOneForAllNamesOfAFile) {
    fs::create_symlink("a", folder_ / "symbolic");
    fs::create_hard_link(folder_ / "a", folder_ / "hard");
    fs::create_directory_symlink(".", folder_ / "here");
    const auto a = identity_of(folder_ / "a");
    ASSERT_TRUE(a);
    for (const char* name : {"symbolic", "hard", "./a", "here/a", "here/./a"})
        EXPECT_EQ(identity_of(folder_ / name), a) << name;
    std::ofstream(folder_ / "b") << "a";
    EXPECT_NE(identity_of(folder_ / "b"), a);
    const Descriptor open(::open((folder_ / "a").c_str(), O_RDONLY | O_CLOEXEC));
    EXPECT_EQ(identity_of_open(open.number()), a);
}

TEST_F(FileIdentityTest, OfAFileThatIsNotThereIsItsFoldersAndItsName) {
    fs::create_directory_symlink(".", folder_ / "here");
    const auto b = identity_of(folder_ / "b");
    ASSERT_TRUE(b);
    EXPECT_EQ(identity_of(folder_ / "here/./b"), b);
    EXPECT_NE(identity_of(folder_ / "c"), b);
    EXPECT_FALSE(identity_of(folder_ / "no/b"));
}

// Systems give the number of a file that is gone to the next one.
TEST_F(FileIdentityTest, IsNotThatOfAFileWhichIsMadeWhenItIsGone) {
    for (int i = 0; i < 100; ++i) {
        const auto gone = identity_of(folder_ / "a");
        fs::remove(folder_ / "a");
        std::ofstream(folder_ / "b") << "b";
        EXPECT_NE(identity_of(folder_ / "b"), gone);
        fs::rename(folder_ / "b", folder_ / "a");
    }
}

// The case occurs if another run writes the file between two checks.
TEST_F(FileIdentityTest, IsThatOfTheFileWhichTookItsPlace) {
    fs::create_symlink("a", folder_ / "symbolic");
    const auto before = identity_of(folder_ / "a");
    std::ofstream(folder_ / "b") << "b";
    fs::rename(folder_ / "b", folder_ / "a");
    EXPECT_EQ(identity_of(folder_ / "a"), before);
    EXPECT_EQ(identity_of(folder_ / "symbolic"), before);
    fs::remove(folder_ / "a");
    EXPECT_EQ(identity_of(folder_ / "a"), before);
}

TEST_F(FileIdentityTest, DevicesAndFoldersMayBeNamedTwice) {
    EXPECT_FALSE(identity_of("/dev/null"));
    EXPECT_FALSE(identity_of(folder_));
    EXPECT_FALSE(identity_of(folder_ / ""));
}

}  // namespace
}  // namespace gsim::os::file_identity_test
