#pragma once

#include <string>

#include "cli/command_line.h"
#include "engine/request.h"

namespace gsim::apps {

/// Adds --dialect and --unknown.
void add_language_options(CommandLine& line, engine::LanguageOptions& options);

}  // namespace gsim::apps
