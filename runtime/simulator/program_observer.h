#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "machine/model/machine.h"
#include "runtime/report/report.h"
#include "runtime/simulator/commands.h"

namespace gsim::simulation {

/// Is told what the program asks of a Simulator, in its order and as soon as the controller has accepted it:
/// moves as they are programmed, not as the controller rounds their corners. `from` and `at` are axis values
/// (mm or deg) where the program has come to.
class ProgramObserver {
  public:
    virtual ~ProgramObserver() = default;
    /// About the memory that it holds of what it has been told.
    virtual std::size_t held_bytes() const { return 0; }
    /// `rotary_alone`: the feed is that of rotary axes.
    virtual void line(const AxisVector& /*from*/, const LineMove& /*move*/, bool /*rotary_alone*/) {}
    virtual void arc(const AxisVector& /*from*/, const ArcMove& /*move*/) {}
    virtual void arc(const AxisVector& /*from*/, const ViaMove& /*move*/) {}
    virtual void dwell(const AxisVector& /*at*/, double /*seconds*/) {}
    /// `event` without its time; whether the machine comes to rest for it.
    virtual void event(const AxisVector& /*at*/, const Event& /*event*/, bool /*at_rest*/) {}
    virtual void enter_program(const std::string& /*name*/) {}
    virtual void leave_program() {}
    /// Motion that is told by none of the above, such as a target of the controller's services; `why` is a
    /// sentence.
    virtual void untold_motion(std::string_view /*why*/) {}

    // What the program selects for what follows.

    /// The machine comes to rest before the next move.
    virtual void rest(const AxisVector& /*at*/) {}
    virtual void spindle_speed(const AxisVector& /*at*/, double /*rev_min*/) {}
    virtual void path_mode(const AxisVector& /*at*/, const PathPassing& /*passing*/) {}
    /// The next move alone ends in an exact stop.
    virtual void exact_stop_once(const AxisVector& /*at*/) {}
    virtual void ramps(const AxisVector& /*at*/, rrs::RampMode /*mode*/) {}
    /// A limit of an axis's ramps, mm or deg, s.
    virtual void ramp_limit(const AxisVector& /*at*/, rrs::RampLimit /*limit*/, const machine::Axis& /*axis*/,
                            double /*value*/) {}
    /// The machine's own limits alone.
    virtual void no_ramp_limits(const AxisVector& /*at*/) {}
    virtual void work_offset(const WorkOffset& /*offset*/) {}
    /// How far the machine's position is from the tool's end, which moves from here on have in them.
    virtual void tool_offset(const Eigen::Vector3d& /*offset_mm*/) {}
};

}  // namespace gsim::simulation
