#pragma once

#include <memory>
#include <string>

#include "cli/command_line.h"

namespace gsim::apps {

/// One of our programs: what can be told to it, and what it does.
class Program {
  public:
    Program() = default;
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    virtual ~Program() = default;

    virtual const CommandLine& command_line() const = 0;
    /// Does what the arguments say that were read into the command line; the exit status.
    virtual int run() const = 0;
};

/// A program whose arguments are the plain values of a structure.
template <typename Arguments>
class ProgramOf final : public Program {
  public:
    using Describe = void (*)(CommandLine&, Arguments&);
    using Run = int (*)(const Arguments&);

    ProgramOf(std::string name, std::string description, Describe describe, Run action)
        : line_(std::move(name), std::move(description)), run_(action) {
        describe(line_, arguments_);
    }
    const CommandLine& command_line() const override { return line_; }
    int run() const override { return run_(arguments_); }

  private:
    Arguments arguments_;
    CommandLine line_;
    Run run_;
};

}  // namespace gsim::apps
