#include "motion/exact_stop/apart_move.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "motion/exact_stop/line_move.h"
#include "motion/path/joint_changes.h"
#include "motion/path/lead_path.h"
#include "motion/profile/rest_law.h"
#include "motion/segment/followers.h"

namespace gsim::motion {

namespace {

constexpr double kWay_mm = 1e-10;  // of an integral between two instants
constexpr int kMostHalvings = 24;
constexpr double kUnlimited_s = 1e-15;  // no limit slows the joint

LawLimits rapid_limits(const PlannerSetup& setup, const MoveRules& rules, int joint) {
    LawLimits limits = law_limits(setup, joint);
    limits.max_speed *= rules.rapid_share;
    return limits;
}

/// Returns the joint that takes longest; none if no joint moves.
std::optional<int> slowest_joint(const PlannerSetup& setup, const MoveRules& rules,
                                 const JointChanges& changes) {
    std::optional<int> slowest;
    double longest_s = 0;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (changes.of(joint) == 0) continue;
        const double least_s = fastest_rest_s(std::abs(changes.of(joint)), rapid_limits(setup, rules, joint));
        if (slowest && least_s <= longest_s) continue;
        slowest = joint;
        longest_s = least_s;
    }
    return slowest;
}

int moving_count(const PlannerSetup& setup, const JointChanges& changes) {
    int count = 0;
    for (int joint = 0; joint < setup.joint_count(); ++joint) count += changes.of(joint) != 0 ? 1 : 0;
    return count;
}

/// Returns the joints that make up the tool's path, as along a line.
std::uint32_t path_joints(const PlannerSetup& setup, const JointChanges& changes) {
    const bool of_position = changes.norm(JointRole::position) > 0;
    const JointRole role = of_position ? JointRole::position : JointRole::secondary;
    std::uint32_t joints = 0;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (changes.of(joint) != 0 && changes.role(joint) == role)
            joints |= std::uint32_t{1} << static_cast<unsigned>(joint);
    }
    return joints;
}

void add_followers(const PlannerSetup& setup, const MoveRules& rules, const JointChanges& changes, int lead,
                   Segment& segment) {
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double change = changes.of(joint);
        if (change == 0 || joint == lead) continue;
        const LawLimits limits = rapid_limits(setup, rules, joint);
        const double least_s = fastest_rest_s(std::abs(change), limits);
        const double duration_s = least_s > kUnlimited_s ? least_s : segment.duration_s;
        segment.add_follower(joint, std::copysign(1.0, change),
                             rest_law(std::abs(change), limits, least_s, duration_s), limits);
    }
}

void add_ends(const TimeLaw& law, std::vector<double>& instants_s) {
    double end_s = 0;
    for (const LawPiece& piece : law.pieces()) instants_s.push_back(end_s += piece.duration_s);
}

/// Integral of the tool's speed between two instants, halved until Simpson's rule no longer gains by it.
class WayIntegral {
  public:
    explicit WayIntegral(const Segment& segment) : segment_(segment) {}

    double between(double from_s, double to_s) const {
        const double half_s = (to_s - from_s) / 2;
        // Speeds jump if no limit of an acceleration exists, so those inside count.
        const double inside_s = half_s * kInside;
        const Part part{from_s, to_s, speed(from_s + inside_s), speed(from_s + half_s),
                        speed(to_s - inside_s)};
        return refined(part, 0);
    }

  private:
    static constexpr double kInside = 1e-12;

    struct Part {
        double from_s;
        double to_s;
        double first;
        double middle;
        double last;

        double simpson() const { return (to_s - from_s) * (first + 4 * middle + last) / 6; }
    };

    double speed(double t_s) const { return segment_.path_speed_mm_s(t_s); }

    double refined(const Part& part, int halvings) const {
        const double middle_s = part.from_s + (part.to_s - part.from_s) / 2;
        const Part left{part.from_s, middle_s, part.first, speed((part.from_s + middle_s) / 2), part.middle};
        const Part right{middle_s, part.to_s, part.middle, speed((middle_s + part.to_s) / 2), part.last};
        const double finer = left.simpson() + right.simpson();
        if (std::abs(finer - part.simpson()) <= kWay_mm || halvings == kMostHalvings) return finer;
        return refined(left, halvings + 1) + refined(right, halvings + 1);
    }

    const Segment& segment_;
};

}  // namespace

Planned plan_apart(const PlannerSetup& setup, const MoveRules& rules, Segment& segment) {
    const JointChanges changes(setup, segment.start, segment.end);
    if (moving_count(setup, changes) < 2) return plan_line(setup, rules, segment);
    const int leading = *slowest_joint(setup, rules, changes);
    LeadPath lead{.length = std::abs(changes.of(leading))};
    lead.limit_by_joint(leading, law_limits(setup, leading), 1);
    if (rules.rapid_share < 1)
        lead.limit_speed(rules.rapid_share * lead.limits.max_speed, {LimitKind::rapid_override, -1});
    segment.kind = SegmentKind::joint;
    if (Planned timed = set_timing(segment, lead, nullptr, rules.least_duration_s); !timed) return timed;
    add_followers(setup, rules, changes, leading, segment);
    segment.apart = kApart | path_joints(setup, changes);
    segment.length_mm = apart_way_mm(segment, segment.duration_s);
    return {};
}

std::vector<double> apart_instants_s(const Segment& segment) {
    std::vector<double> instants_s{segment.duration_s};
    add_ends(segment.lead, instants_s);
    for (const Follower& follower : segment.followers()) add_ends(follower.law, instants_s);
    for (double& instant_s : instants_s) instant_s = std::min(instant_s, segment.duration_s);
    std::sort(instants_s.begin(), instants_s.end());
    instants_s.erase(std::unique(instants_s.begin(), instants_s.end()), instants_s.end());
    return instants_s;
}

double apart_way_mm(const Segment& segment, double t_s) {
    const WayIntegral integral(segment);
    double way_mm = 0;
    double from_s = 0;
    for (const double instant_s : apart_instants_s(segment)) {
        const double to_s = std::min(instant_s, t_s);
        if (to_s > from_s) way_mm += integral.between(from_s, to_s);
        from_s = std::max(from_s, to_s);
    }
    return way_mm;
}

double apart_time_s(const Segment& segment, double way_mm) {
    constexpr int kHalvings = 60;
    double low_s = 0;
    double high_s = segment.duration_s;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle_s = low_s + (high_s - low_s) / 2;
        (apart_way_mm(segment, middle_s) < way_mm ? low_s : high_s) = middle_s;
    }
    return high_s;
}

}  // namespace gsim::motion
