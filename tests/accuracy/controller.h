#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace gsim::accuracy {

/// Permitted deviation of a time: a part of the recorded time or a fixed time, the larger of the two.
struct Tolerance {
    double percent = 0;
    double min_s = 0;

    bool is_within(double error_s, double recorded_s) const;
};

/// A line of a table.tsv by the names of its columns.
using TableRow = std::map<std::string, std::string, std::less<>>;

/// Returns the text in a column, or an empty text if the line lacks it.
std::string text_in(const TableRow& row, std::string_view column);

/// Layout of a table.tsv that lists runs, one per line, for programs that were run on several machines.
struct RunTable {
    std::string (*machine_name)(const TableRow& row) = nullptr;  ///< Name of its machine file, without .toml.
    /// Name of the variant, for a program that the table has more than once; null: its own name.
    std::string (*variant_of)(const TableRow& row) = nullptr;
    /// Reason why a run says nothing about the controller's motion; empty, or null: it is counted.
    std::string (*left_out_for)(const TableRow& row) = nullptr;
};

/// A recorded controller: how its recordings are written and how close gsim shall come to it.
struct Controller {
    std::string_view name;             ///< Name of its folder.
    std::string_view time_key;         ///< Key of the cycle time, s, in the JSON of a recording.
    std::string_view note_key;         ///< Key of a note about the program.
    bool times_dwells = true;          ///< True if recorded dwells are in the controller's own time.
    Tolerance close = {};              ///< Most programs shall be this close ...
    Tolerance fair = {};               ///< ... and all, but for those that known.h lists, this close.
    std::size_t close_percent = 95;    ///< Percentage that is most,
    std::size_t fair_percent = 100;    ///< and all.
    bool from_first_move = false;      ///< Recorded times begin with the first motion, whatever was before.
    int tools = 0;                     ///< It has tools 1 to this many, without lengths.
    std::string_view machines = name;  ///< Prefix of the names of its machine files.
    std::string_view dialect = "rs274ngc";
    const RunTable* runs = nullptr;  ///< All its runs are lines of its table; null: files with figures.
};

/// grblhal-MACHINE, with dashes.
std::string machine_of_grblhal(const TableRow& row);
/// klipper-MACHINE, with dashes.
std::string machine_of_klipper(const TableRow& row);

inline constexpr RunTable kGrblHalRuns{machine_of_grblhal};
inline constexpr RunTable kKlipperRuns{machine_of_klipper};

/// linuxcnc-2.10-MACHINE-pt0, or -pt1-j20000, -pt1-jdef: by planner and jerk.
std::string machine_of_linuxcnc_2_10(const TableRow& row);
/// Planner and jerk alone.
std::string planner_of_linuxcnc_2_10(const TableRow& row);
/// Runs in which that commit fell back to another planner, or left the acceleration limits of the axes.
std::string fault_of_linuxcnc_2_10(const TableRow& row);

inline constexpr RunTable kLinuxcncMasterRuns{machine_of_linuxcnc_2_10, planner_of_linuxcnc_2_10,
                                              fault_of_linuxcnc_2_10};

/// LinuxCNC times a dwell by the wall clock and stops at multiples of its servo period: some ms per program.
/// The second set consists of complete part programs and of single words between moves. The times of grbl are
/// exact. Those of grblHAL are exact, too: they are from its fine clock, which is nearest to the law that it
/// follows. Klipper's times are those that its planner passes on, to 1e-9 s.
inline constexpr std::array kControllers{
    Controller{"linuxcnc", "cycle_time_s", "mode", false, {0.5, 0.005}, {2, 0.005}},
    Controller{"grbl", "cycle_time_nominal_s", "notes", true, {0.2, 0.002}, {1, 0.002}},
    Controller{
        "linuxcnc2", "cycle_time_s", "mode", true, {0.05, 0.002}, {0.5, 0.005}, 85, 97, true, 9, "linuxcnc"},
    Controller{.name = "grblhal",
               .time_key = "cycle_time_fine_clock_s",
               .note_key = "notes",
               .close = {0.1, 0.001},
               .fair = {0.5, 0.005},
               .close_percent = 90,
               .fair_percent = 95,
               .tools = 9,
               .runs = &kGrblHalRuns},
    Controller{.name = "klipper",
               .time_key = "cycle_time_s",
               .note_key = "notes",
               .close = {0.0001, 1e-6},
               .fair = {0.01, 0.001},
               .close_percent = 99,
               .dialect = "klipper",
               .runs = &kKlipperRuns},
    Controller{.name = "linuxcnc-master",
               .time_key = "cycle_time_s",
               .note_key = "mode",
               .close = {0.05, 0.002},
               .fair = {0.5, 0.005},
               .close_percent = 85,
               .fair_percent = 97,
               .from_first_move = true,
               .tools = 9,
               .runs = &kLinuxcncMasterRuns},
};

}  // namespace gsim::accuracy
