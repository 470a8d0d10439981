#pragma once

#include <optional>
#include <vector>

#include "toolpath/rotary/axis_moves.h"

namespace gsim::path {

/// Sink that passes moves on, and merges consecutive lines of turning axes, in the same direction at the same
/// feed, into one. A recording of a machine with a TCP that moves when axes turn has many short TCP paths,
/// but only one of the axes. The motion stays the same, to a tenth of the program's digits.
class MergedLines final : public MoveSink {
  public:
    /// All arguments must outlive this.
    MergedLines(MoveSink& sink, const MachineSpace& space, const MoveOptions& options)
        : sink_(sink), space_(space), budget_mm_(options.resolution_mm / 10) {}

    /// Passes on the remainder; needed after the last move.
    void finish() { flush(); }

    void move(const AxisMove& move) override;
    void set_position(const AxisValues& axes) override;
    void retract() override;
    void go_to(const MachineApproach& machine_path) override;
    void work_offset(const std::string& name) override;
    void dwell(double seconds) override;
    void acceleration(double mm_s2) override;
    void action(const std::string& name) override;
    void call(const SubPath& sub_path) override;
    void note(const TargetId& where, std::string_view message) override;

  private:
    void flush();
    void pass(const AxisValues& point);
    bool turns_rotary(const AxisMove& move) const;
    bool continues(const AxisMove& move) const;
    bool is_between(const AxisValues& point, const AxisValues& end) const;

    MoveSink& sink_;
    const MachineSpace& space_;
    double budget_mm_;
    std::optional<AxisValues> at_;           // after the last move; nullopt after a call
    std::optional<AxisMove> line_;           // kept back
    AxisValues start_;                       // of line_
    std::vector<AxisValues> passed_points_;  // points that line_ runs through
};

}  // namespace gsim::path
