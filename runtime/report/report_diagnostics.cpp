#include "runtime/report/report_diagnostics.h"

#include <algorithm>

#include <fmt/format.h>

namespace gsim::simulation {

namespace {

using text::Diagnostic;
using text::DiagnosticKind;
using text::Severity;

class Collector {
  public:
    explicit Collector(const Report& report) : report_(report), all_(report.messages.diagnostics) {}

    std::vector<Diagnostic> collect() {
        add_alarm();
        if (report_.passes)
            add(at(report_.passes->location), Severity::note, DiagnosticKind::passes,
                "passes: " + to_text(*report_.passes));
        add_violations();
        add_findings();
        add_efforts();
        add_cell();
        for (const std::string& warning : report_.messages.warnings) add_warning(warning);
        return std::move(all_);
    }

  private:
    /// Returns a diagnostic at a source location of the run, or about the complete program if the location is
    /// unknown.
    Diagnostic at(const SourceLocation& location) const {
        const bool known = location.line > 0 && location.file < report_.source.files.size();
        Diagnostic diagnostic;
        diagnostic.file = known ? report_.source.files[location.file] : report_.source.program;
        diagnostic.line = known ? location.line : 0;
        return diagnostic;
    }

    void add(Diagnostic diagnostic, Severity severity, DiagnosticKind kind, std::string text) {
        diagnostic.severity = severity;
        diagnostic.kind = kind;
        diagnostic.text = std::move(text);
        all_.push_back(std::move(diagnostic));
    }

    /// Returns true if the alarm is an error of the program's text that kept it from being run.
    bool is_already_reported(const Alarm& alarm) const {
        const Diagnostic location = at(alarm.location);
        return std::any_of(all_.begin(), all_.end(), [&](const Diagnostic& reported) {
            return reported.severity == Severity::error && reported.kind == alarm.kind &&
                   reported.file == location.file && reported.line == location.line;
        });
    }

    void add_alarm() {
        if (!report_.alarm || is_already_reported(*report_.alarm)) return;
        const Alarm& alarm = *report_.alarm;
        add(at(alarm.location), Severity::error, alarm.kind, alarm.message);
        for (const OpenCall& call : alarm.calls)
            add(at(call.location), Severity::note, alarm.kind,
                fmt::format("in {}, called here", call.program));
    }

    void add_violations() {
        const Violations& violations = report_.violations;
        for (const Violation& violation : violations.list) {
            const DiagnosticKind kind =
                violation.zone.empty() ? DiagnosticKind::axis_limit : DiagnosticKind::zone;
            add(at(violation.location), Severity::error, kind, violation.message);
            for (const OpenCall& call : violation.calls)
                add(at(call.location), Severity::note, kind, fmt::format("in {}, called here", call.program));
        }
        if (violations.count > violations.list.size()) {
            add(at({}), Severity::note, DiagnosticKind::axis_limit,
                fmt::format("{} more violations", violations.count - violations.list.size()));
        }
        if (std::string suggested_fix = suggested_fix_text(violations); !suggested_fix.empty())
            add(at({}), Severity::note, DiagnosticKind::axis_limit, std::move(suggested_fix));
    }

    void add_findings() {
        const ProcessFindings& findings = report_.findings;
        for (const ProcessFinding& finding : findings.list)
            add(at(finding.location), Severity::warning, finding.kind, finding.message);
        if (findings.count > findings.list.size()) {
            add(at({}), Severity::warning, findings.list.back().kind,
                fmt::format("{} more process violations", findings.count - findings.list.size()));
        }
    }

    void add_efforts() {
        if (!report_.drives.efforts) return;
        const EffortReport& efforts = *report_.drives.efforts;
        for (const EffortExcess& excess : efforts.excesses) {
            if (excess.continuous) {
                add(at({}), Severity::warning, DiagnosticKind::motor_continuous, excess_text(excess));
            } else {
                add(at(excess.location), Severity::warning, DiagnosticKind::motor_peak, excess_text(excess));
            }
        }
        if (efforts.excess_count > efforts.excesses.size()) {
            add(at({}), Severity::warning, DiagnosticKind::motor_peak,
                fmt::format("{} more moves that need more than a motor can deliver",
                            efforts.excess_count - efforts.excesses.size()));
        }
    }

    void add_cell() {
        if (!report_.cell) return;
        for (const Collision& collision : report_.cell->collisions) {
            add(at(collision.location), Severity::error, DiagnosticKind::collision,
                fmt::format("collision: '{}' and '{}' at {:.3f} s", collision.first, collision.second,
                            collision.t_s));
        }
        for (const BlockClearance& near : report_.cell->clearances) {
            if (near.clearance_mm <= 0) continue;  // of the pairs that meet, reported above
            add(at(near.location), Severity::warning, DiagnosticKind::near_miss,
                fmt::format("near miss: '{}' and '{}', {:.3f} mm", near.first, near.second,
                            near.clearance_mm));
        }
        if (report_.cell->dropped > 0) {
            add(at({}), Severity::warning, DiagnosticKind::near_miss,
                fmt::format("{} more violations in the cell", report_.cell->dropped));
        }
    }

    void add_warning(const std::string& message) {
        Diagnostic diagnostic = text::to_diagnostic(DiagnosticKind::warning, message);
        diagnostic.severity = Severity::warning;
        if (diagnostic.file.empty()) diagnostic.file = report_.source.program;
        all_.push_back(std::move(diagnostic));
    }

    const Report& report_;
    std::vector<Diagnostic> all_;
};

}  // namespace

std::vector<Diagnostic> report_diagnostics(const Report& report) {
    return Collector(report).collect();
}

}  // namespace gsim::simulation
