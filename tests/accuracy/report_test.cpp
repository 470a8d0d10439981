#include "tests/accuracy/report.h"

#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace gsim::accuracy::report_test {
namespace {

const Controller& kGrbl = kControllers[1];

std::vector<TimeOutcome> some_times() {
    return {{"router_a", "a square", true, 2, 2.001, ""},
            {"router_b", "a note of more characters than the column is wide", true, 1, 1.1, "rounded"},
            {"router_c", "", true, 1.5, Unexpected("alarm: limit"), ""}};
}

TEST(TimeReport, HasRowPerProgramAndSummaryLine) {
    EXPECT_EQ(
        time_report(some_times(), kGrbl, Format::plain),
        "Cycle times, grbl\n"
        "program   note                                      gsim s  recorded s  error ms  error %  mark\n"
        "router_a  a square                                  2.0010      2.0000      +1.0   +0.050  good\n"
        "router_b  a note of more characters than the co...  1.1000      1.0000    +100.0  +10.000  OFF\n"
        "router_c                                                 -      1.5000         -        -  REFUSED\n"
        "\n"
        "  router_b: known: rounded\n"
        "  router_c: refused: alarm: limit\n"
        "\n"
        "1 of 3 within 0.2 % or 2 ms; 1 of 3 within 1 % or 2 ms; largest +10.000 % (+100.0 ms, router_b)\n"
        "\n");
}

TEST(TimeReport, IsAlsoWrittenAsMarkdown) {
    const std::string report = time_report(some_times(), kGrbl, Format::markdown);
    EXPECT_EQ(report.find("### Cycle times, grbl\n\n| program | note |"), 0U) << report;
    EXPECT_NE(report.find("\n\n- router_b: known: rounded\n- router_c: refused: alarm: limit\n\n1 of 3"),
              std::string::npos)
        << report;
}

TEST(TimeReport, DoesNotSplitUtf8Character) {
    std::vector<TimeOutcome> outcomes = some_times();
    outcomes[0].note =
        fmt::format("{}\xC3\xA4 and so on", std::string(36, 'a'));  // the cut is inside the a with dots
    const std::string report = time_report(outcomes, kGrbl, Format::plain);
    EXPECT_NE(report.find(std::string(36, 'a') + "... "), std::string::npos) << report;
}

TEST(PathReport, ReportsLineOfLargestDistance) {
    const std::vector<PathOutcome> outcomes{{"router_a", Distance{0.25, 3, 0.1}, ""},
                                            {"router_b", Distance{12, 14, 1.5}, ""},
                                            {"router_c", Unexpected("no trajectory"), ""}};
    EXPECT_EQ(path_report(outcomes, kGrbl, Format::plain),
              "Positions, grbl, block by block\n"
              "program   largest mm  in line  s into it  mark\n"
              "router_a       0.250        3      0.100  good\n"
              "router_b      12.000       14      1.500  OFF\n"
              "router_c           -        -          -  OFF\n"
              "\n"
              "  router_c: no trajectory\n"
              "\n"
              "1 of 3 within 1 mm\n"
              "\n");
    EXPECT_EQ(path_report({}, kGrbl, Format::plain), "");
}

}  // namespace
}  // namespace gsim::accuracy::report_test
