// gsim and all its programs.

#include "apps/program_main.h"

int main(int argc, char** argv) {
    return gsim::apps::program_main(gsim::apps::all_programs(), argc, argv);
}
