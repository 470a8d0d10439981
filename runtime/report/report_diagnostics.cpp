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
    explicit Collector(const Report& report) : report_(report), all_(report.diagnostics) {}

    std::vector<Diagnostic> collect() {
        add_alarm();
        if (report_.passes)
            add(at(report_.passes->place), Severity::note, DiagnosticKind::passes,
                "passes: " + to_text(*report_.passes));
        add_violations();
        add_findings();
        add_efforts();
        add_cell();
        for (const std::string& warning : report_.warnings) add_warning(warning);
        return std::move(all_);
    }

  private:
    /// Returns a diagnostic at a source location of the run, or about the complete program if the location is
    /// unknown.
    Diagnostic at(const Place& place) const {
        const bool known = place.line > 0 && place.file < report_.files.size();
        Diagnostic diagnostic;
        diagnostic.file = known ? report_.files[place.file] : report_.program;
        diagnostic.line = known ? place.line : 0;
        return diagnostic;
    }

    void add(Diagnostic diagnostic, Severity severity, DiagnosticKind kind, std::string text) {
        diagnostic.severity = severity;
        diagnostic.kind = kind;
        diagnostic.text = std::move(text);
        all_.push_back(std::move(diagnostic));
    }

    /// Returns true if the alarm is an error of the program's text that kept it from being run.
    bool is_told(const Alarm& alarm) const {
        const Diagnostic place = at(alarm.place);
        return std::any_of(all_.begin(), all_.end(), [&](const Diagnostic& told) {
            return told.severity == Severity::error && told.kind == alarm.kind && told.file == place.file &&
                   told.line == place.line;
        });
    }

    void add_alarm() {
        if (!report_.alarm || is_told(*report_.alarm)) return;
        const Alarm& alarm = *report_.alarm;
        add(at(alarm.place), Severity::error, alarm.kind, alarm.message);
        for (const OpenCall& call : alarm.calls)
            add(at(call.place), Severity::note, alarm.kind, fmt::format("in {}, called here", call.program));
    }

    void add_violations() {
        const Violations& violations = report_.violations;
        for (const Violation& violation : violations.list) {
            const DiagnosticKind kind =
                violation.zone.empty() ? DiagnosticKind::axis_limit : DiagnosticKind::zone;
            add(at(violation.place), Severity::error, kind, violation.message);
            for (const OpenCall& call : violation.calls)
                add(at(call.place), Severity::note, kind, fmt::format("in {}, called here", call.program));
        }
        if (violations.count > violations.list.size()) {
            add(at({}), Severity::note, DiagnosticKind::axis_limit,
                fmt::format("{} violations more", violations.count - violations.list.size()));
        }
        if (std::string remedy = remedy_text(violations); !remedy.empty())
            add(at({}), Severity::note, DiagnosticKind::axis_limit, std::move(remedy));
    }

    void add_findings() {
        const ProcessFindings& findings = report_.findings;
        for (const ProcessFinding& finding : findings.list)
            add(at(finding.place), Severity::warning, finding.kind, finding.message);
        if (findings.count > findings.list.size()) {
            add(at({}), Severity::warning, findings.list.back().kind,
                fmt::format("{} findings more of the process", findings.count - findings.list.size()));
        }
    }

    void add_efforts() {
        if (!report_.efforts) return;
        const EffortReport& efforts = *report_.efforts;
        for (const EffortExcess& excess : efforts.excesses) {
            if (excess.continuous) {
                add(at({}), Severity::warning, DiagnosticKind::motor_continuous, excess_text(excess));
            } else {
                add(at(excess.place), Severity::warning, DiagnosticKind::motor_peak, excess_text(excess));
            }
        }
        if (efforts.excess_count > efforts.excesses.size()) {
            add(at({}), Severity::warning, DiagnosticKind::motor_peak,
                fmt::format("{} moves more that need more than a motor brings up",
                            efforts.excess_count - efforts.excesses.size()));
        }
    }

    void add_cell() {
        if (!report_.cell) return;
        for (const Collision& collision : report_.cell->collisions) {
            add(at(collision.place), Severity::error, DiagnosticKind::collision,
                fmt::format("collision: '{}' and '{}' at {:.3f} s", collision.first, collision.second,
                            collision.t_s));
        }
        for (const BlockClearance& near : report_.cell->clearances) {
            if (near.clearance_mm <= 0) continue;  // of the pairs that meet, reported above
            add(at(near.place), Severity::warning, DiagnosticKind::near_miss,
                fmt::format("near miss: '{}' and '{}', {:.3f} mm", near.first, near.second,
                            near.clearance_mm));
        }
        if (report_.cell->dropped > 0) {
            add(at({}), Severity::warning, DiagnosticKind::near_miss,
                fmt::format("{} findings more in the cell", report_.cell->dropped));
        }
    }

    void add_warning(const std::string& sentence) {
        Diagnostic diagnostic = text::diagnostic_of(DiagnosticKind::warning, sentence);
        diagnostic.severity = Severity::warning;
        if (diagnostic.file.empty()) diagnostic.file = report_.program;
        all_.push_back(std::move(diagnostic));
    }

    const Report& report_;
    std::vector<Diagnostic> all_;
};

}  // namespace

std::vector<Diagnostic> diagnostics_of(const Report& report) {
    return Collector(report).collect();
}

}  // namespace gsim::simulation
