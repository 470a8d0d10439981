#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/findings.h"
#include "apps/machine_data_file.h"
#include "base/error.h"
#include "engine/machine_data.h"

namespace gsim::apps {

/// Commands of gsim-data.
enum class DataCommand { list, get, set, reset, reset_all, check, convert, import };

/// Arguments of gsim-data as they are given.
struct DataArguments {
    std::string file;
    std::string machine;      ///< Empty: the further axes of points are not known.
    FindingOptions findings;  ///< `json`: what is shown is JSON, too.
    DataCommand command = DataCommand::list;
    std::string section;  ///< Empty: all.
    std::string id;
    std::string field;                 ///< For get; empty: all.
    std::vector<std::string> changes;  ///< For set: FIELD=VALUE.
    bool inch = false;
    bool metric = false;
    bool create = false;
    bool no_confine = false;
    double wait_s = kMaxWait_s;  ///< For files that another program changes.
    std::string from_json;       ///< For convert.
    std::string output;          ///< For convert; empty: the file itself, or standard output for JSON.
    std::string source;          ///< For import: settings of a controller, or one of its tables.
    std::string data;            ///< For import: file for offsets and tools; empty: none.
};

/// Runs one command and prints its output. Returns the exit status, or an error message about options or
/// files. `findings` receives the results of a check.
Result<int> run_data_command(const DataArguments& arguments, Findings& findings);

}  // namespace gsim::apps
