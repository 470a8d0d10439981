// gsim and all its programs: which one is meant is told by the name that it is called by, or by the first
// argument.

#include <string>
#include <vector>

#include "apps/front.h"
#include "apps/out_of_memory.h"
#include "apps/print.h"
#include "base/os/standard_streams.h"
#include "base/os/temporary_name.h"

int main(int argc, char** argv) {
    gsim::apps::end_where_memory_lacks();
    gsim::os::hold_standard_streams();
    gsim::os::remove_temporaries_at_signals();
    const std::vector<std::string> arguments(argv + (argc > 0 ? 1 : 0), argv + argc);
    return gsim::apps::finish_standard_output(gsim::apps::run_front(argc > 0 ? argv[0] : "", arguments));
}
