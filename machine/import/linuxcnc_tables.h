#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "machine/data/machine_data.h"

namespace gsim::import {

/// Notes from reading a table, in addition to its data.
struct ImportNotes {
    std::vector<std::string> left_out;  ///< By name.
};

/// Takes over a file of parameters (.var): the work coordinate systems with their rotation, the G92 offset,
/// G28 and G30, and the variables of programs. `unit_mm` is that of its lengths; `axes` are the letters of
/// the machine. The error is "file:line: message".
Result<void> import_parameters(std::string_view text, std::string_view file_name, double unit_mm,
                               std::string_view axes, machine::MachineData& data, ImportNotes& notes);

/// Takes over a tool table (.tbl) in the same manner: lengths, diameters, offsets, angles and orientations.
Result<void> import_tools(std::string_view text, std::string_view file_name, double unit_mm,
                          std::string_view axes, machine::MachineData& data, ImportNotes& notes);

}  // namespace gsim::import
