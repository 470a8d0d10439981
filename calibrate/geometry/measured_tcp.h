#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "machine/model/machine.h"

namespace gsim::calibrate {

/// Measured TCP pose.
struct MeasuredTcp {
    std::vector<double> readings = {};  ///< For all axes, mm and deg, in machine coordinates.
    rrs::CartPos tcp = rrs::CartPos::Identity();
    bool has_orientation = false;  ///< Else only the TCP position counts.
    std::optional<double> sigma_mm =
        std::nullopt;  ///< Standard deviation of each coordinate, if the list has it.
    std::optional<double> sigma_deg = std::nullopt;  ///< The same of the turn about each axis.
};

/// Content of a list of measurements.
struct TcpList {
    std::vector<MeasuredTcp> tcps = {};
    std::vector<MeasuredTcp> unmeasured = {};  ///< Lines without a measured TCP.
};

/// Reads a list separated by commas (or tabs) with a first line that names the columns. These are the letter
/// of each axis of the machine (an omitted one is at home), x_mm, y_mm, z_mm. Optional are roll_deg,
/// pitch_deg, yaw_deg of the tool in the order of machine files, Rz(roll) Ry(pitch) Rx(yaw); sigma_mm and
/// sigma_deg. Other columns are skipped. The error begins with the line.
Result<TcpList> read_tcps(std::string_view list, const machine::Machine& machine);

/// Prints such a list. Without `measured` the columns of TCPs are empty, for users to fill in.
std::string print_tcps(const std::vector<MeasuredTcp>& tcps, const machine::Machine& machine,
                       bool orientation, bool measured);

}  // namespace gsim::calibrate
