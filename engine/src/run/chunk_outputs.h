#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/motion.h"
#include "machine/model/machine.h"
#include "runtime/outputs/run_output.h"

namespace gsim::engine {

/// Return outputs that deliver a run in chunks. `machine` and `files`, the names that source locations index,
/// outlive them.
std::unique_ptr<simulation::RunOutput> make_moves_output(MovesHandler callback,
                                                         const machine::Machine& machine,
                                                         const std::vector<std::string>& files);
std::unique_ptr<simulation::RunOutput> make_segments_output(SegmentsHandler callback,
                                                            const machine::Machine& machine);
/// Delivers nothing past `max_time_s` but the last instant, at which a run ends.
std::unique_ptr<simulation::RunOutput> make_samples_output(SamplesHandler callback,
                                                           const machine::Machine& machine, double step_s,
                                                           double max_time_s);

}  // namespace gsim::engine
