#pragma once

#include <functional>
#include <string>

#include <tl/expected.hpp>

#include "apps/outputs.h"
#include "engine/inner/language.h"
#include "engine/inner/override_changes.h"
#include "engine/inner/script_input.h"
#include "runtime/script/engine.h"
#include "runtime/simulation/robots_report.h"

namespace gsim::apps {

/// A run of several robots, as the command line asks for it.
struct RobotsRun {
    std::string input;
    std::string robots;  ///< File with the tables [[robot]] and [[conveyor]].
    std::string setup;   ///< Empty: none.
    LanguageNames language;
    OutputNames outputs;  ///< Each robot has files of its own but for the report: moves.left.jsonl.
    simulation::RunLimits limits;
    OverrideOptions overrides;  ///< Of each robot.
    bool collisions = true;     ///< Bodies of machines and cells are looked at.
    script::Engine::Options options;
    /// Called when all is read, before the programs run; the error is a sentence.
    std::function<tl::expected<void, std::string>()> confine;
    TellDiagnostic tell;  ///< Gets what is wrong with programs' texts.
};

/// Runs it and writes its files. The error is a fault of the program, which has been printed, or a sentence
/// on files and options.
tl::expected<simulation::RobotsReport, InputError> run_robots(RobotsRun run);

/// The name of a robot's own file: "moves.left.jsonl" of "moves.jsonl"; empty stays empty.
std::string robots_own_file(const std::string& name, const std::string& robot);

}  // namespace gsim::apps
