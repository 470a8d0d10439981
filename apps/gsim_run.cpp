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
#include "engine/system/host_of_system.h"

namespace {

using namespace gsim;
using apps::RunArguments;
using engine::Failure;
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
        const bool asks = !arguments_.studies.any();
        const double cpu_s = arguments_.request.limits.cpu_s;
        const apps::CpuBackstop cpu(asks ? apps::behind_own_limit_s(cpu_s) : cpu_s);
        const int status = run_as_asked();
        // A report already contains all diagnostics.
        return told_ ? findings_.finish_told(status)
                     : findings_.finish(status, apps::Findings::Stream::standard_output);
    }

  private:
    int run_as_asked() {
        if (const std::string fault = find_contradiction(arguments_); !fault.empty())
            return findings_.fail(text::DiagnosticKind::usage, fault);
        engine::Request request = request_of(arguments_);
        request.host =
            engine::host_of_system(arguments_.module_in_process ? engine::ModulePlace::this_process
                                                                : engine::ModulePlace::own_process);
        if (arguments_.print_machine || arguments_.studies.any() || request.program.empty())
            return run_without_program(request);
        return run_program(std::move(request));
    }

    /// Reports the properties of a machine without a program.
    int run_without_program(engine::Request& request) {
        if (!arguments_.studies.check.empty()) request.machine = arguments_.studies.check;
        auto machine = engine::Machine::read(request);
        if (!machine) return findings_.fail(machine.error());
        for (const std::string& note : machine->notes())
            tell({.severity = engine::Severity::note, .code = "machine", .text = note});
        if (arguments_.print_machine) {
            told_ = true;
            apps::print(machine->file());
            return apps::kDone;
        }
        if (!arguments_.studies.any())
            return findings_.fail(text::DiagnosticKind::usage, "no program given; gsim-run --help tells how");
        const auto ended = apps::run_studies(arguments_.studies, *machine,
                                             {.json = arguments_.findings.json, .quiet = arguments_.quiet});
        if (!ended) return findings_.fail(text::DiagnosticKind::input_file, ended.error());
        told_ = true;
        return *ended;
    }

    /// With --quiet, settings of a controller that are not taken over are not worth a message.
    void tell(const engine::Diagnostic& told) {
        if (!arguments_.quiet || told.code != "machine") findings_.take(told);
    }

    int run_program(engine::Request request) {
        if (request.program == os::kStandardStream) {
            auto text = engine::Text::of_stream(stdin, "stdin");
            if (!text) return findings_.fail(text::DiagnosticKind::file, text.error(), request.program);
            request.text = *std::move(text);
        }
        auto run =
            engine::Run::open(std::move(request), [this](const engine::Diagnostic& told) { tell(told); });
        if (!run) return findings_.fail(run.error());
        if (const auto conflict = apps::conflict_of_outputs(arguments_, *run))
            return findings_.fail(text::DiagnosticKind::input_file, *conflict);
        if (auto locked = kept_.lock(arguments_, *run); !locked)
            return findings_.fail(text::DiagnosticKind::output, locked.error());
        if (const std::string& page = arguments_.outputs.view; !page.empty()) {
            auto opened = apps::ViewPage::open(page);
            if (!opened) return findings_.fail(text::DiagnosticKind::output, opened.error());
            view_ = *std::move(opened);
        }
        if (auto confined = apps::confine_run(arguments_, run->request(), {&run->request().program, 1});
            !confined)
            return findings_.fail(text::DiagnosticKind::usage, confined.error());
        if (auto prepared = run->prepare(); !prepared) return refused(*run, prepared.error());
        return simulate(*run);
    }

    int refused(const engine::Run& run, const Failure& failure) {
        if (!failure.in_program) return findings_.fail(failure);
        if (!arguments_.findings.json) return apps::kProgramFault;
        return ended(run.report_of(failure), apps::kProgramFault);
    }

    /// Runs the program that was read, and writes the requested outputs.
    int simulate(engine::Run& run) {
        auto outputs = apps::RunOutputs::open(arguments_, run);
        if (!outputs) return findings_.fail(text::DiagnosticKind::output, outputs.error());
        if (auto kept = kept_.check(arguments_); !kept)
            return findings_.fail(text::DiagnosticKind::output, kept.error());
        if (view_ != nullptr) {
            if (auto attached = view_->attach(run); !attached)
                return findings_.fail(text::DiagnosticKind::output, attached.error());
        }
        run.show_progress([this](std::uint64_t done, std::uint64_t total) { progress_.update(done, total); });
        const auto report = run.go();
        progress_.clear();
        if (!report) return findings_.fail(report.error());
        auto written = apps::fault_of_documents(run, "output");
        if (written && view_ != nullptr) written = view_->finish(run, *report);
        if (written) written = outputs->commit(*report);
        if (written && view_ != nullptr) written = view_->commit();
        if (written) written = kept_.write(arguments_, run);
        if (!written) return failed_late(*report, "output", written.error(), apps::kUsage);
        if (auto path = apps::fault_of_documents(run, "path"); !path)
            return failed_late(*report, "path", path.error(), apps::kProgramFault);
        return ended(*report, status_of(*report));
    }

    static int status_of(const Report& report) {
        if (report.lacks_file()) return apps::kUsage;
        return report.is_clean() ? apps::kDone : apps::kProgramFault;
    }

    /// Prints the report of a run with incomplete outputs. A JSON report contains the error itself, because
    /// it is the only output.
    int failed_late(const Report& report, const std::string& code, const std::string& sentence,
                    int least_status) {
        const bool json = arguments_.findings.json;
        const Report told = json ? report.with({.code = code, .text = sentence}) : report;
        const int status = std::max(ended(told, status_of(told)), least_status);
        if (!json) findings_.fail(*text::diagnostic_kind(code), sentence);
        return status;
    }

    /// Prints the report and returns `status`.
    int ended(const Report& report, int status) {
        told_ = true;
        std::vector<engine::Diagnostic> diagnostics = report.diagnostics;
        for (const Report& robot : report.robots)
            diagnostics.insert(diagnostics.end(), robot.diagnostics.begin(), robot.diagnostics.end());
        findings_.replace(std::move(diagnostics));
        if (arguments_.findings.json) return printed(report.json() + '\n', status);
        if (!arguments_.quiet) return printed(report.text(), status);
        std::fputs(text::printable(report.faults_text()).c_str(), stderr);
        return status;
    }

    /// Standard output carries one document only, so a report for people is written to standard error
    /// instead.
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
    apps::Findings findings_;
    apps::Progress progress_;
    apps::KeptFiles kept_;
    std::unique_ptr<apps::ViewPage> view_;
    bool told_ = false;
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
