// A long script that is run in parts has the same effect as at once.

#include "codegen/translate.h"
#include "tests/lua_lib/run.h"

namespace gsim::script::chunks_test {
namespace {

// Returns the Lua of a program without O, its body in parts of `lines` lines.
Script in_pieces(const std::string& gcode, std::size_t lines) {
    const codegen::TextTranslation translation = codegen::translate_text(gcode, {});
    EXPECT_TRUE(translation.ok) << translation.diagnostics;
    const std::string& lua = translation.lua;
    Script script = Script::from_text(lua, "part.nc", -1);
    const std::size_t body_end = lua.rfind("end)");
    ScriptFunction program{"program(nil, ", {}};
    std::uint32_t line = 2;
    for (std::size_t at = lua.find('\n') + 1; at < body_end;) {
        ScriptChunk chunk{at, at, line};
        for (std::size_t i = 0; i < lines && chunk.end < body_end; ++i, ++line)
            chunk.end = std::min(lua.find('\n', chunk.end) + 1, body_end);
        at = chunk.end;
        program.chunks.push_back(chunk);
    }
    script.functions.push_back(std::move(program));
    return script;
}

void expect_same(const Outcome& a, const Outcome& b) {
    EXPECT_EQ(a.report.status, b.report.status);
    EXPECT_EQ(a.message(), b.message());
    EXPECT_EQ(a.line(), b.line());
    EXPECT_EQ(a.report.cycle_time_s, b.report.cycle_time_s);
    EXPECT_EQ(a.report.counts.blocks, b.report.counts.blocks);
    EXPECT_EQ(a.events(), b.events());
    ASSERT_EQ(a.moves.size(), b.moves.size());
    for (std::size_t i = 0; i < a.moves.size(); ++i) {
        EXPECT_EQ(a.moves[i].end, b.moves[i].end);
        EXPECT_EQ(a.moves[i].end_s, b.moves[i].end_s);
        EXPECT_EQ(a.moves[i].info.location.line, b.moves[i].info.location.line);
    }
}

const char* const kProgram =
    "G21 G90 F3000\nG0 X100 Y100 (start)\nG1 X110 Y105\nX115\nG3 X105 Y115 I-10\n\n#1=4\nG1 X[#1*30] Y90 M8\n"
    "G91 X1\nX1\nM9\nG90 G4 P.5\nG0 X0 Y0\n";

TEST(Chunks, AnySizeGivesSameRun) {
    const Outcome full = run(kProgram);
    ASSERT_TRUE(full.completed()) << full.message();
    ASSERT_GT(full.moves.size(), 7U);
    for (std::size_t lines = 1; lines <= 14; ++lines) {
        SCOPED_TRACE(lines);
        expect_same(full, run_script(in_pieces(kProgram, lines), {}));
    }
}

TEST(Chunks, AlarmsHaveCorrectLines) {
    const std::string program = std::string(kProgram) + "X-1\nX5\n";
    for (const std::size_t lines : {1U, 3U, 50U}) {
        const Outcome r = run_script(in_pieces(program, lines), {});
        expect_alarm(r, 14, {"axis X", "-1"});
    }
    for (const std::size_t lines : {1U, 3U, 50U})
        expect_alarm(run_script(in_pieces("G0 X1\n\n\nG0 X[1/0]\n", lines), {}), 4, {"zero"});
}

TEST(Chunks, KeepProgramEndsAndRepeats) {
    Conditions conditions;
    conditions.limits.max_blocks = 50;
    const std::string repeat = "G0 X100\nX0\nX50\nM99\nX1\n";
    expect_same(run(repeat, conditions), run_script(in_pieces(repeat, 1), conditions));
    const std::string ends = "G0 X100\nM2\nX0\n";
    expect_same(run(ends), run_script(in_pieces(ends, 1), {}));
}

TEST(Chunks, CallSubprogramsRepeatedly) {
    Script script = Script::from_text("M98{p=2, l=3}\nM98{p=2}\nG91() G0{x=10.0}\n", "part.nc", 0);
    const std::uint64_t sub = std::string("M98{p=2, l=3}\nM98{p=2}\n").size();
    script.functions.push_back({"program(1, ", {{0, 14, 1}, {14, sub, 2}}});
    script.functions.push_back({"program(2, ", {{sub, script.size, 3}}});
    const Outcome r = run_script(std::move(script), {});
    expect_end(r, 40, 0, 0);
    EXPECT_EQ(r.moves[0].info.location.line, 3U);
}

TEST(Chunks, LinesRunWithoutLuaCountAsSteps) {
    std::string gcode;
    for (int i = 0; i < 50'000; ++i) gcode += "G21 G90\n";
    Conditions conditions;
    conditions.options.limits.steps = 200'000;
    const Outcome r = run_script(in_pieces(gcode, 50'000), conditions);
    expect_stopped(r, "200000 steps");
    EXPECT_GT(r.line(), 1000U);
    EXPECT_LT(r.line(), 40'000U);  // at 3 for a call
}

TEST(Chunks, FindFunctionDefinedInEarlierChunk) {
    const std::string first = "G0{x=10.0}\n";
    const std::string second = "function twice() G0{x=20.0} G0{x=30.0} end\n";
    const std::string third = "G0{x=35.0} twice() G0{x=40.0}\n";
    const std::string fourth = "G0{x=50.0} G0{x=60.0}\ntwice()\n";
    Script script = Script::from_text(first + second + third + fourth, "part.nc", 0);
    ScriptFunction program{"program(1, ", {}};
    std::uint64_t at = 0;
    std::uint32_t line = 1;
    for (const std::string& gcode_part : {first, second, third, fourth}) {
        program.chunks.push_back({at, at + gcode_part.size(), line++});
        at += gcode_part.size();
    }
    script.functions.push_back(std::move(program));
    const Outcome r = run_script(std::move(script), {});
    expect_end(r, 30, 0, 0);
    std::vector<double> to;
    std::vector<std::uint32_t> lines;
    for (std::size_t i = 0; i < r.moves.size(); ++i) {
        to.push_back(r.to(i, 'X'));
        lines.push_back(r.moves[i].info.location.line);
    }
    EXPECT_EQ(to, (std::vector<double>{10, 35, 20, 30, 40, 50, 60, 20, 30}));
    EXPECT_EQ(lines, (std::vector<std::uint32_t>{1, 3, 2, 2, 3, 4, 4, 2, 2}));
}

TEST(Chunks, ReportUnknownWordAtItsLine) {
    const std::string text = "G0{x=10.0}\nG0{x=20.0} G77{x=1}\n";
    Script script = Script::from_text(text, "part.nc", 0);
    script.functions.push_back({"program(1, ", {{0, script.size, 1}}});
    const Outcome r = run_script(std::move(script), {});
    expect_alarm(r, 2, {"G77"});
    EXPECT_EQ(r.moves.size(), 2U);
}

TEST(Chunks, OtherProcessesRunBetweenLines) {
    Conditions conditions;
    conditions.options.setup = Script::from_text(
        "process('a', function() for i = 1, 5 do wait(0.5) signal('x') end end)", "setup.lua", 0);
    std::string gcode = "G21 G90 F3000\n";
    for (int i = 1; i <= 40; ++i) gcode += "G1 X" + std::to_string(5 * i) + "\nG4 P.1\n";
    const Outcome full = run(gcode, conditions);
    ASSERT_TRUE(full.completed()) << full.message();
    for (const std::size_t lines : {1U, 7U, 81U}) {
        const Outcome in_parts = run_script(in_pieces(gcode, lines), conditions);
        expect_same(full, in_parts);
        EXPECT_EQ(full.report.concurrency.processes.size(), in_parts.report.concurrency.processes.size());
        EXPECT_EQ(full.report.concurrency.signals.size(), in_parts.report.concurrency.signals.size());
    }
}

TEST(Chunks, ReportProgress) {
    Conditions conditions;
    std::vector<std::uint64_t> reported;
    conditions.options.progress = [&](std::uint64_t done, std::uint64_t total) {
        EXPECT_LE(done, total);
        reported.push_back(done);
    };
    EXPECT_TRUE(run_script(in_pieces(kProgram, 2), conditions).completed());
    EXPECT_GE(reported.size(), 5U);
    EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
}

}  // namespace
}  // namespace gsim::script::chunks_test
