// gsim-run: runs a script or a part program on a simulated machine and reports what the machine would do.

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "apps/confine_run.h"
#include "apps/findings.h"
#include "apps/machine_data_file.h"
#include "apps/programs.h"
#include "apps/run_arguments.h"
#include "apps/run_files.h"
#include "apps/studio/view_page.h"
#include "base/os/file_lock.h"
#include "base/os/output_file.h"
#include "base/text/printable.h"
#include "cli/exit_status.h"
#include "cli/print.h"
#include "cli/progress.h"
#include "engine/machine.h"
#include "engine/run.h"
#include "engine/system/system_host.h"

namespace {

using namespace gsim;
using apps::RunArguments;
using engine::Report;

constexpr const char* kGsimRun = "gsim-run";

/// A run with its arguments and its reports.
class Run {
  public:
    explicit Run(const RunArguments& given)
        : arguments_(given),
          findings_(kGsimRun, given.findings),
          progress_(stderr, !given.quiet && ::isatty(STDERR_FILENO) == 1) {}

    int run() {
        const bool checks_limit = !arguments_.studies.any();
        const double cpu_s = arguments_.request.limits.cpu_s;
        const apps::CpuLimitGuard cpu(checks_limit ? apps::guard_limit_s(cpu_s) : cpu_s);
        const int status = run_requested();
        // A report already contains all diagnostics.
        return is_reported_ ? findings_.finish_sarif_only(status)
                            : findings_.finish(status, apps::Findings::Stream::standard_output);
    }

  private:
    int run_requested() {
        if (const auto contradiction = find_contradiction(arguments_))
            return findings_.fail(text::DiagnosticKind::usage, contradiction->message);
        engine::Request request = make_request(arguments_);
        request.host =
            engine::make_system_host(arguments_.module_in_process ? engine::ModuleProcess::this_process
                                                                  : engine::ModuleProcess::separate_process);
        if (arguments_.print_machine || arguments_.studies.any() || request.program.empty())
            return run_without_program(request);
        return run_program(std::move(request));
    }

    /// Reports the properties of a machine without a program.
    int run_without_program(engine::Request& request) {
        if (!arguments_.studies.check.empty()) request.machine = arguments_.studies.check;
        auto machine = engine::Machine::read(request);
        if (!machine) return findings_.fail(machine.error());
        for (const engine::Diagnostic& diagnostic : machine->diagnostics()) report_diagnostic(diagnostic);
        if (arguments_.print_machine) {
            is_reported_ = true;
            apps::print(machine->file());
            return apps::kSuccess;
        }
        if (!arguments_.studies.any())
            return findings_.fail(text::DiagnosticKind::usage, "no program given; see gsim-run --help");
        const auto report_end = apps::run_studies(
            arguments_.studies, *machine, {.json = arguments_.findings.json, .quiet = arguments_.quiet});
        if (!report_end) return findings_.fail(text::DiagnosticKind::input_file, report_end.error().message);
        is_reported_ = true;
        return *report_end;
    }

    /// With --quiet, settings of a controller that are not taken over are not worth a message.
    void report_diagnostic(const engine::Diagnostic& reported) {
        if (!arguments_.quiet || reported.code != "machine") findings_.add(reported);
    }

    int run_program(engine::Request request) {
        if (request.program == os::kStandardStream) {
            auto text = engine::Text::from_stream(stdin, "stdin");
            if (!text) return findings_.fail(text::DiagnosticKind::file, text.error(), request.program);
            request.text = *std::move(text);
        }
        auto run = engine::Run::open(
            std::move(request), [this](const engine::Diagnostic& reported) { report_diagnostic(reported); });
        if (!run) return findings_.fail(run.error());
        if (const auto conflict = apps::output_conflict(arguments_, *run))
            return findings_.fail(text::DiagnosticKind::input_file, conflict->message);
        if (auto locked = persistent_files_.lock(arguments_, *run); !locked)
            return findings_.fail(text::DiagnosticKind::output, locked.error().message);
        if (const std::string& page = arguments_.outputs.view; !page.empty()) {
            auto opened = apps::ViewPage::open(page);
            if (!opened) return findings_.fail(text::DiagnosticKind::output, opened.error().message);
            view_ = *std::move(opened);
        }
        if (auto confined = apps::confine_run(arguments_, run->request(), {&run->request().program, 1});
            !confined)
            return findings_.fail(text::DiagnosticKind::usage, confined.error().message);
        if (auto prepared = run->prepare(); !prepared) return report_program_error(*run, prepared.error());
        return simulate(*run);
    }

    int report_program_error(const engine::Run& run, const engine::Error& error) {
        if (!error.in_program) return findings_.fail(error);
        if (!arguments_.findings.json) return apps::kProgramError;
        return report_end(run.make_report(error), apps::kProgramError);
    }

    /// Runs the program that was read, and writes the requested outputs.
    int simulate(engine::Run& run) {
        auto outputs = apps::RunOutputs::open(arguments_, run);
        if (!outputs) return findings_.fail(text::DiagnosticKind::output, outputs.error().message);
        if (auto checked_files = persistent_files_.check(arguments_); !checked_files)
            return findings_.fail(text::DiagnosticKind::output, checked_files.error().message);
        if (view_ != nullptr) {
            if (auto attached = view_->attach(run); !attached)
                return findings_.fail(text::DiagnosticKind::output, attached.error().message);
        }
        run.on_progress([this](std::uint64_t done, std::uint64_t total) { progress_.update(done, total); });
        const auto report = run.go();
        progress_.clear();
        if (!report) return findings_.fail(report.error());
        auto written = apps::document_error(run, "output");
        if (written && view_ != nullptr) written = view_->finish(run, *report);
        if (written) written = outputs->commit(*report);
        if (written && view_ != nullptr) written = view_->commit();
        if (written) written = persistent_files_.write(arguments_, run);
        if (!written)
            return report_output_error(*report, "output", written.error().message, apps::kUsageError);
        if (auto path = apps::document_error(run, "path"); !path)
            return report_output_error(*report, "path", path.error().message, apps::kProgramError);
        return report_end(*report, report_status(*report));
    }

    static int report_status(const Report& report) {
        if (report.is_file_missing()) return apps::kUsageError;
        return report.is_clean() ? apps::kSuccess : apps::kProgramError;
    }

    /// Prints the report of a run with incomplete outputs. A JSON report contains the error itself, because
    /// it is the only output.
    int report_output_error(const Report& report, const std::string& code, const std::string& message,
                            int min_status) {
        const bool json = arguments_.findings.json;
        const Report reported = json ? report.with({.code = code, .text = message}) : report;
        const int status = std::max(report_end(reported, report_status(reported)), min_status);
        if (!json) findings_.fail(*text::diagnostic_kind(code), message);
        return status;
    }

    /// Prints the report and returns `status`.
    int report_end(const Report& report, int status) {
        is_reported_ = true;
        std::vector<engine::Diagnostic> diagnostics = report.diagnostics;
        for (const Report& robot : report.robots)
            diagnostics.insert(diagnostics.end(), robot.diagnostics.begin(), robot.diagnostics.end());
        findings_.replace(std::move(diagnostics));
        if (arguments_.findings.json) return print_report(report.json() + '\n', status);
        if (!arguments_.quiet) return print_report(report.text(), status);
        std::fputs(text::printable(report.errors_text()).c_str(), stderr);
        return status;
    }

    /// Standard output carries one document only, so a report for people is written to standard error
    /// instead.
    int print_report(const std::string& text, int status) const {
        const bool to_standard_error =
            !arguments_.findings.json &&
            (arguments_.outputs.on_standard_output() || arguments_.findings.sarif == "-");
        if (to_standard_error) {
            std::fputs(text::printable(text).c_str(), stderr);
        } else {
            apps::print(text::printable(text));
        }
        return status;
    }

    RunArguments arguments_;
    apps::Findings findings_;
    apps::Progress progress_;
    apps::PersistentFiles persistent_files_;
    std::unique_ptr<apps::ViewPage> view_;
    bool is_reported_ = false;
};

int run_simulation(const RunArguments& given) {
    return Run(given).run();
}

}  // namespace

std::unique_ptr<apps::Program> apps::make_gsim_run() {
    return std::make_unique<ProgramWithArguments<RunArguments>>(
        kGsimRun, "Simulates a script or a part program: cycle time, moves, trajectory, errors",
        add_run_options, run_simulation);
}
