// gsim-run: runs a script or a part program on a simulated machine and tells what it would do.

#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "apps/confine_run.h"
#include "apps/exit_status.h"
#include "apps/findings.h"
#include "apps/machine_data_file.h"
#include "apps/print.h"
#include "apps/programs.h"
#include "apps/robots_run.h"
#include "apps/run_arguments.h"
#include "apps/run_cell.h"
#include "apps/run_engine.h"
#include "apps/run_inputs.h"
#include "apps/variables_file.h"
#include "base/os/file_identity.h"
#include "base/os/file_lock.h"
#include "base/os/output_file.h"
#include "base/text/printable.h"
#include "runtime/machine/machine_file.h"
#include "runtime/simulation/progress.h"
#include "runtime/simulation/report.h"
#include "runtime/simulation/report_diagnostics.h"

namespace {

using namespace gsim;
using apps::RunArguments;
using Kind = text::DiagnosticKind;

constexpr const char* kGsimRun = "gsim-run";
constexpr const char* kNoProgram = "no program given; gsim-run --help tells how";

bool saves_what_it_reads(const RunArguments& arguments) {
    const auto saved = os::identity_of(arguments.save_machine_data);
    return saved && saved == os::identity_of(arguments.machine_data);
}

/// Whether what the control keeps can be written behind the run.
tl::expected<void, std::string> check_kept(const RunArguments& arguments) {
    for (const std::string* file : {&arguments.variables, &arguments.save_machine_data}) {
        if (file->empty()) continue;
        if (auto writable = os::OutputFile::check(*file); !writable) return writable;
    }
    return {};
}

/// What the control keeps, in the files that are asked for; `in_place`: the run has the lock of the machine
/// data.
tl::expected<void, std::string> keep(const RunArguments& arguments, bool in_place, script::Engine& engine,
                                     machine::MachineDataDocument& document) {
    tl::expected<void, std::string> kept;
    if (!arguments.variables.empty()) {
        kept = engine.permanent_variables().and_then([&](const std::map<int, double>& values) {
            return apps::write_variables(arguments.variables, values);
        });
    }
    if (!kept || arguments.save_machine_data.empty()) return kept;
    return engine.machine_data()
        .and_then([&](const machine::MachineData& data) { return document.update(data); })
        .map_error([&](const std::string& error) {
            return fmt::format("{} is not written: {}", arguments.save_machine_data, error);
        })
        .and_then([&] {
            const std::string& file = arguments.save_machine_data;
            return in_place ? apps::save_text(file, document.text())
                            : apps::replace_text(file, document.text(), arguments.wait_s);
        });
}

/// A program with errors is not run: the report says so, for those who read reports alone.
simulation::Report failed_report(const RunArguments& arguments, const machine::Machine& machine,
                                 const apps::InputError& error, const apps::Findings& findings) {
    simulation::Report report;
    report.program = arguments.input == "-" ? "stdin" : arguments.input;
    report.machine = machine.name;
    if (arguments.rcs.empty()) report.controller = machine.controller.model;
    const bool stopped = error.kind == Kind::run_limit;
    report.status = stopped ? simulation::RunStatus::stopped : simulation::RunStatus::alarm;
    report.alarm = simulation::Alarm{};
    report.alarm->kind = error.kind;
    report.alarm->message = "the program has errors: " + error.message;
    if (error.first_error) {
        if (stopped) report.alarm->message = error.first_error->text;
        report.files.push_back(error.first_error->file);
        report.alarm->place = {0, error.first_error->line};
    }
    report.diagnostics = findings.all();
    return report;
}

int status_of(const simulation::Report& report) {
    if (apps::lacks_text(report)) return apps::kUsage;
    const bool clean = report.status == simulation::RunStatus::completed && !apps::has_collisions(report);
    return clean ? apps::kDone : apps::kProgramFault;
}

/// A run with what it was asked for and what it has to tell.
class Run {
  public:
    explicit Run(const RunArguments& given)
        : arguments_(given),
          cpu_(given.max_cpu_s),
          findings_(kGsimRun, given.findings),
          tell_([this](const text::Diagnostic& told) { findings_.take(told); }) {
        arguments_.limits.cpu = &cpu_;
    }

    int run() {
        const bool asks = !arguments_.studies.any();
        const apps::CpuBackstop cpu(asks ? apps::behind_own_limit_s(arguments_.max_cpu_s)
                                         : arguments_.max_cpu_s);
        const int status = run_as_asked();
        // A report has told it all.
        return told_ ? findings_.finish_told(status)
                     : findings_.finish(status, apps::Findings::Stream::standard_output);
    }

  private:
    int fail(Kind kind, const std::string& sentence, const std::string& file = {}) {
        return findings_.fail(kind, sentence, file);
    }

    int run_as_asked() {
        if (const std::string fault = find_contradiction(arguments_); !fault.empty())
            return fail(Kind::usage, fault);
        tl::expected<RunArguments, std::string> found = apps::with_files_found(arguments_);
        if (!found) return fail(Kind::input_file, found.error(), arguments_.cell);
        arguments_ = *std::move(found);
        if (!arguments_.robots.empty()) return run_robots();
        const tl::expected<apps::MachineInput, std::string> input = apps::read_machine(arguments_);
        if (!input) return fail(Kind::input_file, input.error(), arguments_.machine);
        tell_notes(*input);
        if (arguments_.print_machine) {
            told_ = true;
            apps::print(machine::print_machine(input->machine));
            return apps::kDone;
        }
        if (arguments_.studies.any()) return run_studies(input->machine);
        if (arguments_.input.empty()) return fail(Kind::usage, kNoProgram);
        return run_program(*input);
    }

    /// What of a control's settings is not taken over.
    void tell_notes(const apps::MachineInput& input) {
        if (arguments_.quiet) return;
        for (const std::string& note : input.notes)
            findings_.take({.severity = text::Severity::note, .kind = Kind::machine, .text = note});
    }

    /// Nobody else changes what the control keeps from before it is read until it is written. In one order,
    /// so that two runs with the same two files do not wait for each other.
    tl::expected<void, std::string> lock_kept() {
        std::set<std::string> files;
        if (!arguments_.variables.empty()) files.insert(arguments_.variables);
        in_place_ = saves_what_it_reads(arguments_);
        if (in_place_) files.insert(arguments_.save_machine_data);
        for (const std::string& file : files) {
            auto lock = apps::lock_to_change(file, arguments_.wait_s);
            if (!lock) return tl::unexpected(lock.error());
            locks_.push_back(*std::move(lock));
        }
        return {};
    }

    int run_program(const apps::MachineInput& input) {
        if (auto locked = lock_kept(); !locked) return fail(Kind::output, locked.error());
        // Read before the confinement: what it names may lie anywhere.
        auto cell = apps::read_cell_of_run(apps::cell_choice(arguments_), input.machine);
        if (!cell) return fail(Kind::input_file, cell.error(), arguments_.cell);
        arguments_.cell_read = std::make_shared<const cell::Cell>(*std::move(cell));
        auto opened = apps::open_script(arguments_.input);
        if (!opened) return fail(opened.error().kind, opened.error().message, opened.error().file);
        if (auto confined = apps::confine_run(arguments_, {&arguments_.input, 1}); !confined)
            return fail(Kind::usage, confined.error());
        tl::expected<apps::RunInputs, apps::InputError> inputs =
            apps::read_run_inputs(arguments_, input, *opened, tell_);
        if (inputs) return simulate(*std::move(inputs));
        if (!inputs.error().in_program)
            return fail(inputs.error().kind, inputs.error().message, inputs.error().file);
        if (arguments_.findings.json)
            return ended(failed_report(arguments_, input.machine, inputs.error(), findings_),
                         apps::kProgramFault);
        return apps::kProgramFault;
    }

    /// Runs what was read, and writes what was asked for.
    int simulate(apps::RunInputs inputs) {
        apps::ProgramRun run(arguments_, std::move(inputs), !arguments_.quiet && ::isatty(STDERR_FILENO) == 1,
                             tell_);
        tl::expected<apps::Outputs, std::string> outputs =
            apps::Outputs::open(arguments_.outputs, run.simulator());
        if (!outputs) return fail(Kind::output, outputs.error());
        if (auto kept = check_kept(arguments_); !kept) return fail(Kind::output, kept.error());
        simulation::Report report = run.run();
        report.diagnostics = findings_.all();
        outputs->explain(report);
        const tl::expected<void, std::string> path = outputs->make_path(run.program());
        tl::expected<void, std::string> written = outputs->commit(report);
        if (written) written = keep(arguments_, in_place_, run.engine(), run.document());
        if (!written) return failed_late(report, Kind::output, written.error(), apps::kUsage);
        if (!path) return failed_late(report, Kind::path, path.error(), apps::kProgramFault);
        return ended(report, status_of(report));
    }

    /// The report of a run whose outputs lack something. As JSON it says so itself, being all that is
    /// printed.
    int failed_late(simulation::Report& report, Kind kind, const std::string& sentence, int least_status) {
        if (arguments_.findings.json) report.diagnostics.push_back(text::diagnostic_of(kind, sentence));
        const int status = std::max(ended(report, status_of(report)), least_status);
        if (!arguments_.findings.json) fail(kind, sentence);
        return status;
    }

    /// A run of several robots, each with the machine that the file of robots gives it.
    int run_robots() {
        if (arguments_.input.empty()) return fail(Kind::usage, kNoProgram);
        simulation::Progress progress(stderr, false);
        apps::RobotsRun run;
        run.input = arguments_.input;
        run.robots = arguments_.robots;
        run.setup = arguments_.setup;
        run.language = arguments_.language;
        run.outputs = arguments_.outputs;
        run.limits = arguments_.limits;
        run.overrides = arguments_.overrides;
        run.collisions = !arguments_.no_collisions;
        run.confine = [this] { return apps::confine_run(arguments_, {&arguments_.input, 1}); };
        run.tell = tell_;
        run.options = apps::engine_options(arguments_, {}, {}, progress, tell_);
        tl::expected<simulation::RobotsReport, apps::InputError> report = apps::run_robots(std::move(run));
        if (!report) {
            if (report.error().in_program) return apps::kProgramFault;
            return fail(report.error().kind, report.error().message, report.error().file);
        }
        const bool collided = std::any_of(
            report->robots.begin(), report->robots.end(),
            [](const simulation::RobotReport& robot) { return apps::has_collisions(robot.report); });
        const bool completed = report->whole.status == simulation::RunStatus::completed;
        if (apps::lacks_text(report->whole)) return ended(*report, apps::kUsage);
        return ended(*report, completed && !collided ? apps::kDone : apps::kProgramFault);
    }

    /// What is told of a machine without a program.
    int run_studies(const machine::Machine& machine) {
        const auto ended = apps::run_studies(arguments_.studies, machine, apps::cell_choice(arguments_),
                                             {.json = arguments_.findings.json, .quiet = arguments_.quiet});
        if (!ended) return fail(Kind::input_file, ended.error());
        told_ = true;
        return *ended;
    }

    /// Prints the report; `status`.
    int ended(const simulation::Report& report, int status) {
        return printed(report, report, diagnostics_of(report), status);
    }

    int ended(const simulation::RobotsReport& report, int status) {
        std::vector<text::Diagnostic> all = findings_.all();
        for (const simulation::RobotReport& robot : report.robots) {
            const std::vector<text::Diagnostic> own = diagnostics_of(robot.report);
            all.insert(all.end(), own.begin(), own.end());
        }
        return printed(report, report.whole, std::move(all), status);
    }

    template <typename AnyReport>
    int printed(const AnyReport& report, const simulation::Report& whole,
                std::vector<text::Diagnostic> diagnostics, int status) {
        told_ = true;
        findings_.replace(std::move(diagnostics));
        if (arguments_.findings.json) return printed(to_json(report) + '\n', status);
        if (!arguments_.quiet) return printed(to_text(report), status);
        apps::print_faults(whole);
        return status;
    }

    /// What goes to standard output stands alone there: a report for people makes way for it.
    int printed(const std::string& text, int status) const {
        const bool make_way = !arguments_.findings.json &&
                              (arguments_.outputs.on_standard_output() || arguments_.findings.sarif == "-");
        if (make_way) {
            std::fputs(text::printable(text).c_str(), stderr);
        } else {
            apps::print(text::printable(text));
        }
        return status;
    }

    RunArguments arguments_;
    os::CpuLimit cpu_;
    apps::Findings findings_;
    apps::TellDiagnostic tell_;
    std::vector<os::FileLock> locks_;
    bool told_ = false;
    bool in_place_ = false;  // machine data are written back to where they were read
};

int run_simulation(const RunArguments& given) {
    return Run(given).run();
}

}  // namespace

std::unique_ptr<apps::Program> apps::make_gsim_run() {
    return std::make_unique<ProgramOf<RunArguments>>(
        kGsimRun, "Simulates a script or a part program: cycle time, moves, trajectory, what goes wrong",
        add_run_options, run_simulation);
}
