// gsim and all its programs: which one is meant is told by the name that it is called by, or by the first
// argument.

#include <string>
#include <vector>

#include "apps/front.h"

int main(int argc, char** argv) {
    const std::vector<std::string> arguments(argv + (argc > 0 ? 1 : 0), argv + argc);
    return gsim::apps::run_front(argc > 0 ? argv[0] : "", arguments);
}
