#pragma once

#include <utility>
#include <vector>

namespace gsim::motion {

/// What an operator has turned the overrides to, as shares of what is programmed (1: 100 %).
struct Overrides {
    double feed = 1;
    double rapid = 1;
    double spindle = 1;

    bool operator==(const Overrides&) const = default;
};

/// What a move obeys of them. Not what a program has locked, nor what the kind of the move is deaf to.
struct ObeyedOverrides {
    bool feed = true;
    bool rapid = true;
    bool spindle = false;  ///< Its feed follows the spindle, whose speed the operator has turned.

    /// The share of the programmed speed, or of a rapid's, at which the move goes.
    double share(const Overrides& overrides, bool is_rapid) const {
        if (is_rapid) return rapid ? overrides.rapid : 1;
        return (feed ? overrides.feed : 1) * (spindle ? overrides.spindle : 1);
    }
    bool operator==(const ObeyedOverrides&) const = default;
};

/// The overrides from an instant of the run on.
struct OverrideChange {
    double at_s = 0;
    Overrides to;

    bool operator==(const OverrideChange&) const = default;
};

/// What an operator turns the overrides to in the course of a run: all 1 until the first change.
class OverrideSchedule {
  public:
    OverrideSchedule() = default;
    /// Times are >= 0 and rise. Shares are >= 0; those of the last change are above 0.
    explicit OverrideSchedule(std::vector<OverrideChange> changes) : changes_(std::move(changes)) {}

    const std::vector<OverrideChange>& changes() const { return changes_; }
    /// In force at an instant; a change is at its own.
    Overrides at(double t_s) const;
    /// The first change behind an instant; infinite where none is.
    double next_change_s(double t_s) const;
    /// The first instant from `t_s` on at which `obeyed` lets a move go: `t_s`, or the end of a hold.
    double free_s(double t_s, const ObeyedOverrides& obeyed, bool is_rapid) const;

  private:
    std::vector<OverrideChange> changes_;
};

}  // namespace gsim::motion
