// Each code that the dialect supports means something to the library.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include <fmt/format.h>

#include "base/text/diagnostic_kind.h"
#include "grammar/dialect.h"
#include "tests/build_files/build_files.h"
#include "tests/lua_lib/run.h"

namespace gsim::script::codes_test {
namespace {

TEST(Codes, SupportedCodesAreLibraryFunctions) {
    std::string script = "local missing = ''\n";
    int count = 0;
    for (const grammar::Code& code : grammar::dialect_ab9().codes()) {
        if (code.support == grammar::Support::planned) continue;
        const std::string name = grammar::lua_name(code);
        script += fmt::format("if type({0}) ~= 'function' then missing = missing .. ' {0}' end\n", name);
        ++count;
    }
    const Outcome r = run_lua(script + "assert(missing == '', missing)\n");
    EXPECT_TRUE(r.completed()) << r.message();
    EXPECT_GT(count, 150);
    EXPECT_FALSE(run_lua("assert(type(G12345) == 'function')").completed());
}

// A code that is recognised but comes later must not be ignored in silence.
TEST(Codes, RejectsUnsupportedCodesWithLine) {
    for (const grammar::Code& code : grammar::dialect_ab9().codes()) {
        if (code.support != grammar::Support::planned) continue;
        const std::string text = diagnostics_text("G0 X1\n" + grammar::code_name(code) + "\n");
        EXPECT_NE(text.find("part.nc:2:"), std::string::npos) << text;
        EXPECT_NE(text.find("not supported"), std::string::npos) << text;
    }
}

TEST(Codes, CodesWithoutRequiredWordsRunAlone) {
    for (const char* code :
         {"G9",   "G15", "G16", "G17", "G18", "G19", "G20",   "G21",   "G23",   "G40",   "G49",
          "G54",  "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3", "G505",  "G577",
          "G599", "G61", "G64", "G67", "G69", "G80", "G90",   "G91",   "G92.1", "G93",   "G94",
          "G95",  "G97", "G98", "G99", "G0",  "G1",  "G2",    "G3",    "G14",   "G14.1", "G53",
          "G27",  "G28", "M0",  "M1",  "M2",  "M3",  "M4",    "M5",    "M6",    "M8",    "M9",
          "M10",  "M11", "M30", "D1",  "H2",  "T3",  "S4",    "F5"}) {
        const Outcome r = run(std::string(code) + "\n");
        EXPECT_TRUE(r.completed()) << code << ": " << r.message();
        EXPECT_LE(r.report.counts.blocks, 1U) << code;  // G9 and G53 without a motion have no output
    }
}

// Each alarm of the library has a code that other programs know: alarm("word-value", "F is ...").
TEST(Codes, EachAlarmHasDiagnosticCode) {
    std::size_t alarms = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(tests::source_path("lua_lib"))) {
        if (entry.path().extension() != ".lua") continue;
        std::ifstream file(entry.path());
        const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
        static const std::regex call(R"re((\w+[ .])?\balarm\((\s*"([^"]*)",)?)re");
        for (std::sregex_iterator found(text.begin(), text.end(), call), end; found != end; ++found) {
            if ((*found)[1] == "function " || (*found)[1] == "core.") continue;
            const std::string code = (*found)[3];
            EXPECT_TRUE(text::diagnostic_kind(code))
                << entry.path() << ": " << text.substr(static_cast<std::size_t>(found->position()), 80);
            ++alarms;
        }
    }
    EXPECT_GT(alarms, 200U);
}

}  // namespace
}  // namespace gsim::script::codes_test
