#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/os/input_file.h"
#include "machine/model/machine.h"
#include "machine/model/zone.h"

namespace gsim::machine {

/// Position of a frame or a point: a value for each axis letter, in mm or deg by the axis's kind.
using AxisValues = std::map<char, double>;

enum class ToolKind { unspecified, cutter, jet };

/// An entry of the tool table.
struct Tool {
    double length_mm = 0;    ///< Along Z, without wear.
    double diameter_mm = 0;  ///< Diameter of the cutter or the jet; below 0: on the other side of the path.
    double length_wear_mm = 0;    ///< Is added to the length.
    double diameter_wear_mm = 0;  ///< Is added to the diameter.
    ToolKind kind = ToolKind::unspecified;
    AxisValues offsets = {};  ///< Along axes other than Z, mm or deg; 0 is the same as none.
    double front_angle_deg = 0;
    double back_angle_deg = 0;
    int orientation = 0;  ///< 0 to 9, as turning machines count it.

    bool operator==(const Tool&) const = default;
};

/// Data that a controller stores in addition to the part program (docs/machine-data.md).
struct MachineData {
    std::map<std::string, AxisValues, std::less<>> offsets;   ///< By code: "54" .. "59.3", "505" .. "599".
    std::map<int, AxisValues> fixed;                          ///< Fixed points, by number.
    std::map<int, std::string> fixed_names;                   ///< Names of those that have one, as spelled.
    std::map<int, AxisValues> references;                     ///< Reference points, by number.
    std::map<int, std::string> reference_names;               ///< Names of those that have one, as spelled.
    std::map<int, AxisValues> homes;                          ///< Home positions 2 to 4 (G30).
    std::map<int, Tool> tools;                                ///< By number.
    std::map<int, double> variables;                          ///< By number.
    std::map<std::string, std::string, std::less<>> aliases;  ///< Name and code, both as they are spelled.
    std::map<int, Zone> security_zones;                       ///< By number.
    std::optional<Zone> working_zone;

    bool operator==(const MachineData&) const = default;
};

/// Reads the text format NCFILE ... ENDFILE strictly. Lines of points contain values for X, Y, Z and then, as
/// far as given, for the other axes of the machine in the order of `axes`. Without `axes` those further
/// values are checked and omitted. The error is "file:line:column: message"; `file_name` is only for that.
/// Aliases that differ only in case are an error, and so are names of fixed points and of reference points.
/// The lexer decides if their codes are words of the language.
Result<MachineData> read_machine_data(std::string_view text, std::string_view file_name,
                                      std::span<const Axis> axes = {});

/// Runs read_machine_data() on a file on disk.
Result<MachineData> load_machine_data(const std::filesystem::path& path, std::span<const Axis> axes = {},
                                      os::NameSource name_source = os::NameSource::in_file);

/// Returns the data as a separate file, in mm: sections in the order of the documentation, entries by number.
/// read_machine_data() gives the same data back, as long as further axes have values from the first one of
/// them on without gaps; gaps become 0.
std::string write_machine_data(const MachineData& data, std::span<const Axis> axes);

}  // namespace gsim::machine
