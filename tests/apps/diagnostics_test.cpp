// Findings of the programs, as JSON and as SARIF.

#include "base/text/json.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::diagnostics_test {
namespace {

using nlohmann::json;

class DiagnosticsOutput : public Apps {
  protected:
    Ended gsim(const std::vector<std::string>& arguments, const std::string& input = {}) const {
        return run_program(tests::program_path("gsim"), arguments, folder_, input);
    }
    /// The only diagnostic of a document.
    static json only(const std::string& document) {
        const json read = text::try_parse_json<json>(document);
        if (!read.is_object() || !read.contains("diagnostics") || read["diagnostics"].size() != 1) {
            ADD_FAILURE() << document;
            return {};
        }
        return read["diagnostics"][0];
    }
};

constexpr const char* kWrong = "G1 X1 F5\nG1 Y2 Q7\n";

void expect_wrong_word(const json& found) {
    EXPECT_EQ(found["file"], "part.nc");
    EXPECT_EQ(found["line"], 2);
    EXPECT_EQ(found["column"], 7);
    EXPECT_EQ(found["end_column"], 9);
    EXPECT_EQ(found["severity"], "error");
    EXPECT_EQ(found["code"], "word-out-of-place");
    EXPECT_TRUE(found["hint"].is_null());
    EXPECT_TRUE(contains(found["text"], "Q has no meaning")) << found;
}

TEST_F(DiagnosticsOutput, ReportsWrongWordOfTranslation) {
    write("part.nc", kWrong);
    const Ended e = gcode2lua({"--json", "part.nc"});
    EXPECT_EQ(e.status, 1);
    EXPECT_EQ(e.err, "") << "JSON is in place of text";
    expect_wrong_word(only(e.out));
    EXPECT_EQ(gcode2lua({"--json", "--check", "part.nc"}).out, e.out);
}

TEST_F(DiagnosticsOutput, UsesStandardErrorIfStdoutHasLua) {
    write("part.nc", "M98 P7\n");
    const Ended e = gcode2lua({"--json", "part.nc"});
    EXPECT_EQ(e.status, 0);
    EXPECT_TRUE(contains(e.out, "M98")) << e.out;
    const json found = only(e.err);
    EXPECT_EQ(found["code"], "program-missing");
    EXPECT_EQ(found["severity"], "warning");
}

TEST_F(DiagnosticsOutput, SeparatesHintFromText) {
    write("part.nc", "G33.1 Z5 K1\n");
    const json found = only(gcode2lua({"--json", "part.nc"}).out);
    EXPECT_EQ(found["code"], "code-unknown");
    EXPECT_TRUE(contains(found["hint"], "--dialect")) << found;
    EXPECT_FALSE(contains(found["text"], "--dialect")) << found;
}

TEST_F(DiagnosticsOutput, ReportHasLineOfSyntaxError) {
    write("part.nc", kWrong);
    const Ended e = gsim_run({"--json", "part.nc"});
    EXPECT_EQ(e.status, 1);
    const json report = text::try_parse_json<json>(e.out);
    ASSERT_EQ(report["diagnostics"].size(), 1U) << e.out;
    expect_wrong_word(report["diagnostics"][0]);
    EXPECT_EQ(report["alarm"]["line"], 2);
    EXPECT_EQ(report["alarm"]["file"], "part.nc");
    EXPECT_EQ(report["alarm"]["code"], "word-out-of-place");
}

TEST_F(DiagnosticsOutput, ReportHasCodeOfAlarm) {
    write("part.nc", "G1 X1\n");
    const json report = text::try_parse_json<json>(gsim_run({"--json", "part.nc"}).out);
    ASSERT_EQ(report["diagnostics"].size(), 1U) << report;
    EXPECT_EQ(report["diagnostics"][0]["code"], "feed");
    EXPECT_EQ(report["diagnostics"][0]["line"], 1);
    EXPECT_EQ(report["alarm"]["code"], "feed");
}

TEST_F(DiagnosticsOutput, AlarmHasNotesOfCalls) {
    write("part.nc", "O1\nM98 P2\nM30\nO2\n#100=1/0\nM99\n");
    const Ended e = gsim({"check", "--json", "part.nc"});
    const json document = text::try_parse_json<json>(e.out);
    ASSERT_EQ(document["diagnostics"].size(), 2U) << e.out;
    EXPECT_EQ(document["diagnostics"][0]["code"], "arithmetic");
    EXPECT_EQ(document["diagnostics"][0]["line"], 5);
    EXPECT_EQ(document["diagnostics"][1]["severity"], "note");
    EXPECT_EQ(document["diagnostics"][1]["line"], 2);
    EXPECT_EQ(document["programs"][0]["program"], "part.nc");
    EXPECT_EQ(document["programs"][0]["status"], "alarm");
}

TEST_F(DiagnosticsOutput, CheckOfSeveralProgramsIsOneDocument) {
    write("part.nc", kWrong);
    write("good.nc", "G1 X100 F6000\nM2\n");
    const Ended e = gsim({"check", "--json", "part.nc", "good.nc", "missing.nc"});
    EXPECT_EQ(e.status, 2);
    EXPECT_EQ(e.err, "");
    const json document = text::try_parse_json<json>(e.out);
    ASSERT_EQ(document["programs"].size(), 3U) << e.out;
    EXPECT_EQ(document["programs"][0]["status"], "not run");
    EXPECT_EQ(document["programs"][1]["status"], "completed");
    EXPECT_NEAR(document["programs"][1]["cycle_time_s"].get<double>(), 1 + 100.0 / 490.33, 1e-6);
    ASSERT_EQ(document["diagnostics"].size(), 2U) << e.out;
    EXPECT_EQ(document["diagnostics"][1]["code"], "file");
    EXPECT_EQ(document["diagnostics"][1]["file"], "missing.nc");
    EXPECT_TRUE(document["diagnostics"][1]["line"].is_null());
}

TEST_F(DiagnosticsOutput, EachProgramReportsUnknownOption) {
    for (const char* command : {"run", "check", "translate", "write", "path", "data"}) {
        const Ended e = gsim({command, "--json", "--no-such-option"});
        EXPECT_EQ(e.status, 2) << command;
        EXPECT_EQ(e.err, "") << command;
        const json found = only(e.out);
        EXPECT_EQ(found["code"], "usage") << command;
        EXPECT_TRUE(found["file"].is_null()) << command;
    }
}

TEST_F(DiagnosticsOutput, NamesMissingOrInvalidFile) {
    write("x.nc", "G0 X1\n");
    write("wrong.toml", "name = \"m\"\nspeed = 5\n");
    json found = only(gsim({"run", "--json", "--machine", "wrong.toml", "x.nc"}).out);
    EXPECT_EQ(found["code"], "input-file");
    EXPECT_EQ(found["file"], "wrong.toml");
    EXPECT_GT(found["line"], 0);
    found = only(gsim({"run", "--json", "--machine", "none.toml", "x.nc"}).out);
    EXPECT_EQ(found["code"], "input-file");
    EXPECT_EQ(found["file"], "none.toml");
    found = only(gsim({"write", "--json", "-"}, "{").out);
    EXPECT_EQ(found["code"], "path");
    found = only(gsim({"path", "--json", "none.svg", "--speed", "1", "--kerf", "1"}).out);
    EXPECT_EQ(found["file"], "none.svg");
    write("data.txt", "NONSENSE\n");
    found = only(gsim({"data", "--json", "data.txt", "check"}).out);
    EXPECT_EQ(found["file"], "data.txt");
    EXPECT_EQ(found["line"], 1);
}

TEST_F(DiagnosticsOutput, WritesSarifWithSourceLocation) {
    write("a part.nc", kWrong);
    const Ended e = gcode2lua({"--sarif", "found.sarif", "--check", "a part.nc"});
    EXPECT_EQ(e.status, 1);
    EXPECT_TRUE(contains(e.err, "a part.nc:2:7: error: ")) << "text as ever: " << e.err;
    const json sarif = text::try_parse_json<json>(read("found.sarif"));
    EXPECT_EQ(sarif["version"], "2.1.0");
    const json& run = sarif["runs"][0];
    EXPECT_EQ(run["tool"]["driver"]["name"], "gsim");
    EXPECT_EQ(run["tool"]["driver"]["rules"][0]["id"], "word-out-of-place");
    ASSERT_EQ(run["results"].size(), 1U);
    const json& result = run["results"][0];
    EXPECT_EQ(result["ruleId"], "word-out-of-place");
    EXPECT_EQ(result["level"], "error");
    const json& location = result["locations"][0]["physicalLocation"];
    EXPECT_EQ(location["artifactLocation"]["uri"], "a%20part.nc") << "a reference, not a name";
    EXPECT_EQ(location["region"]["startLine"], 2);
    EXPECT_EQ(location["region"]["startColumn"], 7);
    EXPECT_EQ(location["region"]["endColumn"], 9);
}

TEST_F(DiagnosticsOutput, WritesSarifOfRun) {
    write("part.nc", "G1 X1\n");
    const Ended e = gsim_run({"--sarif", "-", "part.nc"});
    EXPECT_EQ(e.status, 1);
    EXPECT_TRUE(contains(e.err, "program")) << "the report makes way";
    const json sarif = text::try_parse_json<json>(e.out);
    EXPECT_EQ(sarif["runs"][0]["results"][0]["ruleId"], "feed") << e.out;
}

TEST_F(DiagnosticsOutput, ReportsUnwritableSarif) {
    write("part.nc", "G0 X1\n");
    const Ended e = gcode2lua({"--check", "--sarif", "none/found.sarif", "part.nc"});
    EXPECT_EQ(e.status, 2);
    EXPECT_TRUE(contains(e.err, "none/found.sarif")) << e.err;
}

}  // namespace
}  // namespace gsim::apps::diagnostics_test
