#include "apps/programs.h"

#include <array>

#include "apps/studio/studio_request.h"

namespace gsim::apps {

namespace {

constexpr std::array<ProgramEntry, 7> kPrograms{{
    {"gsim-run", "run", make_gsim_run},
    {"gsim-check", "check", make_gsim_check},
    {"gsim-studio", "studio", make_gsim_studio},
    {"gcode2lua", "translate", make_gcode2lua},
    {"autopath", "path", make_autopath},
    {"path2gcode", "write", make_path2gcode},
    {"gsim-data", "data", make_gsim_data},
}};

}  // namespace

ProgramSet all_programs() {
    return {.programs = kPrograms, .studio_handler = handle_studio_request};
}

}  // namespace gsim::apps
