#include "lexer/source.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace gsim::lexer::source_test {
namespace {

std::string read_all(Source& source, std::size_t step) {
    std::string text;
    std::string buffer(step, '\0');
    while (const std::size_t count = source.read(buffer.data(), buffer.size())) text.append(buffer, 0, count);
    return text;
}

constexpr std::string_view kText = "G1 X5\r\nY2\n\nlast";

void expect_reads(Source& source) {
    EXPECT_EQ(source.size(), kText.size());
    EXPECT_EQ(read_all(source, 3), kText);
    source.rewind();
    EXPECT_EQ(read_all(source, 1000), kText);
    EXPECT_EQ(source.line_at(0), "G1 X5") << "without its CR LF";
    EXPECT_EQ(source.line_at(7), "Y2");
    EXPECT_EQ(source.line_at(10), "");
    EXPECT_EQ(source.line_at(11), "last");
    EXPECT_EQ(source.line_at(0, 2), "G1");
    EXPECT_EQ(source.line_at(1000), "") << "behind the end there is nothing";
    EXPECT_EQ(source.error(), 0);
}

TEST(Source, GrowingFileEndsAtFirstEnd) {
    const std::string file = testing::TempDir() + "gsim_growing.nc";
    std::ofstream(file) << "G0 X1 (a\n";
    auto source = Source::open(file);
    ASSERT_TRUE(source);
    std::array<char, 64> buffer{};
    EXPECT_GT(source->read(buffer.data(), buffer.size()), 0U);
    EXPECT_EQ(source->read(buffer.data(), buffer.size()), 0U);
    std::ofstream(file, std::ios::app) << "remark)\nM2\n";
    EXPECT_EQ(source->read(buffer.data(), buffer.size()), 0U);
    source->rewind();
    EXPECT_GT(source->read(buffer.data(), buffer.size()), 0U);
    std::filesystem::remove(file);
}

TEST(Source, ReadsText) {
    Source source = Source::from_text(std::string(kText), "name");
    EXPECT_EQ(source.name(), "name");
    expect_reads(source);
}

TEST(Source, ReadsFile) {
    const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "gsim_source_test.nc";
    std::ofstream(path, std::ios::binary) << kText;
    auto source = Source::open(path.string());
    ASSERT_TRUE(source) << source.error();
    expect_reads(*source);
    std::filesystem::remove(path);
}

TEST(Source, ReadsSpooledStreamTwice) {
    std::string text(kText);
    std::FILE* stream = ::fmemopen(text.data(), text.size(), "r");
    ASSERT_NE(stream, nullptr);
    auto source = Source::spool(stream, "stdin");
    std::fclose(stream);
    ASSERT_TRUE(source) << source.error();
    EXPECT_EQ(source->name(), "stdin");
    expect_reads(*source);
}

TEST(Source, FindsLineLongerThanOneRead) {
    const std::string line(5000, 'X');
    const Source source = Source::from_text(line + "\nY\n", "t");
    EXPECT_EQ(source.line_at(0), line);
    EXPECT_EQ(source.line_at(5001), "Y");
}

TEST(Source, ErrorNamesFile) {
    const auto missing = Source::open("no_such_folder/part.nc");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error(), "no_such_folder/part.nc: No such file or directory");
    const auto folder = Source::open(testing::TempDir());
    ASSERT_FALSE(folder);
    EXPECT_EQ(folder.error(), testing::TempDir() + ": Is a directory");
}

}  // namespace
}  // namespace gsim::lexer::source_test
