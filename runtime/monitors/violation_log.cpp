#include "runtime/monitors/violation_log.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace gsim::simulation {

std::string remedy_text(const Violations& violations) {
    if (violations.remedy.empty()) return {};
    std::string shifts;
    std::string_view offset;
    for (const OffsetShift& shift : violations.remedy) {
        if (!shifts.empty()) shifts += shift.offset == offset ? "," : " and";
        if (!shifts.empty()) shifts += ' ';
        if (shift.offset != offset) shifts += shift.offset + ' ';
        shifts += fmt::format("{} {:+.10g} mm", shift.axis, shift.shift_mm);
        offset = shift.offset;
    }
    return shifts + " would bring the whole program within the limits";
}

// Only listed violations need a time: others would wait long if moves have no length (probes that touch).
void ViolationLog::add_before(rrs::TargetId id, Violation violation) {
    if (moves_ + waiting_.size() >= kMostViolations) return count(violation);
    waiting_.push_back({id, std::move(violation)});
}

void ViolationLog::add(Violation violation) {
    count(violation);
    list_.push_back(std::move(violation));
}

void ViolationLog::count(const Violation& violation) {
    ++count_;
    needs_.add(violation);
}

void ViolationLog::put(Violation violation, double t_s) {
    violation.t_s = t_s;
    ++moves_;
    add(std::move(violation));
}

// A controller may skip a move that is too short for its steps: its time is that of the next one.
void ViolationLog::take(const RecordedMove& move) {
    while (!waiting_.empty() && waiting_.front().id <= move.info.target_id) {
        put(std::move(waiting_.front().violation), move.start_s);
        waiting_.pop_front();
    }
}

void ViolationLog::end(double end_s) {
    for (Waiting& waiting : waiting_) put(std::move(waiting.violation), end_s);
    waiting_.clear();
}

Violations ViolationLog::release(std::uint64_t further) {
    std::stable_sort(list_.begin(), list_.end(),
                     [](const Violation& a, const Violation& b) { return a.t_s < b.t_s; });
    if (list_.size() > kMostViolations) list_.resize(kMostViolations);
    Violations violations{.list = std::move(list_), .count = count_ + further, .shifts = {}, .remedy = {}};
    if (further == 0) violations.shifts = needs_.shifts();
    return violations;
}

}  // namespace gsim::simulation
