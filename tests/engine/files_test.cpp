#include "engine/files.h"

#include <cstdio>

#include <gtest/gtest.h>

#include "engine/run.h"

namespace gsim::engine::files_test {
namespace {

TEST(Text, RunsProgramFromStream) {
    std::FILE* file = std::tmpfile();
    std::fputs("G0 X10\nM2\n", file);
    std::rewind(file);
    auto text = Text::from_stream(file, "pipe");
    std::fclose(file);
    ASSERT_TRUE(text);
    Request request;
    request.text = *std::move(text);
    engine::Run run = engine::Run::open(request).value();
    ASSERT_TRUE(run.prepare());
    const Report report = run.go().value();
    EXPECT_EQ(report.program, "pipe");
    EXPECT_EQ(report.counts.moves, 1U);
}

TEST(Text, RunsLuaTextAsScript) {
    Request request;
    request.text = Text("require 'gsim'\nG0{x=7}\n", "editor");
    engine::Run run = engine::Run::open(request).value();
    ASSERT_TRUE(run.prepare());
    const Report report = run.go().value();
    EXPECT_EQ(report.status, RunStatus::completed);
    EXPECT_EQ(report.distances.rapid_mm, 7);
}

}  // namespace
}  // namespace gsim::engine::files_test
