#pragma once

#include <map>

namespace gsim::machine {

/// Times that the machine needs for actions started by words of a program, in s: table [times] of a machine
/// file.
struct WordTimes {
    double tool_change_s = 0;
    double tool_table_s = 0;  ///< For G10 if it writes the tool table.
    double coolant_on_s = 0;
    double coolant_off_s = 0;
    double spindle_start_s = 0;
    double spindle_stop_s = 0;
    double process_on_s = 0;  ///< For a word of [process].
    double process_off_s = 0;
    std::map<int, double> codes_s = {};  ///< For M codes by their numbers; precede all others.
    bool before_first_move = true;       ///< Words before the first motion take their time, too.

    bool operator==(const WordTimes&) const = default;
};

}  // namespace gsim::machine
