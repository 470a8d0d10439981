// gcode2lua and gsim-run alone: `make run` builds these in half the time of all programs.

#include "apps/program_main.h"

int main(int argc, char** argv) {
    return gsim::apps::program_main(gsim::apps::first_programs(), argc, argv);
}
