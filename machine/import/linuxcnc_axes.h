#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "machine/import/ini_file.h"
#include "machine/model/machine.h"

namespace gsim::import {

/// Units of an INI file.
struct IniUnits {
    double linear_mm = 1;    ///< mm of a linear unit.
    double angular_deg = 1;  ///< deg of an angular one.
};

/// The units of [TRAJ]. The error is "file:line: sentence".
tl::expected<IniUnits, std::string> read_units(IniFile& ini);

/// The axes of a machine with trivial kinematics, in the order of [TRAJ] COORDINATES: each has the narrower
/// of the limits of its section [AXIS_..] and of its joints. `warnings` gets what cannot be taken as it
/// stands. The error is "file:line: sentence", as for other kinematics.
tl::expected<std::vector<machine::Axis>, std::string> read_axes(IniFile& ini, const IniUnits& units,
                                                                std::vector<std::string>& warnings);

}  // namespace gsim::import
