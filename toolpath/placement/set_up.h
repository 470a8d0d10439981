#pragma once

#include <optional>
#include <set>
#include <string>

#include "toolpath/model/active_modes.h"
#include "toolpath/model/states.h"
#include "toolpath/model/validate.h"

namespace gsim::path {

class MoveSink;

/// Writer of the work offsets and tools that paths name, before the first motion and at each change. A path
/// is in its frame wherever it moves, and returns to it after a sub-path with another one. At its end the
/// frame of its user becomes active again. A tool stays until another one is named.
class PathSetup {
  public:
    /// All arguments must outlive this. `stops`: what a tool change stops; `jet`: the program has one.
    PathSetup(const Program& program, const States& states, std::size_t path, const ToolChangeStops& stops,
              bool jet, MoveSink& sink)
        : program_(program), states_(states), path_(path), stops_(stops), jet_(jet), sink_(sink) {
        if (path != program.root) active_frame_ = states.entry(path).frame.value();
    }

    /// Prepares a target of the path; `at` is the state before it, without its tool.
    std::optional<TargetError> before(std::size_t target, const State& at);
    /// Finishes after the last target of a sub-path.
    std::optional<TargetError> finish(const State& at);
    /// Returns the frames that the following targets may be in.
    std::set<std::string> frames() const;

  private:
    std::optional<TargetError> change(const Inherited<std::string>& frame, const std::optional<Tool>& tool,
                                      const State& at);
    std::optional<TargetError> change_tool(const Tool& tool, const State& at);
    std::optional<TargetError> require_rapid(const TargetId& id) const;
    bool ends_in_other_frame(const SubPath& sub_path_call) const;
    TargetError make_error(std::string message) const { return {{path_, target_}, std::move(message)}; }

    const Program& program_;
    const States& states_;
    std::size_t path_;
    const ToolChangeStops& stops_;
    bool jet_;
    MoveSink& sink_;
    std::optional<std::size_t> target_;
    std::optional<std::string> active_frame_;  // nullopt: that of the path's users, which differ; or none yet
    bool needs_rapid_ = false;                 // since the last motion, or that was in another frame
};

}  // namespace gsim::path
