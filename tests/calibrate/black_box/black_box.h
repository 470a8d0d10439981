#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "calibrate/times/choice.h"
#include "machine/model/machine.h"
#include "tests/accuracy/recording.h"

namespace gsim::calibrate {

/// The runs of one control on one machine, of whose inside nothing is known.
struct BlackBox {
    std::string name;  ///< Of its machine file, without .toml.
    std::vector<accuracy::Recording> recordings;
};

/// The recordings of a control by machine. What says nothing of motion, and runs in which an operator turned
/// overrides, are left out.
std::vector<BlackBox> black_boxes(const std::vector<accuracy::Recording>& recordings);

/// What somebody knows of a machine who has not looked into its control: axes, ranges and speeds.
/// Accelerations are all the same guess, and the control is a generic one.
machine::Machine without_inside(machine::Machine machine);

/// Generic ways of planning, without the corner rule that the control itself goes by: a box whose name begins
/// with grbl or klipper passes corners by junction deviation.
std::vector<Candidate> candidates_for(const std::string& box, const machine::Machine& machine);

/// A run that was not fitted to.
struct Foretold {
    RecordedRun run;
    double time_s = 0;  ///< That was foretold.

    double error_percent() const { return run.error_percent(time_s); }
};

struct BoxOutcome {
    Choice choice;
    std::vector<FittedParameter> parameters;
    std::vector<Foretold> foretold;
    std::vector<std::string> left_out;  ///< Programs that the generic control does not bring to an end, why.

    double mean_percent() const;  ///< Without sign; 0 where nothing was foretold.
    double largest_percent() const;
    std::size_t within(double percent) const;
};

/// Fits to `fitted` runs that a seed chooses among those of at most `most_moves` moves, and foretells all
/// others. `data`: file of tools. The error:
/// there are too few runs, or none of the models can be fitted.
tl::expected<BoxOutcome, std::string> try_box(const BlackBox& box, const machine::Machine& machine,
                                              std::size_t fitted, std::size_t most_moves, std::uint32_t seed,
                                              const std::string& data,
                                              const std::function<void(const std::string&)>& told);

}  // namespace gsim::calibrate
