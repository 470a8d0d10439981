#pragma once

#include <string>

#include "runtime/simulation/commands.h"
#include "runtime/simulation/report.h"

namespace gsim::simulation {

/// Is told what the program asks of a Simulator, in its order and as soon as the controller has accepted it:
/// moves as they are programmed, not as the controller rounds their corners. `from` and `at` are axis values
/// (mm or deg) where the program has come to.
class ProgramObserver {
  public:
    virtual ~ProgramObserver() = default;
    /// `rotary_alone`: the feed is that of rotary axes.
    virtual void line(const AxisVector& /*from*/, const LineMove& /*move*/, bool /*rotary_alone*/) {}
    virtual void arc(const AxisVector& /*from*/, const ArcMove& /*move*/) {}
    virtual void arc(const AxisVector& /*from*/, const ViaMove& /*move*/) {}
    virtual void dwell(const AxisVector& /*at*/, double /*seconds*/) {}
    /// `event` without its time.
    virtual void event(const AxisVector& /*at*/, const Event& /*event*/) {}
    virtual void enter_program(const std::string& /*name*/) {}
    virtual void leave_program() {}
    /// A target that a script has queued, or taken back, by the controller's services.
    virtual void service_motion() {}
};

}  // namespace gsim::simulation
