#include "motion/linuxcnc/linuxcnc_model.h"

#include <algorithm>
#include <utility>

#include "motion/linuxcnc/piece_of_move.h"

namespace gsim::motion {

using linuxcnc::Piece;

namespace {

constexpr double kShortestPeriod_s = 1e-9;

linuxcnc::Clock clock_of(const rrs::ControllerRules& rules) {
    if (!(rules.servo_period_s >= kShortestPeriod_s)) return {.counts = false};
    return {.period_s = rules.servo_period_s, .counts = true};
}

linuxcnc::Planning planning_of(const PlannerSetup& setup, const rrs::ControllerRules& rules,
                               const linuxcnc::Clock& clock) {
    linuxcnc::Planning planning{.period_s = clock.period_s};
    planning.since_2_10 = rules.linuxcnc_release == rrs::LinuxcncRelease::v2_10;
    planning.s_curves = planning.since_2_10 && rules.limit_jerk;
    planning.path_jerk = planning.s_curves ? setup.path.max_jerk_mm_s3 : kUnlimited;
    return planning;
}

}  // namespace

LinuxcncModel::LinuxcncModel(const PlannerSetup& setup, const rrs::ControllerRules& rules,
                             SegmentOutput& output)
    : setup_(setup),
      axes_(setup),
      clock_(clock_of(rules)),
      planning_(planning_of(setup, rules, clock_)),
      join_rules_{planning_, rules.stop_between_rapid_and_feed, rules.overrides.planned_feed_percent / 100},
      merged_(axes_),
      output_(output),
      pacer_(std::max<std::size_t>(rules.look_ahead_blocks, 1), clock_, planning_, axes_),
      writer_(axes_, output) {}

/// The path of a move that is too short to be made is added to the next line.
Planned LinuxcncModel::add(const PathMove& move) {
    if (!left_out_ || move.kind == SegmentKind::circular) return add_whole(move);
    PathMove line = move;
    line.start = *left_out_;
    return add_whole(line);
}

Planned LinuxcncModel::add_whole(const PathMove& move) {
    if (linuxcnc::may_merge(move) && linuxcnc::surely_makes_piece(setup_, move)) {
        left_out_.reset();
        merge(move);
        return {};
    }
    auto piece = linuxcnc::piece_of(setup_, axes_, move, planning_);
    if (!piece) return tl::unexpected(std::move(piece.error()));
    if (piece->length == 0) {
        left_out_ = move.start;
        return {};
    }
    left_out_.reset();
    if (piece->turns || !linuxcnc::may_merge(move)) {
        end_merged();
        take(*std::move(piece));
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

void LinuxcncModel::come_to_rest() {
    end_merged();
    put_out(true);
    queue_.clear();
    pacer_.clear();
}

rrs::JointPos LinuxcncModel::standing_at(const rrs::JointPos& position) const {
    return left_out_.value_or(position);
}

void LinuxcncModel::clear() {
    merged_.clear();
    queue_.clear();
    pacer_.clear();
    left_out_.reset();
}

void LinuxcncModel::merge(const PathMove& line) {
    if (!merged_.empty() && !merged_.accepts(line)) end_merged();
    merged_.add(line);
}

/// A line that replaces plannable lines is plannable itself, or has no length.
void LinuxcncModel::end_merged() {
    if (merged_.empty()) return;
    auto piece = linuxcnc::piece_of(setup_, axes_, merged_.line(), planning_);
    const bool several = merged_.several();
    merged_.clear();
    if (!piece || !(piece->length > 0)) return;
    if (several) piece->off_way = OffWay::yes;
    take(*std::move(piece));
}

void LinuxcncModel::take(Piece piece) {
    if (queue_.empty()) {
        push(piece);
        return;
    }
    Piece& last = queue_.back().piece;
    const auto blend = linuxcnc::join(last, piece, axes_, join_rules_);
    if (blend && blend->takes_before) {
        last = blend->piece;
    } else {
        linuxcnc::settle(last, planning_);
        if (blend) push(blend->piece);
    }
    push(piece);
    put_out(false);
}

void LinuxcncModel::push(const Piece& piece) {
    if (queue_.empty()) pacer_.start(output_.time_s(), setup_.overrides.get());
    queue_.push().piece = piece;
}

void LinuxcncModel::put_out(bool ended) {
    pacer_.advance(queue_, ended);
    pacer_.drop(writer_.write(queue_, pacer_.ready(), ended));
}

}  // namespace gsim::motion
