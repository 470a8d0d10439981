#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "toolpath/json/inherited.h"

namespace gsim::path {

/// What the machine has running, by the last action that says so.
struct Running {
    Inherited<std::string> spindle;      ///< "spindle_cw", "spindle_ccw" or what stops it.
    Inherited<std::string> speed;        ///< "speed 1200"
    Inherited<std::string> flood, mist;  ///< "flood_on", "waterjet_on", "mist_on" and the like.

    void merge(const Running& other);
    /// What an action changes.
    void pass(const std::string& action);
    /// Takes over what something behind it sets.
    void set(const Running& later);
    bool operator==(const Running&) const = default;
};

/// What a control's word for the change of the tool stops, though the program does not say so.
struct ToolChangeStops {
    bool spindle = false;
    bool coolant = false;

    bool operator==(const ToolChangeStops&) const = default;
};

/// Whether the action is a change of the tool.
bool is_tool_change(const std::string& action);

/// The actions behind a change of the tool that set going again what it has stopped, in their order. The
/// error is a sentence: the places that lead to the change hand over different things.
tl::expected<std::vector<std::string>, std::string> restored(const Running& running,
                                                             const ToolChangeStops& stops);

/// The actions of a target, each change of the tool among them followed by what it has stopped and is set
/// going again. `running`: before them. The error is a sentence, see restored().
tl::expected<std::vector<std::string>, std::string> with_restored(const std::vector<std::string>& actions,
                                                                  Running running,
                                                                  const ToolChangeStops& stops);

}  // namespace gsim::path
