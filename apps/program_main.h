#pragma once

#include "apps/programs.h"

namespace gsim::apps {

/// The main function of an executable that offers these programs: which one is meant is told by the name that
/// it is called by, or by the first argument.
int program_main(const FrontPrograms& front, int argc, char** argv);

}  // namespace gsim::apps
