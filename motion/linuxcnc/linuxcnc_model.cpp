#include "motion/linuxcnc/linuxcnc_model.h"

#include <algorithm>
#include <utility>

#include "motion/linuxcnc/make_sub_segment.h"

namespace gsim::motion {

using linuxcnc::SubSegment;

namespace {

constexpr double kShortestPeriod_s = 1e-9;

linuxcnc::Clock make_clock(const rrs::PositionLoopRules& rules) {
    if (!(rules.servo_period_s >= kShortestPeriod_s)) return {.counts = false};
    return {.period_s = rules.servo_period_s, .counts = true};
}

linuxcnc::PlanningRules make_planning(const PlannerSetup& setup, const rrs::ControllerRules& rules,
                                      const linuxcnc::Clock& clock) {
    linuxcnc::PlanningRules planning{.period_s = clock.period_s};
    planning.since_2_10 = rules.linuxcnc.release == rrs::LinuxcncRelease::v2_10;
    planning.s_curves = planning.since_2_10 && rules.ramps.limit_jerk;
    planning.path_jerk = planning.s_curves ? setup.path.max_jerk_mm_s3 : kUnlimited;
    return planning;
}

}  // namespace

LinuxcncModel::LinuxcncModel(const PlannerSetup& setup, const rrs::ControllerRules& rules,
                             SegmentOutput& output)
    : setup_(setup),
      axes_(setup),
      clock_(make_clock(rules.position_loop)),
      planning_(make_planning(setup, rules, clock_)),
      join_rules_{planning_, rules.corners.stop_between_rapid_and_feed,
                  rules.overrides.planned_feed_percent / 100},
      merged_(axes_),
      output_(output),
      velocity_planner_(std::max<std::size_t>(rules.blocks.look_ahead, 1), clock_, planning_, axes_),
      writer_(axes_, output) {}

/// The path of a move that is too short to be made is added to the next line.
PlanResult LinuxcncModel::add(const PathMove& move) {
    if (!skipped_start_ || move.kind == SegmentKind::circular) return add_complete(move);
    PathMove line = move;
    line.start = *skipped_start_;
    return add_complete(line);
}

PlanResult LinuxcncModel::add_complete(const PathMove& move) {
    if (linuxcnc::may_merge(move) && linuxcnc::certainly_moves(setup_, move)) {
        skipped_start_.reset();
        merge(move);
        return {};
    }
    auto sub_segment = linuxcnc::make_sub_segment(setup_, axes_, move, planning_);
    if (!sub_segment) return tl::unexpected(std::move(sub_segment.error()));
    if (sub_segment->length == 0) {
        skipped_start_ = move.start;
        return {};
    }
    skipped_start_.reset();
    if (sub_segment->turns || !linuxcnc::may_merge(move)) {
        finish_merged_line();
        add_part(*std::move(sub_segment));
        return {};
    }
    // LinuxCNC merges an arc of little curvature as two lines through its middle.
    if (move.kind == SegmentKind::circular) {
        const PathMove first = linuxcnc::line_to_middle(move, axes_);
        merge(first);
        merge(linuxcnc::line_to_end(move, first.end));
    } else {
        merge(move);
    }
    return {};
}

void LinuxcncModel::plan_to_standstill() {
    finish_merged_line();
    emit(true);
    queue_.clear();
    velocity_planner_.clear();
}

rrs::JointPos LinuxcncModel::end_position_of(const rrs::JointPos& position) const {
    return skipped_start_.value_or(position);
}

void LinuxcncModel::clear() {
    merged_.clear();
    queue_.clear();
    velocity_planner_.clear();
    skipped_start_.reset();
}

void LinuxcncModel::merge(const PathMove& line) {
    if (!merged_.empty() && !merged_.accepts(line)) finish_merged_line();
    merged_.add(line);
}

/// A line that replaces plannable lines is plannable itself, or has no length.
void LinuxcncModel::finish_merged_line() {
    if (merged_.empty()) return;
    auto sub_segment = linuxcnc::make_sub_segment(setup_, axes_, merged_.line(), planning_);
    const bool several = merged_.several();
    merged_.clear();
    if (!sub_segment || !(sub_segment->length > 0)) return;
    if (several) sub_segment->path_deviation = PathDeviation::other;
    add_part(*std::move(sub_segment));
}

void LinuxcncModel::add_part(SubSegment sub_segment) {
    if (queue_.empty()) {
        push(sub_segment);
        return;
    }
    SubSegment& last = queue_.back().sub_segment;
    const auto blend = linuxcnc::join(last, sub_segment, axes_, join_rules_);
    if (blend && blend->absorbs_previous_line) {
        last = blend->sub_segment;
    } else {
        linuxcnc::finalize(last, planning_);
        if (blend) push(blend->sub_segment);
    }
    push(sub_segment);
    emit(false);
}

void LinuxcncModel::push(const SubSegment& sub_segment) {
    if (queue_.empty()) velocity_planner_.start(output_.time_s(), setup_.overrides.get());
    queue_.push().sub_segment = sub_segment;
}

void LinuxcncModel::emit(bool ended) {
    velocity_planner_.advance(queue_, ended);
    velocity_planner_.drop(writer_.write(queue_, velocity_planner_.ready(), ended));
}

}  // namespace gsim::motion
