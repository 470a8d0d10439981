// Map of a translation: the positions of its programs, and the cuts at which their bodies may be divided.
#include <algorithm>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/codegen/lua_compiler.h"
#include "tests/codegen/random_program.h"
#include "tests/codegen/translated.h"

namespace gsim::codegen::chunks_test {
namespace {

struct Mapped {
    Translation translation;
    std::string lua;
};

Mapped mapped(const std::string& gcode, const TranslateOptions& options = {}) {
    lexer::Source source = lexer::Source::from_text(gcode, "t");
    LuaSpool spool;
    Mapped result;
    result.translation = translate(source, spool, options, [](const text::Diagnostic&) {});
    EXPECT_TRUE(result.translation.ok) << result.translation.first_error.value_or(text::Diagnostic{}).text;
    result.lua = spool.read(0, spool.size()).value();
    return result;
}

std::vector<std::string> chunks(const Mapped& full, const ProgramPart& part) {
    std::vector<std::string> out;
    std::uint64_t begin = part.body_begin;
    for (const Cut& cut : part.cuts) {
        out.push_back(full.lua.substr(begin, cut.offset - begin));
        begin = cut.offset;
    }
    out.push_back(full.lua.substr(begin, part.body_end - begin));
    return out;
}

std::uint32_t line_of(const std::string& text, std::uint64_t offset) {
    return static_cast<std::uint32_t>(
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
}

void expect_sound_map(const Mapped& full) {
    for (const ProgramPart& part : full.translation.programs) {
        ASSERT_LE(part.body_begin, part.body_end);
        EXPECT_EQ(part.first_line, line_of(full.lua, part.body_begin)) << part.head;
        std::string body;
        for (const std::string& chunk : chunks(full, part)) {
            EXPECT_EQ(compile_error(chunk), std::nullopt) << chunk.substr(0, 200);
            body += chunk;
        }
        EXPECT_EQ(body, full.lua.substr(part.body_begin, part.body_end - part.body_begin));
        for (const Cut& cut : part.cuts) {
            EXPECT_EQ(full.lua[cut.offset - 1], '\n');
            EXPECT_EQ(cut.line, line_of(full.lua, cut.offset));
        }
        const std::string head = part.head + "function()";
        EXPECT_EQ(full.lua.substr(part.body_begin - head.size(), head.size()), head);
        EXPECT_EQ(full.lua.substr(full.lua.find_first_not_of(" \n", part.body_end), 4), "end)");
    }
}

TEST(ProgramMap, FindsProgramsAndTheirBodies) {
    const Mapped full = mapped("%\nO0001\nX1\nM98 P2\nM2\n%\nO2\nM99\nOPART\nM99\n");
    ASSERT_EQ(full.translation.programs.size(), 3U);
    EXPECT_EQ(full.translation.programs[0].head, "program(1, ");
    EXPECT_EQ(full.translation.programs[0].first_line, 3U);
    EXPECT_EQ(full.translation.programs[1].head, "program(2, ");
    EXPECT_EQ(full.translation.programs[2].head, "program(\"PART\", ");
    EXPECT_EQ(line_of(full.lua, full.lua.size()) - 1, 12U);
    expect_sound_map(full);
}

TEST(ProgramMap, HasUnnamedProgramWithoutOWord) {
    const Mapped full = mapped("X1\nX2\n");
    ASSERT_EQ(full.translation.programs.size(), 1U);
    EXPECT_EQ(full.translation.programs[0].head, "program(nil, ");
    EXPECT_EQ(full.translation.programs[0].first_line, 1U);
    expect_sound_map(full);
}

TEST(ProgramMap, ListsSubroutinesAndCodeAfterThem) {
    TranslateOptions options;
    options.dialect = &grammar::dialect_rs274ngc();
    const Mapped full = mapped("X1\no<a> sub\nX2\no<a> endsub\n\no7 sub\no7 endsub\nX3\n", options);
    std::vector<std::string> heads;
    for (const ProgramPart& part : full.translation.programs) heads.push_back(part.head);
    EXPECT_THAT(heads, testing::ElementsAre("program(nil, ", "sub(\"a\", ", "sub(7, ", "more("));
    expect_sound_map(full);
}

TEST(ProgramMap, ChunksOfRandomProgramsCompile) {
    std::mt19937 random(9);
    for (int i = 0; i < 100; ++i) {
        const std::string gcode = random_program(random, {.jumps = false});
        SCOPED_TRACE(gcode);
        expect_sound_map(mapped(gcode));
        ASSERT_FALSE(testing::Test::HasFailure());
    }
}

std::string big_program(int lines, const std::string& middle) {
    std::string gcode = "O1\n";
    for (int i = 0; i < lines; ++i) {
        gcode += fmt::format("G1 X{}\n", i);
        if (i == lines / 2) gcode += middle;
    }
    return gcode;
}

TEST(ProgramMap, BigProgramsHaveCuts) {
    const Mapped full = mapped(big_program(200000, ""));
    ASSERT_EQ(full.translation.programs.size(), 1U);
    const ProgramPart& part = full.translation.programs[0];
    EXPECT_GE(part.cuts.size(), 20U);
    for (std::size_t i = 1; i < part.cuts.size(); ++i)
        ASSERT_GT(part.cuts[i].offset, part.cuts[i - 1].offset);
    expect_sound_map(full);
}

TEST(ProgramMap, CutsAfterLineWithMoreThanCalls) {
    const Mapped full = mapped(big_program(2000, "#1=5 (changed)\nX[#1]\n"));
    const std::vector<Cut>& cuts = full.translation.programs[0].cuts;
    ASSERT_EQ(cuts.size(), 1U);  // not after each of two
    EXPECT_NE(full.lua.substr(0, cuts[0].offset).find("changed"), std::string::npos);
    EXPECT_EQ(full.lua.substr(cuts[0].offset).find("changed"), std::string::npos);
    expect_sound_map(full);
}

TEST(ProgramMap, HasNoCutInLoopOrProgramWithJumps) {
    std::string loop = "WHILE[#1 LT 5]DO1\n";
    for (int i = 0; i < 30000; ++i) loop += "X1\n";
    const Mapped looped = mapped(big_program(20000, loop + "END1\n"));
    const ProgramPart& part = looped.translation.programs[0];
    EXPECT_GE(part.cuts.size(), 2U);
    for (const Cut& cut : part.cuts) EXPECT_TRUE(cut.line < 10004 || cut.line > 40000) << cut.line;
    expect_sound_map(looped);
    const Mapped jumping = mapped(big_program(20000, "N5 IF[#1 EQ 1]GOTO5\n"));
    EXPECT_TRUE(jumping.translation.programs[0].cuts.empty());
    expect_sound_map(jumping);
}

}  // namespace
}  // namespace gsim::codegen::chunks_test
