// gsim-check: what is wrong with programs on a machine, in a line for each finding.

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "apps/confine_run.h"
#include "apps/data_file.h"
#include "apps/exit_status.h"
#include "apps/findings.h"
#include "apps/programs.h"
#include "apps/run_engine.h"
#include "apps/run_inputs.h"
#include "runtime/simulation/report_diagnostics.h"

namespace gsim::apps {

namespace {

struct CheckArguments {
    RunArguments run;
    std::vector<std::string> programs;
};

constexpr const char* kCheck = "gsim-check";

void add_check_options(CommandLine& line, CheckArguments& a) {
    line.add("part.nc|part.lua", &a.programs, "programs and scripts")
        .of_file(FileKind::input, {".nc", ".ngc", ".lua"})
        .must_be_given();
    add_machine_options(line, a.run);
    line.begin_group("Diagnostics");
    add_finding_options(line, a.run.findings);
    add_limit_options(line, a.run);
    line.add_example("gsim-check part.nc", "errors, limits and zones on the built-in machine");
    line.add_example("gsim-check --machine mine.toml --cell cell.toml *.nc",
                     "each program on its own, with collisions");
}

using Kind = text::DiagnosticKind;

bool is_clean(const simulation::Report& report) {
    return report.status == simulation::RunStatus::completed && !has_collisions(report) &&
           report.findings.count == 0;
}

// Warnings are told, but do not count, save those of the process.
int check_program(const RunArguments& arguments, const MachineInput& machine, Findings& findings) {
    const TellDiagnostic tell = [&](const text::Diagnostic& told) { findings.take(told); };
    tl::expected<RunInputs, InputError> inputs =
        open_script(arguments.input).and_then([&](OpenedScript opened) {
            return read_run_inputs(arguments, machine, opened, tell);
        });
    if (!inputs) {
        findings.checked({.name = arguments.input, .status = "not run"});
        if (inputs.error().in_program) return kProgramFault;
        return findings.fail(inputs.error().kind, inputs.error().message, inputs.error().file);
    }
    const simulation::Report report = ProgramRun(arguments, *std::move(inputs), false, tell).run();
    for (const text::Diagnostic& found : diagnostics_of(report)) findings.take(found);
    findings.checked({report.program, std::string(name(report.status)), report.cycle_time_s});
    if (lacks_text(report)) return kUsage;
    if (!is_clean(report)) return kProgramFault;
    findings.say(fmt::format("{}: nothing wrong, {:.3f} s\n", report.program, report.cycle_time_s));
    return kDone;
}

// The worst of what was found in all programs: a file that cannot be read does not keep the others from being
// checked.
int check_programs(const CheckArguments& arguments, Findings& findings) {
    std::optional<CpuBackstop> backstop(std::in_place, behind_own_limit_s(arguments.run.max_cpu_s));
    tl::expected<RunArguments, std::string> found = with_files_found(arguments.run);
    if (!found) return findings.fail(Kind::input_file, found.error(), arguments.run.cell);
    const tl::expected<MachineInput, std::string> machine = read_machine(*found);
    if (!machine) return findings.fail(Kind::input_file, machine.error(), found->machine);
    for (const std::string& note : machine->notes)
        findings.take({.severity = text::Severity::note, .kind = Kind::machine, .text = note});
    std::vector<std::string> programs;
    for (const std::string& program : arguments.programs)
        programs.push_back(find_file(InstalledKind::sample, program).value_or(program));
    // Read once, before the confinement: what it names may lie anywhere.
    auto cell = read_cell_of_run(cell_choice(*found), machine->machine);
    if (!cell) return findings.fail(Kind::input_file, cell.error(), found->cell);
    found->cell_read = std::make_shared<const cell::Cell>(*std::move(cell));
    if (auto confined = confine_run(*found, programs); !confined)
        return findings.fail(Kind::usage, confined.error());
    backstop.reset();
    int status = kDone;
    for (const std::string& program : programs) {
        RunArguments one = *found;
        os::CpuLimit cpu(one.max_cpu_s);  // each program on its own
        const CpuBackstop where_nothing_asks(behind_own_limit_s(one.max_cpu_s));
        one.limits.cpu = &cpu;
        one.input = program;
        status = std::max(status, check_program(one, *machine, findings));
    }
    return status;
}

int run_check(const CheckArguments& arguments) {
    Findings findings(kCheck, arguments.run.findings, Findings::Stream::standard_output);
    return findings.finish(check_programs(arguments, findings), Findings::Stream::standard_output);
}

}  // namespace

std::unique_ptr<Program> make_gsim_check() {
    return std::make_unique<ProgramOf<CheckArguments>>(
        kCheck, "Finds what is wrong with part programs on a machine: errors, limits, zones, collisions",
        add_check_options, run_check);
}

}  // namespace gsim::apps
