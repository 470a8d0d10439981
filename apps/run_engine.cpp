#include "apps/run_engine.h"

#include <cstdio>

#include <fmt/format.h>

#include "apps/word_table.h"
#include "base/text/printable.h"

namespace gsim::apps {

bool has_collisions(const simulation::Report& report) {
    return report.cell && !report.cell->collisions.empty();
}

bool lacks_text(const simulation::Report& report) {
    return report.alarm && report.alarm->kind == text::DiagnosticKind::file;
}

script::Engine::Options engine_options(const RunArguments& arguments, machine::MachineData data,
                                       const Language& language, simulation::Progress& progress,
                                       const TellDiagnostic& tell) {
    script::Engine::Options options;
    options.limits.memory_bytes = arguments.memory_mb << 20U;
    options.limits.steps = arguments.max_steps;
    options.cpu = arguments.limits.cpu;
    if (!arguments.lua_lib.empty()) options.library = script::Library(arguments.lua_lib);
    options.data = std::move(data);
    options.find_program = program_finder(arguments.input, language, tell);
    options.find_module = module_finder(arguments.input, arguments.memory_mb << 20U);
    options.dialect = language.dialect->name();
    options.codes = word_table(*language.dialect);
    options.unit_mm = start_unit_mm(language);
    options.block_delete = arguments.block_delete;
    options.passes = arguments.passes;
    options.optional_stop = arguments.optional_stop;
    options.progress = [&progress](std::uint64_t done, std::uint64_t total) { progress.update(done, total); };
    return options;
}

namespace {

script::Engine::Options options_of(const RunArguments& arguments, RunInputs& inputs,
                                   simulation::Progress& progress, const TellDiagnostic& tell) {
    script::Engine::Options options =
        engine_options(arguments, std::move(inputs.data), inputs.language, progress, tell);
    options.setup = std::move(inputs.setup);
    return options;
}

}  // namespace

ProgramRun::ProgramRun(const RunArguments& arguments, RunInputs inputs, bool show_progress,
                       const TellDiagnostic& tell)
    : remedy_(arguments, inputs),
      simulator_(std::move(inputs.machine), arguments.limits, std::move(inputs.module)),
      cell_(std::move(inputs.cell)),
      document_(std::move(inputs.document)),
      progress_(stderr, show_progress),
      program_(inputs.program.file_name),
      script_(std::move(inputs.program)),
      engine_(simulator_, options_of(arguments, inputs, progress_, tell)) {
    simulator_.set_cell(*cell_);
    simulator_.set_probe(inputs.probe);
    if (!inputs.overrides.changes().empty()) simulator_.set_overrides(inputs.overrides);
}

simulation::Report ProgramRun::run() {
    engine_.run(std::move(script_));
    progress_.clear();
    simulation::Report report = simulator_.finish(program_);
    engine_.report(report);
    remedy_.look_for(report);
    return report;
}

/// What must be said even where no report is wanted.
void print_faults(const simulation::Report& report) {
    if (has_collisions(report)) std::fprintf(stderr, "collisions: %zu\n", report.cell->collisions.size());
    const auto text_of = [&](const simulation::Place& place) {
        return place.line > 0 ? fmt::format("{}:{}: ", report.files[place.file], place.line) : std::string();
    };
    const auto tell = [](const std::string& line) { std::fputs(text::printable(line).c_str(), stderr); };
    for (const simulation::Violation& violation : report.violations.list)
        tell(fmt::format("{}{}\n", text_of(violation.place), violation.message));
    if (report.violations.count > report.violations.list.size())
        tell(fmt::format("violations in all: {}\n", report.violations.count));
    if (!report.alarm) return;
    tell(fmt::format("{}{}: {}\n", text_of(report.alarm->place), name(report.status), report.alarm->message));
    for (const simulation::OpenCall& call : report.alarm->calls) {
        tell(fmt::format("  in {}, called at {}:{}\n", call.program, report.files[call.place.file],
                         call.place.line));
    }
}

}  // namespace gsim::apps
