#pragma once

#include <memory>
#include <string>

#include "cli/command_line.h"

namespace gsim::apps {

/// One of our programs: its command line, and its function.
class Program {
  public:
    Program() = default;
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    virtual ~Program() = default;

    virtual const CommandLine& command_line() const = 0;
    /// Executes the arguments that were read into the command line; returns the exit status.
    virtual int run() const = 0;
};

/// A program with the plain values of a structure as its arguments.
template <typename Arguments>
class ProgramWithArguments final : public Program {
  public:
    using AddOptions = void (*)(CommandLine&, Arguments&);
    using Run = int (*)(const Arguments&);

    ProgramWithArguments(std::string name, std::string description, AddOptions add_options_to, Run action)
        : line_(std::move(name), std::move(description)), run_(action) {
        add_options_to(line_, arguments_);
    }
    const CommandLine& command_line() const override { return line_; }
    int run() const override { return run_(arguments_); }

  private:
    Arguments arguments_;
    CommandLine line_;
    Run run_;
};

}  // namespace gsim::apps
