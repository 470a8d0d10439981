#include <fmt/format.h>

#include "engine/report.h"

namespace gsim::engine {

namespace {

std::string location_text(const SourceLocation& location) {
    return location.line > 0 ? fmt::format("{}:{}: ", location.file, location.line) : std::string();
}

std::string alarm_text(const Alarm& alarm, RunStatus status) {
    std::string text = fmt::format("{}{}: {}\n", location_text(alarm.location), name(status), alarm.message);
    for (const OpenCall& call : alarm.calls)
        text +=
            fmt::format("  in {}, called at {}:{}\n", call.program, call.location.file, call.location.line);
    return text;
}

}  // namespace

bool Report::passes_check() const {
    return is_clean() && process_findings == 0;
}

bool Report::is_file_missing() const {
    return alarm && alarm->code == "file";
}

std::string Report::errors_text() const {
    std::string text;
    if (!collisions.empty()) text += fmt::format("collisions: {}\n", collisions.size());
    for (const Violation& violation : violations)
        text += fmt::format("{}{}\n", location_text(violation.location), violation.message);
    if (violation_count > violations.size())
        text += fmt::format("violations in total: {}\n", violation_count);
    return alarm ? text + alarm_text(*alarm, status) : text;
}

}  // namespace gsim::engine
