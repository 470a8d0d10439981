// gsim-batch: runs many programs on many machines in many variants, with one file of results.

#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "batch/command.h"
#include "cli/print.h"
#include "cli/usage_error.h"

int main(int argc, char** argv) {
    try {
        return gsim::apps::finish_standard_output(gsim::batch::run_command(
            std::filesystem::path(argv[0]).filename(), std::vector<std::string>(argv + 1, argv + argc)));
    } catch (const std::exception& error) {
        return gsim::apps::usage_error("gsim-batch", error.what());
    }
}
