#include "cam/linking/rapid_planner.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "motion/exact_stop/joint_move.h"
#include "motion/exact_stop/uncoordinated_move.h"

namespace gsim::linking {

namespace {

// Heights above the higher end, in mm; the last one is the end of the axis.
constexpr std::array<double, 8> kLifts_mm{5, 10, 20, 40, 80, 160, 320, 1e9};
constexpr int kMaxQueries = 4000;
// Search range of an axis without an end beyond both positions, mm or deg.
constexpr double kSearchMargin = 360;

}  // namespace

AxisValues axis_shift(const Origin& origin, const machine::Machine& machine) {
    AxisValues shift = AxisValues::Zero(static_cast<Eigen::Index>(machine.axes.size()));
    for (const auto& [letter, value] : origin) {
        if (const auto axis = machine.find(letter)) shift[static_cast<Eigen::Index>(*axis)] = value;
    }
    return shift;
}

motion::Segment RapidPlanner::straight_segment(const AxisValues& from, const AxisValues& to) const {
    motion::Segment segment;
    segment.kind = motion::SegmentKind::joint;
    segment.start = machine_->joints(from);
    segment.end = machine_->joints(to);
    const double length = (segment.end - segment.start).norm();
    segment.master = motion::TimeLaw::fastest(length, length, motion::kUnlimited);
    segment.duration_s = segment.master.duration_s();
    return segment;
}

motion::Segment RapidPlanner::rapid(const AxisValues& from, const AxisValues& to) const {
    motion::Segment segment;
    segment.start = machine_->joints(from);
    segment.end = machine_->joints(to);
    const bool is_planned = setup_->controller.coordination.interpolated_rapids
                                ? motion::plan_joint_move(*setup_, {}, 1, segment).has_value()
                                : motion::plan_uncoordinated_move(*setup_, {}, segment).has_value();
    // If the machine's axis data give no time law, the path is straight anyway.
    return is_planned ? segment : straight_segment(from, to);
}

std::string RapidPlanner::collision_text(const AxisValues& axes, const cell::ItemPair& items) const {
    const Eigen::Vector3d tcp = tcp_mm(axes);
    const auto name = [this](std::size_t item) { return cell().items[item].name; };
    return fmt::format("({:.4g}, {:.4g}, {:.4g}): '{}' touches '{}'", tcp.x(), tcp.y(), tcp.z(),
                       name(items.first), name(items.second));
}

std::optional<cell::Obstacle> RapidPlanner::obstacle(const AxisValues& from, const AxisValues& to,
                                                     double clearance_mm) const {
    return bodies_->obstacle(rapid(from, to), clearance_mm);
}

std::optional<cell::Obstacle> RapidPlanner::obstacle_at(const AxisValues& axes, double clearance_mm) const {
    return bodies_->obstacle_at(machine_->joints(axes), clearance_mm);
}

SearchSpace RapidPlanner::space(const AxisValues& from, const AxisValues& to, double clearance_mm) const {
    SearchSpace space;
    space.low = from.cwiseMin(to);
    space.high = from.cwiseMax(to);
    space.s_per_unit = AxisValues::Zero(from.size());
    for (Eigen::Index i = 0; i < from.size(); ++i) {
        const machine::Axis& axis = machine_->machine().axes[static_cast<std::size_t>(i)];
        const bool rotary = axis.kind == machine::AxisKind::rotary;
        if (rotary ? !allows_rotation_ : axis.letter < 'X' || axis.letter > 'Z') continue;  // U, V and W stay
        const bool wide = rotary || !std::isfinite(axis.max - axis.min);
        space.low[i] = std::max(axis.min, wide ? space.low[i] - kSearchMargin : axis.min);
        space.high[i] = std::min(axis.max, wide ? space.high[i] + kSearchMargin : axis.max);
        space.s_per_unit[i] = std::isfinite(axis.max_speed) ? 1 / axis.max_speed : 0;
    }
    if (space.s_per_unit.isZero()) space.s_per_unit.setOnes();
    space.is_clear = [this, clearance_mm](const AxisValues& a, const AxisValues& b) {
        return !obstacle(a, b, clearance_mm);
    };
    space.seconds = [this](const AxisValues& a, const AxisValues& b) { return rapid(a, b).duration_s; };
    return space;
}

// Up, over with the rotations, and down: the usual path, which people can read in a program.
std::optional<AxisPath> RapidPlanner::lifted(const SearchSpace& space, const AxisValues& from,
                                             const AxisValues& to) const {
    const auto z = static_cast<Eigen::Index>(*machine_->machine().find('Z'));
    const double max_z = std::max(from[z], to[z]);
    const double top = machine_->max_z_mm().value_or(max_z + kSearchMargin);
    double before = from[z] - 1;
    for (const double lift_mm : kLifts_mm) {
        const double height = std::min(std::ceil(max_z + lift_mm), top);
        if (height <= before) break;
        before = height;
        AxisValues up = from;
        AxisValues lifted = to;
        up[z] = lifted[z] = height;
        if (space.is_clear(from, up) && space.is_clear(lifted, to) && space.is_clear(up, lifted))
            return AxisPath{up, lifted, to};
    }
    return std::nullopt;
}

std::optional<AxisPath> RapidPlanner::find(const AxisValues& from, const AxisValues& to,
                                           double clearance_mm) const {
    const SearchSpace space = this->space(from, to, clearance_mm);
    if (space.is_clear(from, to)) return AxisPath{to};
    if (auto path = lifted(space, from, to)) return path;
    return search_path(space, from, to, kMaxQueries);
}

}  // namespace gsim::linking
