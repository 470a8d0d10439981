#include "apps/program_main.h"

#include <string>
#include <vector>

#include "apps/program_dispatcher.h"
#include "base/os/standard_streams.h"
#include "base/os/temporary_name.h"
#include "cli/out_of_memory.h"
#include "cli/print.h"

namespace gsim::apps {

int program_main(const ProgramSet& front, int argc, char** argv) {
    exit_on_out_of_memory();
    os::reserve_standard_streams();
    os::remove_temporaries_at_signals();
    const std::vector<std::string> arguments(argv + (argc > 0 ? 1 : 0), argv + argc);
    return finish_standard_output(dispatch_program(front, argc > 0 ? argv[0] : "", arguments));
}

}  // namespace gsim::apps
