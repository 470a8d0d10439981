#include "runtime/monitors/violation_log.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace gsim::simulation {

std::string suggested_fix_text(const Violations& violations) {
    if (violations.suggested_fix.empty()) return {};
    std::string shifts;
    std::string_view offset;
    for (const OffsetShift& shift : violations.suggested_fix) {
        if (!shifts.empty()) shifts += shift.offset == offset ? "," : " and";
        if (!shifts.empty()) shifts += ' ';
        if (shift.offset != offset) shifts += shift.offset + ' ';
        shifts += fmt::format("{} {:+.10g} mm", shift.axis, shift.shift_mm);
        offset = shift.offset;
    }
    return shifts + " would bring the complete program within the limits";
}

// Only listed violations need a time: others would wait long if moves have no length (probes that touch).
void ViolationLog::add_before(rrs::TargetId id, Violation violation) {
    if (moves_ + pending_violations_.size() >= kMaxViolations) return count(violation);
    pending_violations_.push_back({id, std::move(violation)});
}

void ViolationLog::add(Violation violation) {
    count(violation);
    list_.push_back(std::move(violation));
}

void ViolationLog::count(const Violation& violation) {
    ++count_;
    required_shifts_.add(violation);
}

void ViolationLog::insert(Violation violation, double t_s) {
    violation.t_s = t_s;
    ++moves_;
    add(std::move(violation));
}

// A controller may skip a move that is too short for its steps: its time is that of the next one.
void ViolationLog::on_move(const RecordedMove& move) {
    while (!pending_violations_.empty() && pending_violations_.front().id <= move.info.target_id) {
        insert(std::move(pending_violations_.front().violation), move.start_s);
        pending_violations_.pop_front();
    }
}

void ViolationLog::end(double end_s) {
    for (PendingViolation& pending_violation : pending_violations_)
        insert(std::move(pending_violation.violation), end_s);
    pending_violations_.clear();
}

Violations ViolationLog::release(std::uint64_t further) {
    std::stable_sort(list_.begin(), list_.end(),
                     [](const Violation& a, const Violation& b) { return a.t_s < b.t_s; });
    if (list_.size() > kMaxViolations) list_.resize(kMaxViolations);
    Violations violations{
        .list = std::move(list_), .count = count_ + further, .shifts = {}, .suggested_fix = {}};
    if (further == 0) violations.shifts = required_shifts_.shifts();
    return violations;
}

}  // namespace gsim::simulation
