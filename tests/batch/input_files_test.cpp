#include "batch/work/input_files.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "batch/work/sha256.h"

namespace gsim::batch::input_files_test {
namespace {

namespace fs = std::filesystem;

class Inputs : public testing::Test {
  protected:
    Inputs() { fs::create_directories(folder_); }
    ~Inputs() override { fs::remove_all(folder_); }

    std::string write(const std::string& text) const {
        std::ofstream(folder_ / "a") << text;
        return (folder_ / "a").string();
    }

    fs::path folder_ = fs::temp_directory_path() / ("gsim-inputs-" + std::to_string(::getpid()));
    InputFiles files_;
};

// FIPS 180-4, by the examples that NIST publishes.
TEST(Sha256, MatchesStandardExamples) {
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST_F(Inputs, RereadChangedFile) {
    const std::string name = write("one");
    ASSERT_NE(files_.get(name), nullptr);
    EXPECT_EQ(files_.get(name)->bytes, "one");
    EXPECT_EQ(files_.file_hash(name), sha256("one"));
    write("another");
    EXPECT_EQ(files_.get(name)->bytes, "another");
    EXPECT_EQ(files_.file_hash(name), sha256("another"));
    fs::remove(name);
    EXPECT_EQ(files_.get(name), nullptr);
    EXPECT_EQ(files_.file_hash(name), "");
}

TEST_F(Inputs, ReturnNothingForNonRegularFiles) {
    EXPECT_EQ(files_.get(folder_.string()), nullptr);
    EXPECT_EQ(files_.file_hash("/dev/zero"), "");
    EXPECT_EQ(files_.get(""), nullptr);
}

// More bytes than are kept: all of them come back as they are.
TEST_F(Inputs, RereadLargeFilesBeyondCacheSize) {
    const std::string large(std::size_t{24} << 20U, 'x');
    std::vector<std::string> names;
    for (const char letter : {'b', 'c', 'd', 'e'}) {
        names.push_back((folder_ / std::string(1, letter)).string());
        std::ofstream(names.back()) << letter << large;
    }
    for (int turn = 0; turn < 2; ++turn) {
        for (const std::string& name : names) EXPECT_EQ(files_.get(name)->bytes.front(), name.back());
    }
}

}  // namespace
}  // namespace gsim::batch::input_files_test
