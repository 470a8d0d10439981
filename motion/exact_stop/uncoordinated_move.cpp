#include "motion/exact_stop/uncoordinated_move.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "motion/exact_stop/line_move.h"
#include "motion/path/joint_changes.h"
#include "motion/path/master_path.h"
#include "motion/profile/rest_to_rest_law.h"
#include "motion/segment/followers.h"

namespace gsim::motion {

namespace {

constexpr double kLengthTolerance_mm = 1e-10;  // of an integral between two instants
constexpr int kMaxHalvings = 24;
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
        const double min_s =
            min_rest_to_rest_s(std::abs(changes.of(joint)), rapid_limits(setup, rules, joint));
        if (slowest && min_s <= longest_s) continue;
        slowest = joint;
        longest_s = min_s;
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
    const bool moves_position = changes.norm(JointRole::position) > 0;
    const JointRole role = moves_position ? JointRole::position : JointRole::secondary;
    std::uint32_t joints = 0;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (changes.of(joint) != 0 && changes.role(joint) == role)
            joints |= std::uint32_t{1} << static_cast<unsigned>(joint);
    }
    return joints;
}

void add_followers(const PlannerSetup& setup, const MoveRules& rules, const JointChanges& changes, int master,
                   Segment& segment) {
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double change = changes.of(joint);
        if (change == 0 || joint == master) continue;
        const LawLimits limits = rapid_limits(setup, rules, joint);
        const double min_s = min_rest_to_rest_s(std::abs(change), limits);
        const double duration_s = min_s > kUnlimited_s ? min_s : segment.duration_s;
        segment.add_follower(joint, std::copysign(1.0, change),
                             rest_to_rest_law(std::abs(change), limits, min_s, duration_s), limits);
    }
}

void add_ends(const TimeLaw& law, std::vector<double>& instants_s) {
    double end_s = 0;
    for (const LawSection& section : law.sections()) instants_s.push_back(end_s += section.duration_s);
}

/// Integral of the tool's speed between two instants, halved until Simpson's rule no longer gains by it.
class PathLengthIntegral {
  public:
    explicit PathLengthIntegral(const Segment& segment) : segment_(segment) {}

    double between(double from_s, double to_s) const {
        const double half_s = (to_s - from_s) / 2;
        // Speeds jump if no limit of an acceleration exists, so those inside count.
        const double inset_s = half_s * kInset;
        const Part part{from_s, to_s, speed(from_s + inset_s), speed(from_s + half_s), speed(to_s - inset_s)};
        return refined_integral(part, 0);
    }

  private:
    static constexpr double kInset = 1e-12;

    struct Part {
        double from_s;
        double to_s;
        double first;
        double middle;
        double last;

        double simpson_integral() const { return (to_s - from_s) * (first + 4 * middle + last) / 6; }
    };

    double speed(double t_s) const { return segment_.path_speed_mm_s(t_s); }

    double refined_integral(const Part& part, int halvings) const {
        const double middle_s = part.from_s + (part.to_s - part.from_s) / 2;
        const Part left{part.from_s, middle_s, part.first, speed((part.from_s + middle_s) / 2), part.middle};
        const Part right{middle_s, part.to_s, part.middle, speed((middle_s + part.to_s) / 2), part.last};
        const double finer_integral = left.simpson_integral() + right.simpson_integral();
        if (std::abs(finer_integral - part.simpson_integral()) <= kLengthTolerance_mm ||
            halvings == kMaxHalvings)
            return finer_integral;
        return refined_integral(left, halvings + 1) + refined_integral(right, halvings + 1);
    }

    const Segment& segment_;
};

}  // namespace

PlanResult plan_uncoordinated_move(const PlannerSetup& setup, const MoveRules& rules, Segment& segment) {
    const JointChanges changes(setup, segment.start, segment.end);
    if (moving_count(setup, changes) < 2) return plan_line(setup, rules, segment);
    const int master_joint = *slowest_joint(setup, rules, changes);
    MasterPath master{.length = std::abs(changes.of(master_joint))};
    master.limit_by_joint(master_joint, law_limits(setup, master_joint), 1);
    if (rules.rapid_share < 1)
        master.limit_speed(rules.rapid_share * master.limits.max_speed, {LimitKind::rapid_override, -1});
    segment.kind = SegmentKind::joint;
    if (PlanResult timed = set_timing(segment, master, nullptr, rules.min_duration_s); !timed) return timed;
    add_followers(setup, rules, changes, master_joint, segment);
    segment.uncoordinated = kApart | path_joints(setup, changes);
    segment.length_mm = uncoordinated_distance_mm(segment, segment.duration_s);
    return {};
}

std::vector<double> uncoordinated_instants_s(const Segment& segment) {
    std::vector<double> instants_s{segment.duration_s};
    add_ends(segment.master, instants_s);
    for (const Follower& follower : segment.followers()) add_ends(follower.law, instants_s);
    for (double& instant_s : instants_s) instant_s = std::min(instant_s, segment.duration_s);
    std::sort(instants_s.begin(), instants_s.end());
    instants_s.erase(std::unique(instants_s.begin(), instants_s.end()), instants_s.end());
    return instants_s;
}

double uncoordinated_distance_mm(const Segment& segment, double t_s) {
    const PathLengthIntegral integral(segment);
    double distance_mm = 0;
    double from_s = 0;
    for (const double instant_s : uncoordinated_instants_s(segment)) {
        const double to_s = std::min(instant_s, t_s);
        if (to_s > from_s) distance_mm += integral.between(from_s, to_s);
        from_s = std::max(from_s, to_s);
    }
    return distance_mm;
}

double uncoordinated_time_s(const Segment& segment, double distance_mm) {
    constexpr int kHalvings = 60;
    double low_s = 0;
    double high_s = segment.duration_s;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle_s = low_s + (high_s - low_s) / 2;
        (uncoordinated_distance_mm(segment, middle_s) < distance_mm ? low_s : high_s) = middle_s;
    }
    return high_s;
}

}  // namespace gsim::motion
