#pragma once

#include <map>

namespace gsim::machine {

/// How long the machine takes for what words of a program set going, in s: table [times] of a machine file.
struct WordTimes {
    double tool_change_s = 0;
    double tool_table_s = 0;  ///< Of G10 where it writes the table of tools.
    double coolant_on_s = 0;
    double coolant_off_s = 0;
    double spindle_start_s = 0;
    double spindle_stop_s = 0;
    double process_on_s = 0;  ///< Of a word of [process].
    double process_off_s = 0;
    std::map<int, double> codes_s = {};  ///< Of M codes by their numbers; before all others.
    bool before_first_move = true;       ///< Words before anything has moved take their time, too.

    bool operator==(const WordTimes&) const = default;
};

}  // namespace gsim::machine
