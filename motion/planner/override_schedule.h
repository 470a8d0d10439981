#pragma once

#include <utility>
#include <vector>

namespace gsim::motion {

/// Operator overrides, as shares of the programmed values (1: 100 %).
struct Overrides {
    double feed = 1;
    double rapid = 1;
    double spindle = 1;

    bool operator==(const Overrides&) const = default;
};

/// Overrides that a move obeys: not those that a program has locked, nor those that do not affect this kind
/// of move.
struct EnabledOverrides {
    bool feed = true;
    bool rapid = true;
    bool spindle = false;  ///< True if its feed follows the spindle with the operator's override.

    /// Returns the share of the programmed speed, or of a rapid's, at which the move runs.
    double share(const Overrides& overrides, bool is_rapid) const {
        if (is_rapid) return rapid ? overrides.rapid : 1;
        return (feed ? overrides.feed : 1) * (spindle ? overrides.spindle : 1);
    }
    bool operator==(const EnabledOverrides&) const = default;
};

/// The overrides from an instant of the run on.
struct OverrideChange {
    double at_s = 0;
    Overrides to;

    bool operator==(const OverrideChange&) const = default;
};

/// Override changes of an operator in the course of a run: all 1 until the first change.
class OverrideSchedule {
  public:
    OverrideSchedule() = default;
    /// Times are >= 0 and rise. Shares are >= 0; those of the last change are above 0.
    explicit OverrideSchedule(std::vector<OverrideChange> changes) : changes_(std::move(changes)) {}

    const std::vector<OverrideChange>& changes() const { return changes_; }
    /// Returns the overrides that are active at an instant; a change is active at its own.
    Overrides at(double t_s) const;
    /// Returns the first change after an instant; infinite if none follows.
    double next_change_s(double t_s) const;
    /// Returns the first instant from `t_s` on at which `enabled_overrides` let a move run: `t_s`, or the end
    /// of a hold.
    double release_time_s(double t_s, const EnabledOverrides& enabled_overrides, bool is_rapid) const;

  private:
    std::vector<OverrideChange> changes_;
};

}  // namespace gsim::motion
