#pragma once

#include <memory>

#include "controller/services/types.h"
#include "machine/model/machine.h"
#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/program/program_notifier.h"
#include "runtime/simulator/program/program_position.h"
#include "runtime/simulator/warnings.h"

namespace gsim::simulation {

/// Acceleration and deceleration of moves, as the program selects them.
class RampSettings {
  public:
    /// Begins with the machine's ramps. All arguments must outlive this.
    RampSettings(const machine::Machine& machine, const MachineMotion& motion,
                 const ProgramPosition& position, const ProgramNotifier& notifier, Warnings& warnings)
        : machine_(machine), motion_(motion), position_(position), notifier_(notifier), warnings_(warnings) {}

    /// Sets the ramps of the moves that follow; warns if the controller uses its own.
    void set_mode(rrs::RampMode mode);
    /// Sets a limit of an axis's ramps for the moves that follow, mm or deg, s; > 0. The machine's own limit
    /// applies, too.
    void set_limit(rrs::RampLimit limit, int axis, double value);
    /// Restores the machine's own limits.
    void reset_limits();
    /// Returns the ramps as the program has set them; null if it has not.
    const std::shared_ptr<const motion::ProgrammedRamps>& programmed() const { return programmed_; }
    /// Warns if the machine file requests S-curves and the motion has none.
    void warn_about_jerk();

  private:
    bool has_no_jerk_limit() const;
    bool are_supported();
    template <typename Change>
    void change(const Change& change);

    const machine::Machine& machine_;
    const MachineMotion& motion_;
    const ProgramPosition& position_;
    const ProgramNotifier& notifier_;
    Warnings& warnings_;
    std::shared_ptr<const motion::ProgrammedRamps> programmed_;
};

}  // namespace gsim::simulation
