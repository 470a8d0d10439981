#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "toolpath/json/inherited.h"
#include "toolpath/model/active_modes.h"
#include "toolpath/model/validate.h"

namespace gsim::path {

/// State at one moment of a program.
struct State {
    Inherited<Vector> position_mm;
    Inherited<Orientation> orientation;
    Inherited<double> feed_mm_min, feed_deg_min;
    Inherited<double> feed_mm_rev;  ///< 0 if feed_mm_min is not per turn of the spindle.
    Inherited<std::string> work_offset;
    Inherited<std::string> frame;  ///< Frame of the current path, as paths and their uses name it.
    Inherited<Tool> tool;          ///< In the spindle, as paths name it.
    Inherited<bool> process_on, abrasive_on;
    Inherited<bool> at_machine_point;  ///< The machine has come to its position by a MachinePoint.
    ActiveModes active_modes;

    void merge(const State& other);
    /// Applies a point, its actions included.
    void pass(const Point& point);
    void pass(const MachinePoint& point);
    bool operator==(const State&) const = default;

  private:
    void apply_actions(const std::vector<std::string>& actions);
};

/// State at the start of each path, over all its uses, and the state after it.
class States {
  public:
    /// `program` must be well formed, and outlive this.
    explicit States(const Program& program);

    const State& entry(std::size_t path) const { return *entries_[path]; }
    /// Returns true if the root leads to it.
    bool used(std::size_t path) const { return entries_[path].has_value(); }
    /// Returns all names that State::frame has there; "" is one.
    const std::set<std::string>& frames(std::size_t path) const { return frames_[path]; }
    /// Prepares the state for a target of a path: sets the tool that the one or the other names.
    void set_up(State& state, std::size_t path, const Target& target) const;
    /// Updates the state to that after any target.
    void pass(State& state, const Target& target) const;
    /// Returns the paths that the root leads to, each after its users.
    const std::vector<std::size_t>& topological_order() const { return order_; }

  private:
    void visit(std::size_t path, std::vector<bool>& seen);
    void enter(const SubPath& sub_path_call, std::size_t user, State state);

    const Program& program_;
    std::vector<std::optional<State>> entries_;
    std::vector<std::set<std::string>> frames_;
    std::vector<std::size_t> order_;
    std::vector<State> changes_;  ///< Values that each path sets; empty if it leaves one unchanged.
};

}  // namespace gsim::path
