#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "machine/import/ini_file.h"
#include "machine/model/machine.h"

namespace gsim::import {

/// Units of an INI file.
struct IniUnits {
    double linear_mm = 1;    ///< mm of a linear unit.
    double angular_deg = 1;  ///< deg of an angular one.
};

/// Returns the units of [TRAJ]. The error is "file:line: message".
Result<IniUnits> read_units(IniFile& ini);

/// Returns the axes of a machine with trivial kinematics, in the order of [TRAJ] COORDINATES. Each has the
/// narrower of the limits of its section [AXIS_..] and of its joints. `warnings` receives settings that
/// cannot be used as they are. The error is "file:line: message", as for other kinematics.
Result<std::vector<machine::Axis>> read_axes(IniFile& ini, const IniUnits& units,
                                             std::vector<std::string>& warnings);

}  // namespace gsim::import
