#include "engine/findings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/text/json.h"
#include "engine/run.h"
#include "tests/engine/memory_files.h"

namespace gsim::engine::findings_test {
namespace {

using nlohmann::json;

const Diagnostic kWord = {.severity = Severity::warning,
                          .code = "syntax",
                          .file = "my part.nc",
                          .line = 3,
                          .column = 4,
                          .end_column = 6,
                          .text = "no such word",
                          .hint = "leave it out"};

Report report_of_run(const std::string& program, std::map<std::string, std::string> further = {}) {
    further["p.nc"] = program;
    Run run = Run::open(make_request("p.nc", std::move(further))).value();
    const auto prepared = run.prepare();
    return prepared ? run.go().value() : run.make_report(prepared.error());
}

TEST(EngineFindings, AreWrittenAsTextLine) {
    EXPECT_EQ(diagnostic_text(kWord), "my part.nc:3:4: warning: no such word; leave it out\n");
    EXPECT_EQ(diagnostic_text({.code = "usage", .text = "not so"}), "error: not so\n");
}

TEST(EngineFindings, ErrorTakesSourceLocationFromMessage) {
    const Diagnostic placed = to_diagnostic(Error{.code = "input-file", .message = "m.toml:2:1: not so"});
    EXPECT_EQ(placed.file, "m.toml");
    EXPECT_EQ(placed.line, 2U);
    EXPECT_EQ(placed.column, 1U);
    EXPECT_EQ(placed.text, "not so");
    const Diagnostic named =
        to_diagnostic(Error{.code = "path", .message = "a.svg: not closed", .file = "a.svg"});
    EXPECT_EQ(named.file, "a.svg");
    EXPECT_EQ(named.text, "not closed");
    EXPECT_EQ(named.code, "path");
}

TEST(EngineFindings, AreWrittenAsJson) {
    const std::vector<CheckedProgram> programs = {{"p.nc", "completed", 1.5}};
    const json document = text::parse_json<json>(findings_json({&kWord, 1}, programs));
    EXPECT_EQ(document["programs"][0],
              (json{{"program", "p.nc"}, {"status", "completed"}, {"cycle_time_s", 1.5}}));
    EXPECT_EQ(document["diagnostics"][0]["code"], "syntax");
    EXPECT_EQ(document["diagnostics"][0]["hint"], "leave it out");
    EXPECT_FALSE(text::parse_json<json>(findings_json({&kWord, 1})).contains("programs"));
}

TEST(EngineFindings, AreWrittenAsSarif) {
    const json run = text::parse_json<json>(findings_sarif({&kWord, 1}))["runs"][0];
    EXPECT_EQ(run["tool"]["driver"]["rules"].size(), 1U);
    EXPECT_EQ(run["tool"]["driver"]["rules"][0]["id"], "syntax");
    const json& result = run["results"][0];
    EXPECT_EQ(result["message"]["text"], "no such word; leave it out");
    const json& location = result["locations"][0]["physicalLocation"];
    EXPECT_EQ(location["artifactLocation"]["uri"], "my%20part.nc");
    EXPECT_EQ(location["region"], (json{{"startLine", 3}, {"startColumn", 4}, {"endColumn", 6}}));
}

TEST(EngineFindings, ReportErrorsAreWrittenAsLines) {
    const Report far = report_of_run("G0 X9000\nM2\n");
    ASSERT_EQ(far.violations.size(), 1U);
    EXPECT_EQ(far.errors_text(), "p.nc:1: " + far.violations[0].message + "\n");
    EXPECT_FALSE(far.passes_check());
    const Report stopped = report_of_run("M98 P7\nM2\n", {{"O0007.nc", "#3000=1 (OUT OF WATER)\nM99\n"}});
    ASSERT_TRUE(stopped.alarm);
    EXPECT_EQ(stopped.errors_text(),
              "O0007.nc:1: alarm: " + stopped.alarm->message + "\n  in O7, called at p.nc:1\n");
    EXPECT_FALSE(stopped.is_file_missing());
}

TEST(EngineFindings, CleanReportHasNoErrorText) {
    const Report report = report_of_run("G0 X10\nM2\n");
    EXPECT_EQ(report.errors_text(), "");
    EXPECT_TRUE(report.passes_check());
}

TEST(EngineFindings, ProcessFindingsFailCheck) {
    const Report report = report_of_run("M8\nG0 X10\nM9\nM2\n");
    ASSERT_GT(report.process_findings, 0U);
    EXPECT_TRUE(report.is_clean());
    EXPECT_FALSE(report.passes_check());
}

}  // namespace
}  // namespace gsim::engine::findings_test
