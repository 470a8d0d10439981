#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "machine/model/machine.h"
#include "runtime/report/report.h"
#include "runtime/simulator/commands.h"

namespace gsim::simulation {

/// Observer of what the program requests from a Simulator, in its order and as soon as the controller has
/// accepted it. Moves are passed as programmed, not with the corners that the controller rounds. `from` and
/// `at` are axis values (mm or deg) that the program has reached.
class ProgramObserver {
  public:
    virtual ~ProgramObserver() = default;
    /// Returns the approximate memory that it holds for what it has received.
    virtual std::size_t retained_bytes() const { return 0; }
    /// `is_rotary_only`: the feed is that of rotary axes.
    virtual void line(const AxisVector& /*from*/, const LineMove& /*move*/, bool /*is_rotary_only*/) {}
    virtual void arc(const AxisVector& /*from*/, const ArcMove& /*move*/) {}
    virtual void arc(const AxisVector& /*from*/, const ViaMove& /*move*/) {}
    virtual void dwell(const AxisVector& /*at*/, double /*seconds*/) {}
    /// `event` has no time; `at_standstill` is true if the machine stops for it.
    virtual void event(const AxisVector& /*at*/, const Event& /*event*/, bool /*at_standstill*/) {}
    virtual void enter_program(const std::string& /*name*/) {}
    virtual void leave_program() {}
    /// Notifies of motion that no function above covers, such as a target of the controller's services; `why`
    /// is a message.
    virtual void on_unrecordable_motion(std::string_view /*why*/) {}

    // Selections of the program for the moves that follow.

    /// The machine comes to a standstill before the next move.
    virtual void standstill(const AxisVector& /*at*/) {}
    virtual void spindle_speed(const AxisVector& /*at*/, double /*rev_min*/) {}
    virtual void path_mode(const AxisVector& /*at*/, const PathModeSettings& /*passing*/) {}
    /// The next move alone ends in an exact stop.
    virtual void exact_stop_once(const AxisVector& /*at*/) {}
    virtual void ramps(const AxisVector& /*at*/, rrs::RampMode /*mode*/) {}
    /// A limit of an axis's ramps, mm or deg, s.
    virtual void ramp_limit(const AxisVector& /*at*/, rrs::RampLimit /*limit*/, const machine::Axis& /*axis*/,
                            double /*value*/) {}
    /// Only the machine's own limits apply.
    virtual void no_ramp_limits(const AxisVector& /*at*/) {}
    virtual void work_offset(const WorkOffset& /*offset*/) {}
    /// Distance of the machine's position from the tool's end; moves from here on include it.
    virtual void tool_offset(const Eigen::Vector3d& /*offset_mm*/) {}
};

}  // namespace gsim::simulation
