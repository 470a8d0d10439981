#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "runtime/machine/machine.h"

namespace gsim::machine {

/// Where a frame or a fixed point stands: a value for each axis letter, in mm or deg by the axis's kind.
using AxisValues = std::map<char, double>;

/// An entry of the tool table.
struct Tool {
    double length_mm = 0;
    double diameter_mm = 0;  ///< Of the cutter or the jet; below 0 it lies on the other side of the path.
};

/// What a controller stores beside the part program (docs/machine-file.md, "Machine data").
struct MachineData {
    std::map<std::string, AxisValues, std::less<>> offsets;   ///< By code: "54" .. "59.3", "505" .. "599".
    std::map<int, AxisValues> fixed;                          ///< Fixed points, by number.
    std::map<std::string, std::string, std::less<>> aliases;  ///< Name and code, both as they are spelled.
    std::map<int, double> variables;                          ///< By number.
    std::map<int, Tool> tools;                                ///< By number.
    std::map<int, AxisValues> homes;                          ///< Home positions 2 to 4 (G30).
};

/// Reads the text format NCFILE ... ENDFILE strictly. Lines of OFFSET and FIXED hold values for X, Y, Z and
/// then, as far as given, for the other axes of the machine in the order of `axes`; without `axes` those
/// further values are checked and left out. The error is "file:line:column: sentence"; `file_name` is only
/// for that. Aliases that differ in case alone are an error; whether their codes are words of the language is
/// for the lexer to say.
tl::expected<MachineData, std::string> read_machine_data(std::string_view text, std::string_view file_name,
                                                         std::span<const Axis> axes = {});

/// read_machine_data() of a file on disk.
tl::expected<MachineData, std::string> load_machine_data(const std::filesystem::path& path,
                                                         std::span<const Axis> axes = {});

}  // namespace gsim::machine
