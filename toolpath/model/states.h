#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "toolpath/json/inherited.h"
#include "toolpath/model/running.h"
#include "toolpath/model/validate.h"

namespace gsim::path {

/// What holds at one moment of a program.
struct State {
    Inherited<Vector> position_mm;
    Inherited<Orientation> orientation;
    Inherited<double> feed_mm_min, feed_deg_min;
    Inherited<double> feed_mm_rev;  ///< 0 where feed_mm_min is none by turns of the spindle.
    Inherited<std::string> work_offset;
    Inherited<std::string> frame;  ///< Of the path that is gone through, as paths and their uses name it.
    Inherited<Tool> tool;          ///< In the spindle, as paths name it.
    Inherited<bool> jet_on, abrasive_on;
    Inherited<bool> at_machine_point;  ///< The machine has come to where it stands by a MachinePoint.
    Running running;

    void merge(const State& other);
    /// What a point changes, its actions included.
    void pass(const Point& point);
    void pass(const MachinePoint& point);
    bool operator==(const State&) const = default;

  private:
    void act(const std::vector<std::string>& actions);
};

/// What holds where each path begins, over all places that use it, and what holds behind it.
class States {
  public:
    /// `program` must be well formed, and outlive this.
    explicit States(const Program& program);

    const State& entry(std::size_t path) const { return *entries_[path]; }
    /// Whether the root leads to it.
    bool used(std::size_t path) const { return entries_[path].has_value(); }
    /// All names that State::frame has there; "" is one.
    const std::set<std::string>& frames(std::size_t path) const { return frames_[path]; }
    /// Makes ready for a target of a path: with the tool that the one or the other names.
    void set_up(State& state, std::size_t path, const Target& target) const;
    /// The state behind any target.
    void pass(State& state, const Target& target) const;
    /// Paths that the root leads to, each behind all that use it.
    const std::vector<std::size_t>& users_first() const { return order_; }

  private:
    void visit(std::size_t path, std::vector<bool>& seen);
    void enter(const SubPath& use, std::size_t user, State state);

    const Program& program_;
    std::vector<std::optional<State>> entries_;
    std::vector<std::set<std::string>> frames_;
    std::vector<std::size_t> order_;
    std::vector<State> changes_;  ///< What each path sets; nothing where it leaves a value as it was.
};

}  // namespace gsim::path
