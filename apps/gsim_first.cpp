// gcode2lua and gsim-run by themselves: what `make run` builds, in half of the time of all programs.

#include "apps/program_main.h"

int main(int argc, char** argv) {
    return gsim::apps::program_main(gsim::apps::first_programs(), argc, argv);
}
