#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "tests/accuracy/blocks.h"
#include "tests/accuracy/controller.h"

namespace gsim::accuracy {

/// A program that a controller ran, and what was recorded: MACHINE_NAME.ngc, .json and .csv.gz.
struct Recording {
    std::string name;               ///< MACHINE_NAME
    std::filesystem::path program;  ///< The part program.
    std::filesystem::path samples;  ///< The trajectory, CSV compressed by gzip.
    std::string machine_file;       ///< Name of the machine file: CONTROLLER-MACHINE.toml.
    std::string dialect = "rs274ngc";
    std::string note;  ///< The mode, or a word about the program.
    double cycle_time_s = 0;
    bool from_first_move = false;  ///< The time begins with the first motion.
    int tools = 0;                 ///< The controller had tools 1 to this many, without lengths.
    std::string overrides = {};    ///< The operator's overrides, as a file for --overrides.
    bool counted = true;           ///< True if the controller timed all of it.
    bool exact_stop = false;       ///< True if it stops after each block (G61.1).
    std::vector<Block> blocks;     ///< Empty if not recorded.
};

/// Returns the recordings in a folder, sorted by name: programs with a JSON of the same name, or with a line
/// in the folder's table.tsv. If the controller has a RunTable, they are the runs that the table lists. The
/// error names the folder or file that cannot be read.
Result<std::vector<Recording>> find_recordings(const std::filesystem::path& folder,
                                               const Controller& controller);

/// Stores the values from the JSON of a recording in it; the error names the missing value.
Result<void> read_recorded_values(const std::string& json_text, const Controller& controller,
                                  Recording& recording);

/// The times of a table by the names of the programs: lines of columns with tabs between, under a line that
/// names them
/// ("name", and the controller's time key). The error says what it lacks.
Result<std::map<std::string, double>> read_times(const std::string& table, const Controller& controller);

/// Returns true if a program has G4 outside its comments.
bool has_dwell(std::string_view program);

}  // namespace gsim::accuracy
