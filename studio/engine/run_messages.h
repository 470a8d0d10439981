#pragma once

#include <functional>
#include <string>

#include <tl/expected.hpp>

#include "engine/run.h"

namespace gsim::studio {

class RunSeries;

/// Takes a message to the page (Message::bytes()).
using Post = std::function<void(const std::string& bytes)>;

/// A thing to tell of an input or a run.
void post_told(const engine::Diagnostic& told, const Post& post);

/// Between prepare() and go(): what stands in the world, and from now on all that moves. `series`, empty as
/// yet, and `post` must outlive the run. The failure: a lack of memory.
tl::expected<void, engine::Failure> post_run(engine::Run& run, RunSeries& series, const Post& post);

/// Behind go(): what is known now of frames and tools, what there is over time, and the report.
tl::expected<void, engine::Failure> post_end(const engine::Run& run, const RunSeries& series,
                                             const engine::Report& report, const Post& post);

/// The report alone: of a program with errors.
void post_report(const engine::Report& report, const Post& post);

}  // namespace gsim::studio
