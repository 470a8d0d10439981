// gsim-check: reports the errors of programs on a machine, one line for each finding.

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "apps/confine_run.h"
#include "apps/findings.h"
#include "apps/programs.h"
#include "apps/run_arguments.h"
#include "cli/exit_status.h"
#include "engine/machine.h"
#include "engine/run.h"
#include "engine/system/system_host.h"

namespace gsim::apps {

namespace {

struct CheckArguments {
    RunArguments run;
    std::vector<std::string> programs;
};

constexpr const char* kGsimCheck = "gsim-check";

void add_check_options(CommandLine& line, CheckArguments& a) {
    line.add("part.nc|part.lua", &a.programs, "programs and scripts")
        .takes_file(FileKind::input, {".nc", ".ngc", ".lua"})
        .make_required();
    add_machine_options(line, a.run);
    line.begin_group("Diagnostics");
    add_finding_options(line, a.run.findings);
    add_limit_options(line, a.run);
    line.add_example("gsim-check part.nc", "errors, limits and zones on the built-in machine");
    line.add_example("gsim-check --machine mine.toml --cell cell.toml *.nc",
                     "each program separately, with collisions");
}

// Warnings are reported, but do not affect the status, except those of the process.
int check_program(engine::Request request, const engine::Machine& machine, Findings& findings) {
    const std::string program = request.program;
    const CpuLimitGuard unchecked_cpu_guard(guard_limit_s(request.limits.cpu_s));
    std::vector<engine::Diagnostic> all;
    auto run = engine::Run::open(std::move(request), machine,
                                 [&](const engine::Diagnostic& diagnostic) { all.push_back(diagnostic); });
    auto prepared = run ? run->prepare() : tl::unexpected(run.error());
    if (!prepared) {
        for (const engine::Diagnostic& diagnostic : all) findings.add(diagnostic);
        findings.add_program({.name = program, .status = "not run"});
        return prepared.error().in_program ? kProgramError : findings.fail(prepared.error());
    }
    const auto report = run->go();
    if (!report) return findings.fail(report.error());
    for (const engine::Diagnostic& found : report->diagnostics) findings.add(found);
    findings.add_program({report->program, std::string(name(report->status)), report->cycle_time_s});
    if (report->is_file_missing()) return kUsageError;
    if (!report->passes_check()) return kProgramError;
    findings.print_text(fmt::format("{}: no errors, {:.3f} s\n", report->program, report->cycle_time_s));
    return kSuccess;
}

// Returns the worst status of all programs. A file that cannot be read does not keep the others from being
// checked.
int check_programs(const CheckArguments& arguments, Findings& findings) {
    std::optional<CpuLimitGuard> cpu_guard(std::in_place, guard_limit_s(arguments.run.request.limits.cpu_s));
    engine::Request request = make_request(arguments.run);
    request.host = engine::make_system_host();
    // The machine is read once, before the confinement, because the files that it names may lie anywhere.
    auto machine = engine::Machine::read(request);
    if (!machine) return findings.fail(machine.error());
    for (const engine::Diagnostic& diagnostic : machine->diagnostics()) findings.add(diagnostic);
    if (auto bodies = machine->read_bodies(); !bodies) return findings.fail(bodies.error());
    std::vector<std::string> programs;
    for (const std::string& program : arguments.programs)
        programs.push_back(request.host.find(engine::NameKind::sample, program).value_or(program));
    request.machine_data = machine->machine_data_file();
    if (auto confined = confine_run(arguments.run, request, programs); !confined)
        return findings.fail(text::DiagnosticKind::usage, confined.error().message);
    cpu_guard.reset();
    int status = kSuccess;
    for (const std::string& program : programs) {
        request.program = program;
        status = std::max(status, check_program(request, *machine, findings));
    }
    return status;
}

int run_check(const CheckArguments& arguments) {
    Findings findings(kGsimCheck, arguments.run.findings, Findings::Stream::standard_output);
    return findings.finish(check_programs(arguments, findings), Findings::Stream::standard_output);
}

}  // namespace

std::unique_ptr<Program> make_gsim_check() {
    return std::make_unique<ProgramWithArguments<CheckArguments>>(
        kGsimCheck, "Checks part programs on a machine: errors, limits, zones, collisions", add_check_options,
        run_check);
}

}  // namespace gsim::apps
