#include "apps/run_faults.h"

#include <cstdio>

#include <fmt/format.h>

#include "base/text/printable.h"

namespace gsim::apps {

namespace {

void tell(const std::string& line) {
    std::fputs(text::printable(line).c_str(), stderr);
}

std::string place_text(const engine::Place& place) {
    return place.line > 0 ? fmt::format("{}:{}: ", place.file, place.line) : std::string();
}

}  // namespace

bool lacks_text(const engine::Report& report) {
    return report.alarm && report.alarm->code == "file";
}

void print_faults(const engine::Report& report) {
    if (!report.collisions.empty()) std::fprintf(stderr, "collisions: %zu\n", report.collisions.size());
    for (const engine::Violation& violation : report.violations)
        tell(fmt::format("{}{}\n", place_text(violation.place), violation.message));
    if (report.violation_count > report.violations.size())
        tell(fmt::format("violations in all: {}\n", report.violation_count));
    if (!report.alarm) return;
    tell(fmt::format("{}{}: {}\n", place_text(report.alarm->place), name(report.status),
                     report.alarm->message));
    for (const engine::OpenCall& call : report.alarm->calls)
        tell(fmt::format("  in {}, called at {}:{}\n", call.program, call.place.file, call.place.line));
}

tl::expected<void, std::string> fault_of_documents(const engine::Run& run, const std::string& code) {
    for (const engine::Failure& fault : run.faults()) {
        if (fault.code == code) return tl::unexpected(fault.message);
    }
    return {};
}

}  // namespace gsim::apps
