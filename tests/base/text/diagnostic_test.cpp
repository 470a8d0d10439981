#include "base/text/diagnostic.h"

#include <fstream>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/build_files/build_files.h"

namespace gsim::text::diagnostic_test {
namespace {

TEST(Diagnostic, IsWrittenAsText) {
    Diagnostic diagnostic{.file = "part.nc", .line = 12, .column = 7, .text = "wrong"};
    EXPECT_EQ(to_text(diagnostic), "part.nc:12:7: error: wrong\n");
    diagnostic.hint = "write it so";
    diagnostic.excerpt = "  G1\n  ^\n";
    EXPECT_EQ(to_text(diagnostic), "part.nc:12:7: error: wrong; write it so\n  G1\n  ^\n");
    diagnostic = {.severity = Severity::note, .file = "part.nc", .text = "look"};
    EXPECT_EQ(to_text(diagnostic), "part.nc: note: look\n");
    EXPECT_EQ(to_text({.severity = Severity::warning, .text = "look"}), "warning: look\n");
}

TEST(Diagnostic, TakesSourceLocationFromMessage) {
    const Diagnostic full =
        to_diagnostic(DiagnosticKind::input_file, "a b.toml:12:7: warning: 'x' is no key");
    EXPECT_EQ(full.file, "a b.toml");
    EXPECT_EQ(full.line, 12U);
    EXPECT_EQ(full.column, 7U);
    EXPECT_EQ(full.severity, Severity::warning);
    EXPECT_EQ(full.text, "'x' is no key");
    const Diagnostic line = to_diagnostic(DiagnosticKind::input_file, "C:/x: y.nc:3: wrong: 5");
    EXPECT_EQ(line.file, "C:/x: y.nc") << "a name may hold a colon and a blank";
    EXPECT_EQ(line.line, 3U);
    EXPECT_EQ(line.column, 0U);
    EXPECT_EQ(line.text, "wrong: 5");
}

TEST(Diagnostic, KeepsMessageWithoutSourceLocation) {
    for (const char* message : {"no such file", "x.toml: No such file or directory", ":3: odd",
                                "at 12:30: late", "a:99999999999: too large"}) {
        const Diagnostic diagnostic = to_diagnostic(DiagnosticKind::file, message);
        if (std::string_view(message).starts_with("at")) {
            EXPECT_EQ(diagnostic.line, 30U) << "told apart by nothing";
            continue;
        }
        EXPECT_EQ(diagnostic.file, "") << message;
        EXPECT_EQ(diagnostic.text, message);
    }
}

TEST(Diagnostic, TakesFileNameFromReadError) {
    const Diagnostic diagnostic =
        to_diagnostic(DiagnosticKind::input_file, "cannot read 'a b.svg': No such file");
    EXPECT_EQ(diagnostic.file, "a b.svg");
    EXPECT_EQ(diagnostic.line, 0U);
    EXPECT_EQ(diagnostic.text, "cannot read 'a b.svg': No such file");
}

TEST(DiagnosticKind, HasUniqueCodesInEnumOrder) {
    std::set<std::string_view> codes;
    std::size_t index = 0;
    for (const DiagnosticKindEntry& entry : diagnostic_kinds()) {
        EXPECT_EQ(static_cast<std::size_t>(entry.kind), index++) << entry.code;
        EXPECT_TRUE(codes.insert(entry.code).second) << entry.code;
        EXPECT_EQ(diagnostic_code(entry.kind), entry.code);
        EXPECT_EQ(diagnostic_kind(entry.code), entry.kind);
        EXPECT_EQ(entry.code.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), std::string_view::npos);
    }
    EXPECT_EQ(static_cast<std::size_t>(DiagnosticKind::internal) + 1, index);
    EXPECT_FALSE(diagnostic_kind("no-such-code"));
}

TEST(DiagnosticKind, IsListedInDocs) {
    std::ifstream file(tests::source_path("docs/diagnostics.md"));
    std::ostringstream page;
    page << file.rdbuf();
    std::string table = "| code | what is told |\n| --- | --- |\n";
    for (const DiagnosticKindEntry& entry : diagnostic_kinds())
        table += "| `" + std::string(entry.code) + "` | " + std::string(entry.meaning) + " |\n";
    EXPECT_NE(page.str().find(table), std::string::npos) << "docs/diagnostics.md should hold\n" << table;
}

}  // namespace
}  // namespace gsim::text::diagnostic_test
