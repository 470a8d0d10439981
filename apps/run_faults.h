#pragma once

#include <string>

#include <tl/expected.hpp>

#include "engine/report.h"
#include "engine/run.h"

namespace gsim::apps {

/// Whether a text that the run was to go on with could not be read: no fault of the program.
bool lacks_text(const engine::Report& report);

/// What must be said even where no report is wanted, on standard error: collisions, and why the run did not
/// complete.
void print_faults(const engine::Report& report);

/// What documents of a run lack, of this code: the first sentence.
tl::expected<void, std::string> fault_of_documents(const engine::Run& run, const std::string& code);

}  // namespace gsim::apps
