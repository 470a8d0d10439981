#pragma once

#include <array>
#include <string_view>

namespace gsim::accuracy {

/// How far a time may be off: by a part of the recorded time or by a fixed time, whichever is more.
struct Tolerance {
    double percent = 0;
    double least_s = 0;

    bool holds(double error_s, double recorded_s) const;
};

/// A recorded controller: how its recordings are written and how close gsim shall come to it.
struct Controller {
    std::string_view name;             ///< Of its folder.
    std::string_view time_key;         ///< Where the JSON of a recording has the cycle time, s.
    std::string_view note_key;         ///< Where it has a word about the program.
    bool times_dwells = true;          ///< Whether recorded dwells are in the controller's own time.
    Tolerance close;                   ///< Most programs shall be this close ...
    Tolerance fair;                    ///< ... and all, but for those that known.h lists, this close.
    std::size_t close_percent = 95;    ///< How many are most,
    std::size_t fair_percent = 100;    ///< and all.
    bool from_first_move = false;      ///< Recorded times begin with the first motion, whatever was before.
    int tools = 0;                     ///< It has tools 1 to this many, without lengths.
    std::string_view machines = name;  ///< What the names of its machine files begin with.
};

/// LinuxCNC times a dwell by the wall clock, and stops at multiples of its servo period: some ms for a
/// program. The second set is of whole part programs and of single words between moves. grbl's time is exact.
inline constexpr std::array kControllers{
    Controller{"linuxcnc", "cycle_time_s", "mode", false, {0.5, 0.005}, {2, 0.005}},
    Controller{"grbl", "cycle_time_nominal_s", "notes", true, {0.2, 0.002}, {1, 0.002}},
    Controller{
        "linuxcnc2", "cycle_time_s", "mode", true, {0.05, 0.002}, {0.5, 0.005}, 85, 97, true, 9, "linuxcnc"},
};

}  // namespace gsim::accuracy
