#pragma once

#include <optional>
#include <vector>

#include "toolpath/rotary/axis_moves.h"

namespace gsim::path {

/// Passes moves on, and lines of turning axes that go on with each other, in the same direction at the same
/// feed, as one: what is recorded from a machine whose tip moves when axes turn is many short ways of the
/// tip, but one of the axes. The motion stays what it was, to a tenth of the program's digits.
class MergedLines final : public MoveSink {
  public:
    /// What is given must outlive this.
    MergedLines(MoveSink& sink, const MachineSpace& space, const MoveOptions& options)
        : sink_(sink), space_(space), slack_mm_(options.resolution_mm / 10) {}

    /// Passes on what is left; needed behind the last move.
    void finish() { flush(); }

    void move(const AxisMove& move) override;
    void stand(const AxisValues& axes) override;
    void retract() override;
    void go_to(const MachineWay& way) override;
    void work_offset(const std::string& name) override;
    void dwell(double seconds) override;
    void acceleration(double mm_s2) override;
    void action(const std::string& name) override;
    void call(const SubPath& sub_path) override;
    void note(const TargetId& where, std::string_view sentence) override;

  private:
    void flush();
    void pass(const AxisValues& point);
    bool turns(const AxisMove& move) const;
    bool goes_on(const AxisMove& move) const;
    bool is_between(const AxisValues& point, const AxisValues& end) const;

    MoveSink& sink_;
    const MachineSpace& space_;
    double slack_mm_;
    std::optional<AxisValues> at_;    // behind the last move; none behind a call
    std::optional<AxisMove> line_;    // kept back
    AxisValues start_;                // of line_
    std::vector<AxisValues> passed_;  // points that line_ runs through
};

}  // namespace gsim::path
