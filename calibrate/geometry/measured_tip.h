#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "machine/model/machine.h"

namespace gsim::calibrate {

/// Where a tip was found to be.
struct MeasuredTip {
    std::vector<double> readings = {};  ///< Of all axes, mm and deg, in machine coordinates.
    rrs::CartPos tip = rrs::CartPos::Identity();
    bool has_orientation = false;  ///< Else the tip's place alone counts.
    std::optional<double> sigma_mm =
        std::nullopt;  ///< Standard deviation of each coordinate, where the list has it.
    std::optional<double> sigma_deg = std::nullopt;  ///< The same of the turn about each axis.
};

/// What a list of measurements has.
struct TipList {
    std::vector<MeasuredTip> tips = {};
    std::vector<MeasuredTip> unmeasured = {};  ///< Lines that have no tip yet.
};

/// Reads a list with commas (or tabs) between and a first line that names the columns: the letter of each
/// axis of the machine (one that is left out stands at home), x_mm, y_mm, z_mm; perhaps roll_deg, pitch_deg,
/// yaw_deg of the tool in the order of machine files, Rz(roll) Ry(pitch) Rx(yaw); sigma_mm and sigma_deg.
/// Other columns are passed over. The error begins with the line.
tl::expected<TipList, std::string> read_tips(std::string_view list, const machine::Machine& machine);

/// Such a list. Without `measured` the columns of tips are empty, for people to fill in.
std::string print_tips(const std::vector<MeasuredTip>& tips, const machine::Machine& machine,
                       bool orientation, bool measured);

}  // namespace gsim::calibrate
