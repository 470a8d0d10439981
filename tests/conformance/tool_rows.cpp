#include "tests/conformance/tool_rows.h"

#include <fmt/format.h>

namespace gsim::conformance {

namespace {

constexpr double kMmInAnInch = 25.4;

}  // namespace

std::vector<ToolRow> recorded_tools() {
    constexpr int kTools = 99;
    std::vector<ToolRow> tools;
    for (int number = 1; number <= kTools; ++number) tools.push_back({number, 0, 6});
    return tools;
}

std::vector<ToolRow> random_program_tools() {
    return {{1, 0.5, 0.125}, {2, 1.25, 0.0625}, {3, 0, 0.25}, {4, 2, 0}, {5, 0.75, 0.1}};
}

std::string machine_data_text(std::span<const ToolRow> tools) {
    std::string text = "NCFILE\nTOOL\n";
    for (const ToolRow& tool : tools) {
        text += fmt::format("{} {} {}\n", tool.number, tool.length_inch * kMmInAnInch,
                            tool.diameter_inch * kMmInAnInch);
    }
    return text + "ENDFILE\n";
}

std::string tool_table_text(std::span<const ToolRow> tools) {
    std::string text;
    for (const ToolRow& tool : tools)
        text += fmt::format("T{0} P{0} Z{1} D{2} ;\n", tool.number, tool.length_inch, tool.diameter_inch);
    return text;
}

}  // namespace gsim::conformance
