#include "engine/src/run/program_run.h"

#include <limits>

#include "engine/src/run/language.h"
#include "engine/src/run/word_table.h"

namespace gsim::engine {

namespace {

/// Returns the number of bytes, limited to the largest number that this system can count.
std::size_t clamp_to_size(std::uint64_t bytes) {
    constexpr std::uint64_t kMax = std::numeric_limits<std::size_t>::max();
    return static_cast<std::size_t>(bytes > kMax ? kMax : bytes);
}

script::Engine::Options make_options(const Request& request, RunInputs& inputs, const RunContext& tools,
                                     ProgressHandler progress) {
    script::Engine::Options options = engine_options(request, std::move(inputs.data), inputs.language, tools);
    options.setup = std::move(inputs.setup);
    options.progress = std::move(progress);
    return options;
}

}  // namespace

CompiledLuaLibrary::CompiledLuaLibrary() : compiled_(std::make_shared<script::CompiledLibraryCache>()) {}

simulation::RunLimits run_limits(const Request& request, os::CpuLimit& cpu) {
    return {.max_time_s = request.limits.machine_s,
            .max_blocks = request.limits.blocks,
            .cpu = &cpu,
            .stop_at_first = request.execution.stop_at_first};
}

script::Engine::Options engine_options(const Request& request, machine::MachineData data,
                                       const Language& language, const RunContext& tools) {
    const os::Files& files = request.host.files.impl();
    script::Engine::Options options;
    options.limits.memory_bytes = clamp_to_size(request.limits.memory_bytes);
    options.limits.steps = request.limits.steps;
    options.cpu = &tools.cpu;
    if (!request.library.empty()) {
        options.library = script::Library(request.library, files);
    } else if (request.compiled_lua_library) {
        options.library = script::Library(request.compiled_lua_library->impl());
    }
    options.data = std::move(data);
    options.find_program = program_finder(files, request.program, language, tools.on_diagnostic);
    options.find_module = module_finder(files, request.program, request.limits.memory_bytes);
    options.dialect = language.dialect->name();
    options.codes = word_table(*language.dialect);
    options.unit_mm = start_unit_mm(language);
    options.block_delete = request.execution.block_delete;
    options.passes = request.execution.passes;
    options.optional_stop = request.execution.optional_stop;
    return options;
}

ProgramRun::ProgramRun(const ResolvedRequest& found, RunInputs inputs, const RunContext& tools,
                       ProgressHandler progress)
    : suggested_fix_search_(found, inputs, tools.cpu),
      simulator_(std::move(inputs.machine), run_limits(found.request, tools.cpu), std::move(inputs.module)),
      cell_(std::move(inputs.cell)),
      document_(std::move(inputs.document)),
      program_(inputs.program.file_name),
      script_(std::move(inputs.program)),
      engine_(simulator_, make_options(found.request, inputs, tools, std::move(progress))) {
    simulator_.set_cell(*cell_);
    simulator_.probing().set_surface(inputs.probe);
    if (!inputs.overrides.changes().empty()) simulator_.motion().set_overrides(inputs.overrides);
}

simulation::Report ProgramRun::run() {
    engine_.run(std::move(script_));
    simulation::Report report = simulator_.finish(program_);
    engine_.report(report);
    suggested_fix_search_.search(report);
    return report;
}

}  // namespace gsim::engine
