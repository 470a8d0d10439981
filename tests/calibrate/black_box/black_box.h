#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/error.h"
#include "calibrate/times/model_selection.h"
#include "machine/model/machine.h"
#include "tests/accuracy/recording.h"

namespace gsim::calibrate {

/// Runs of one controller on one machine, without knowledge of its internals.
struct BlackBox {
    std::string name;  ///< Name of its machine file, without .toml.
    std::vector<accuracy::Recording> recordings;
};

/// Returns the recordings of a controller by machine, without runs that say nothing about motion and runs
/// with overrides by an operator.
std::vector<BlackBox> black_boxes(const std::vector<accuracy::Recording>& recordings);

/// Returns the machine as known without the internals of its controller: axes, ranges and speeds.
/// Accelerations are all the same guess, and the controller is a generic one.
machine::Machine without_inside(machine::Machine machine);

/// Returns generic planning methods, without the corner rule that the controller itself uses. A box with a
/// name that begins with grbl or klipper passes corners by junction deviation.
std::vector<Candidate> candidates_for(const std::string& box, const machine::Machine& machine);

/// A run that was not fitted to.
struct Foretold {
    RecordedRun run;
    double time_s = 0;  ///< Predicted time.

    double error_percent() const { return run.error_percent(time_s); }
};

struct BoxOutcome {
    ModelSelection choice;
    std::vector<FittedParameter> parameters;
    std::vector<Foretold> foretold;
    std::vector<std::string> left_out;  ///< Programs that the generic controller does not complete, and why.

    double mean_percent() const;  ///< Without sign; 0 if none was predicted.
    double largest_percent() const;
    std::size_t within(double percent) const;
};

/// Fits to `fitted` runs that a seed chooses among those of at most `most_moves` moves, and predicts all
/// others. `data`: file of tools. The error: too few runs, or none of the models can be fitted.
Result<BoxOutcome> try_box(const BlackBox& box, const machine::Machine& machine, std::size_t fitted,
                           std::size_t most_moves, std::uint32_t seed, const std::string& data,
                           const std::function<void(const std::string&)>& on_progress);

}  // namespace gsim::calibrate
