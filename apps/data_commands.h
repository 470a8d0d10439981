#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "apps/findings.h"
#include "apps/machine_data_file.h"
#include "engine/machine_data.h"

namespace gsim::apps {

/// What gsim-data is asked to do.
enum class DataCommand { list, get, set, reset, reset_all, check, convert, import };

/// The arguments of gsim-data as they are given.
struct DataArguments {
    std::string file;
    std::string machine;      ///< Empty: the further axes of points are not known.
    FindingOptions findings;  ///< `json`: what is shown is JSON, too.
    DataCommand command = DataCommand::list;
    std::string section;  ///< Empty: all.
    std::string id;
    std::string field;                 ///< Of get; empty: all.
    std::vector<std::string> changes;  ///< Of set: FIELD=VALUE.
    bool inch = false;
    bool metric = false;
    bool create = false;
    bool no_confine = false;
    double wait_s = kLongestWait_s;  ///< For files that another program changes.
    std::string from_json;           ///< Of convert.
    std::string output;              ///< Of convert; empty: the file itself, or standard output for JSON.
    std::string source;              ///< Of import: settings of a control, or a table of one.
    std::string data;                ///< Of import: where offsets and tools go; empty: nowhere.
};

/// Runs one command; prints what it shows. The result is the exit status, or a sentence on options or files.
/// `findings` gets what a check finds.
tl::expected<int, std::string> run_data_command(const DataArguments& arguments, Findings& findings);

}  // namespace gsim::apps
