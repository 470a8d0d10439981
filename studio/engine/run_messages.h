#pragma once

#include <functional>
#include <string>

#include <tl/expected.hpp>

#include "engine/run.h"

namespace gsim::studio {

class RunSeries;

/// Function that sends a message to the page (Message::bytes()).
using Post = std::function<void(const std::string& bytes)>;

/// Sends a diagnostic of an input or a run.
void send_diagnostic(const engine::Diagnostic& reported, const Post& post);

/// Sends the scene between prepare() and go(), and all motion from then on. `series`, still empty, and `post`
/// must outlive the run. The error: a lack of memory.
tl::expected<void, engine::Error> send_run(engine::Run& run, RunSeries& series, const Post& post);

/// Sends the final data after go(): frames and tools, curves over time, and the report.
tl::expected<void, engine::Error> send_end(const engine::Run& run, const RunSeries& series,
                                           const engine::Report& report, const Post& post);

/// Sends the report alone: for a program with errors.
void send_report(const engine::Report& report, const Post& post);

}  // namespace gsim::studio
