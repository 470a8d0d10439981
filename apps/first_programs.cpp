#include <array>

#include "apps/programs.h"

namespace gsim::apps {

namespace {

constexpr std::array<ProgramEntry, 2> kFirstPrograms{{
    {"gsim-run", "run", make_gsim_run},
    {"gcode2lua", "translate", make_gcode2lua},
}};

}  // namespace

ProgramSet first_programs() {
    return {.programs = kFirstPrograms};
}

}  // namespace gsim::apps
