#include <fmt/format.h>

#include "engine/report.h"

namespace gsim::engine {

namespace {

std::string place_text(const Place& place) {
    return place.line > 0 ? fmt::format("{}:{}: ", place.file, place.line) : std::string();
}

std::string alarm_text(const Alarm& alarm, RunStatus status) {
    std::string text = fmt::format("{}{}: {}\n", place_text(alarm.place), name(status), alarm.message);
    for (const OpenCall& call : alarm.calls)
        text += fmt::format("  in {}, called at {}:{}\n", call.program, call.place.file, call.place.line);
    return text;
}

}  // namespace

bool Report::passes_check() const {
    return is_clean() && process_findings == 0;
}

bool Report::lacks_file() const {
    return alarm && alarm->code == "file";
}

std::string Report::faults_text() const {
    std::string text;
    if (!collisions.empty()) text += fmt::format("collisions: {}\n", collisions.size());
    for (const Violation& violation : violations)
        text += fmt::format("{}{}\n", place_text(violation.place), violation.message);
    if (violation_count > violations.size()) text += fmt::format("violations in all: {}\n", violation_count);
    return alarm ? text + alarm_text(*alarm, status) : text;
}

}  // namespace gsim::engine
