#pragma once

#include <span>
#include <string>
#include <vector>

namespace gsim::conformance {

/// Tool for both sides. The stand-alone interpreter reads its table in inches, whatever the program's units.
struct ToolRow {
    int number = 0;
    double length_inch = 0;
    double diameter_inch = 0;
};

/// The tools with which the recordings were made: 1 to 99, of length 0 and 6 inches in diameter.
std::vector<ToolRow> recorded_tools();
/// The tools of random programs: 1 to 5, of different lengths and diameters.
std::vector<ToolRow> random_program_tools();

/// The machine data of gsim that hold these tools.
std::string machine_data_text(std::span<const ToolRow> tools);
/// The tool table of LinuxCNC that holds them.
std::string tool_table_text(std::span<const ToolRow> tools);

}  // namespace gsim::conformance
