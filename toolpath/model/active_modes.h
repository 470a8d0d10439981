#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "toolpath/json/inherited.h"

namespace gsim::path {

/// Running devices of the machine, by the last action that sets them.
struct ActiveModes {
    Inherited<std::string> spindle;      ///< "spindle_cw", "spindle_ccw" or what stops it.
    Inherited<std::string> speed;        ///< "speed 1200"
    Inherited<std::string> flood, mist;  ///< "flood_on", "waterjet_on", "mist_on" and the like.

    void merge(const ActiveModes& other);
    /// Applies an action.
    void pass(const std::string& action);
    /// Applies what a later element sets.
    void set(const ActiveModes& later);
    bool operator==(const ActiveModes&) const = default;
};

/// Devices that a controller stops at a tool change, though the program does not say so.
struct ToolChangeStops {
    bool spindle = false;
    bool coolant = false;

    bool operator==(const ToolChangeStops&) const = default;
};

/// Returns true if the action is a tool change.
bool is_tool_change(const std::string& action);

/// Returns the actions that restart what a tool change has stopped, in their order. The error is a message:
/// the positions that lead to the change pass on different values.
Result<std::vector<std::string>> restore_actions(const ActiveModes& active_modes,
                                                 const ToolChangeStops& stops);

/// Returns the actions of a target, each tool change among them followed by the restart of what it has
/// stopped. `active_modes`: the state before them. The error is a message, see restored().
Result<std::vector<std::string>> insert_restore_actions(const std::vector<std::string>& actions,
                                                        ActiveModes active_modes,
                                                        const ToolChangeStops& stops);

}  // namespace gsim::path
