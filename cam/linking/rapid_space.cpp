#include "cam/linking/rapid_space.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "motion/exact_stop/apart_move.h"
#include "motion/exact_stop/joint_move.h"

namespace gsim::transit {

namespace {

// Heights above the higher end, in mm; the last one is the end of the axis.
constexpr std::array<double, 8> kLifts_mm{5, 10, 20, 40, 80, 160, 320, 1e9};
constexpr int kMostQuestions = 4000;
// Search range of an axis without an end beyond both positions, mm or deg.
constexpr double kBeyond = 360;

}  // namespace

AxisValues shift_of(const Origin& origin, const machine::Machine& machine) {
    AxisValues shift = AxisValues::Zero(static_cast<Eigen::Index>(machine.axes.size()));
    for (const auto& [letter, value] : origin) {
        if (const auto axis = machine.find(letter)) shift[static_cast<Eigen::Index>(*axis)] = value;
    }
    return shift;
}

motion::Segment RapidSpace::straight(const AxisValues& from, const AxisValues& to) const {
    motion::Segment segment;
    segment.kind = motion::SegmentKind::joint;
    segment.start = machine_->joints(from);
    segment.end = machine_->joints(to);
    const double length = (segment.end - segment.start).norm();
    segment.lead = motion::TimeLaw::fastest(length, length, motion::kUnlimited);
    segment.duration_s = segment.lead.duration_s();
    return segment;
}

motion::Segment RapidSpace::rapid(const AxisValues& from, const AxisValues& to) const {
    motion::Segment segment;
    segment.start = machine_->joints(from);
    segment.end = machine_->joints(to);
    const bool is_planned = setup_->controller.interpolated_rapids
                                ? motion::plan_joint_move(*setup_, {}, 1, segment).has_value()
                                : motion::plan_apart(*setup_, {}, segment).has_value();
    // If the machine's axis data give no time law, the path is straight anyway.
    return is_planned ? segment : straight(from, to);
}

std::string RapidSpace::told(const AxisValues& axes, const cell::ItemPair& items) const {
    const Eigen::Vector3d tip = tip_mm(axes);
    const auto name = [this](std::size_t item) { return cell().items[item].name; };
    return fmt::format("({:.4g}, {:.4g}, {:.4g}): '{}' touches '{}'", tip.x(), tip.y(), tip.z(),
                       name(items.first), name(items.second));
}

std::optional<cell::Obstacle> RapidSpace::obstacle(const AxisValues& from, const AxisValues& to,
                                                   double clearance_mm) const {
    return bodies_->obstacle(rapid(from, to), clearance_mm);
}

std::optional<cell::Obstacle> RapidSpace::obstacle_at(const AxisValues& axes, double clearance_mm) const {
    return bodies_->obstacle_at(machine_->joints(axes), clearance_mm);
}

WaySpace RapidSpace::space(const AxisValues& from, const AxisValues& to, double clearance_mm) const {
    WaySpace space;
    space.low = from.cwiseMin(to);
    space.high = from.cwiseMax(to);
    space.pace = AxisValues::Zero(from.size());
    for (Eigen::Index i = 0; i < from.size(); ++i) {
        const machine::Axis& axis = machine_->machine().axes[static_cast<std::size_t>(i)];
        const bool rotary = axis.kind == machine::AxisKind::rotary;
        if (rotary ? !turns_ : axis.letter < 'X' || axis.letter > 'Z') continue;  // U, V and W stay
        const bool wide = rotary || !std::isfinite(axis.max - axis.min);
        space.low[i] = std::max(axis.min, wide ? space.low[i] - kBeyond : axis.min);
        space.high[i] = std::min(axis.max, wide ? space.high[i] + kBeyond : axis.max);
        space.pace[i] = std::isfinite(axis.max_speed) ? 1 / axis.max_speed : 0;
    }
    if (space.pace.isZero()) space.pace.setOnes();
    space.is_clear = [this, clearance_mm](const AxisValues& a, const AxisValues& b) {
        return !obstacle(a, b, clearance_mm);
    };
    space.seconds = [this](const AxisValues& a, const AxisValues& b) { return rapid(a, b).duration_s; };
    return space;
}

// Up, over with the rotations, and down: the usual path, which people can read in a program.
std::optional<Way> RapidSpace::over(const WaySpace& space, const AxisValues& from,
                                    const AxisValues& to) const {
    const auto z = static_cast<Eigen::Index>(*machine_->machine().find('Z'));
    const double higher = std::max(from[z], to[z]);
    const double top = machine_->top_mm().value_or(higher + kBeyond);
    double before = from[z] - 1;
    for (const double lift_mm : kLifts_mm) {
        const double height = std::min(std::ceil(higher + lift_mm), top);
        if (height <= before) break;
        before = height;
        AxisValues up = from;
        AxisValues over = to;
        up[z] = over[z] = height;
        if (space.is_clear(from, up) && space.is_clear(over, to) && space.is_clear(up, over))
            return Way{up, over, to};
    }
    return std::nullopt;
}

std::optional<Way> RapidSpace::find(const AxisValues& from, const AxisValues& to, double clearance_mm) const {
    const WaySpace space = this->space(from, to, clearance_mm);
    if (space.is_clear(from, to)) return Way{to};
    if (auto way = over(space, from, to)) return way;
    return search_way(space, from, to, kMostQuestions);
}

}  // namespace gsim::transit
