#include "runtime/report/time_by_limit.h"

#include <algorithm>
#include <map>
#include <string>

#include "runtime/report/limit_name.h"

namespace gsim::simulation {

void TimeByLimit::on_segment(const motion::Segment& segment, const MoveInfo& /*info*/) {
    if (segment.kind == motion::SegmentKind::rest) return dwell_s_.add(segment.duration_s);
    const auto kind = static_cast<std::size_t>(segment.limited_by.kind);
    limits_[kind][static_cast<std::size_t>(segment.limited_by.joint + 1)].add(segment.duration_s);
}

std::vector<LimitTime> TimeByLimit::list(const machine::Machine& machine) const {
    std::map<std::string, double> times_s;  // some limits of several joints have one name
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
        for (std::size_t joint = 0; joint < kJoints; ++joint) {
            const double time_s = limits_[kind][joint].value();
            if (!(time_s > 0)) continue;
            const motion::LimitCause limited_by{static_cast<motion::LimitKind>(kind),
                                                static_cast<std::int8_t>(static_cast<int>(joint) - 1)};
            times_s[describe(limited_by, machine)] += time_s;
        }
    }
    if (dwell_s_.value() > 0) times_s["dwell"] = dwell_s_.value();
    std::vector<LimitTime> list;
    list.reserve(times_s.size());
    for (const auto& [limited_by, time_s] : times_s) list.push_back({limited_by, time_s});
    std::stable_sort(list.begin(), list.end(),
                     [](const LimitTime& a, const LimitTime& b) { return a.time_s > b.time_s; });
    return list;
}

}  // namespace gsim::simulation
