#pragma once

#include "apps/programs.h"

namespace gsim::apps {

/// Runs the main function of an executable that offers these programs. The name that it is called by, or the
/// first argument, selects the program.
int program_main(const ProgramSet& front, int argc, char** argv);

}  // namespace gsim::apps
