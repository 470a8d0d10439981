#include "runtime/simulator/zone_violations.h"

#include <utility>

#include <fmt/format.h>

#include "base/text/number.h"

namespace gsim::simulation {

namespace {

std::string zone_hit_text(const ZoneHit& hit) {
    std::string at;
    std::string walls;
    for (std::size_t i = 0; i < hit.limits.size(); ++i) {
        const char letter = static_cast<char>('X' + i);
        if (hit.tool_mm[i])
            at += fmt::format("{}{}{}", at.empty() ? "" : " ", letter, text::fixed(*hit.tool_mm[i], 4));
        if (!hit.limits[i]) continue;
        walls += fmt::format("{}{} {:.10g} to {:.10g}", walls.empty() ? "" : ", ", letter,
                             text::unsigned_zero(hit.limits[i]->min_mm),
                             text::unsigned_zero(hit.limits[i]->max_mm));
    }
    const char* location = hit.stay_inside ? "inside" : "outside";
    const std::string what =
        hit.is_initial ? fmt::format("the tool is not {} {} when that becomes active", location, hit.zone)
                       : fmt::format("the tool {} {} on axis {}", hit.stay_inside ? "leaves" : "enters",
                                     hit.zone, static_cast<char>('X' + hit.axis));
    return fmt::format(
        "{}, at {} mm after {:.9g} s; the zone is {} mm (machine coordinates of the TCP), and the tool must "
        "stay {} it",
        what, at, hit.time_s, walls, location);
}

std::string zone_violation_message(const ZoneHit& hit, const Violation& violation) {
    const char* location = hit.stay_inside ? "inside" : "outside";
    const std::string what =
        hit.is_initial ? fmt::format("the tool is not {} {} when that becomes active", location, hit.zone)
                       : fmt::format("the tool {} {}", hit.stay_inside ? "leaves" : "enters", hit.zone);
    return fmt::format("{}: it moves {:.10g} mm past the limit at {} {:.10g} mm, and must stay {}", what,
                       violation.amount(), violation.axis, violation.limit, location);
}

}  // namespace

ZoneViolations::ZoneViolations(MachineMotion& motion, const ProgramState& program, RunOutcome& outcome,
                               EventLog& events)
    : motion_(motion), program_(program), outcome_(outcome), events_(events) {
    if (!outcome.limits().stop_at_first)
        motion.zones().continue_after_violations([this](const ZoneHit& hit) { add(hit); });
}

bool ZoneViolations::check() {
    const std::optional<ZoneHit>& hit = motion_.zones().hit();
    return !hit || fail_in_zone(*hit);
}

/// Events past the time limit do not happen.
bool ZoneViolations::fail_in_zone(const ZoneHit& hit) {
    const MoveInfo& move = motion_.recorder().move();
    if (hit.time_s > outcome_.limits().max_time_s) return outcome_.stop_for_time(move.location);
    outcome_.fail_during(move, {.kind = text::DiagnosticKind::zone,
                                .message = zone_hit_text(hit),
                                .axis = static_cast<char>('X' + hit.axis),
                                .value = hit.tool_mm[hit.axis],
                                .limit = hit.wall_mm});
    events_.truncate(hit.time_s);
    return false;
}

/// Records the point where the tool begins to violate a zone's rule; the depth is known later.
void ZoneViolations::add(const ZoneHit& hit) {
    const MoveInfo& move = motion_.recorder().move();
    violations_.push_back({.t_s = hit.time_s,
                           .location = program_.ids().location_of(move),
                           .calls = program_.calls().open().at(move.target_id),
                           .zone = hit.zone,
                           .forbidden_zone = !hit.stay_inside,
                           .axis = static_cast<char>('X' + hit.axis),
                           .limit = hit.wall_mm,
                           .offset = program_.work_offsets().code(move.offset)});
}

void ZoneViolations::release(ViolationLog& log) {
    for (std::size_t i = 0; i < violations_.size(); ++i) {
        const ZoneHit& hit = motion_.zones().hits()[i];
        Violation& violation = violations_[i];
        violation.value = hit.wall_mm + (hit.upwards ? hit.excess_mm : -hit.excess_mm);
        violation.message = zone_violation_message(hit, violation);
        log.add(std::move(violation));
    }
}

}  // namespace gsim::simulation
