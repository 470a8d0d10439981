#pragma once

#include <cstdio>
#include <exception>

#include <CLI/CLI.hpp>

#include "apps/exit_status.h"

namespace gsim::apps {

/// What is wrong with options or files, on standard error; the exit status for it.
inline int usage_error(const char* program, const std::string& message) {
    std::fprintf(stderr, "%s: %s\n", program, message.c_str());
    return kUsage;
}

/// The frame of every program: parses the options into `arguments`, runs, and turns what is thrown into a
/// message.
template <typename Arguments>
int run_main(int argc, char** argv, const char* program, const char* description,
             void (*add_options)(CLI::App&, Arguments&), int (*run)(const Arguments&)) {
    try {
        Arguments arguments;
        CLI::App app(description, program);
        add_options(app, arguments);
        try {
            app.parse(argc, argv);
        } catch (const CLI::ParseError& error) {
            return app.exit(error) == 0 ? kDone : kUsage;
        }
        return run(arguments);
    } catch (const std::exception& error) {
        return usage_error(program, error.what());
    }
}

}  // namespace gsim::apps
