#include "motion/dynamics/segment_efforts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/dynamics/law_ends.h"
#include "motion/path/joint_motion.h"

namespace gsim::dynamics {

using motion::Segment;

namespace {

constexpr int kMaxHalvings = 24;
constexpr int kMaxParts = 4096;  // of a smooth part: enough for each corner, and a bound if all is noise
// The two rules differ by far more than the error of the better one.
constexpr double kJointTolerance = 1e-7;      // of a joint's own sum,
constexpr double kTotalTolerance = 1e-10;     // and of that of all joints;
constexpr double kWorkShareTolerance = 1e-2;  // of a joint's work, for its parts in and back
constexpr double kAbsoluteTolerance =
    1e-6;                        // and negligible values, N2 or W: joints at standstill move by rounding
constexpr double kInset = 1e-9;  // of a part: distance of samples inside its ends
constexpr double kShortest_s = 1e-12;

bool may_reverse(const Segment& segment) {
    return segment.superimposed != nullptr || segment.kind == motion::SegmentKind::circular;
}

}  // namespace

EffortSums::EffortSums(int joints)
    : squares(rrs::JointPos::Zero(joints)),
      drive_j(rrs::JointPos::Zero(joints)),
      regenerated_j(rrs::JointPos::Zero(joints)),
      friction_j(rrs::JointPos::Zero(joints)) {}

EffortSums& EffortSums::operator+=(const EffortSums& other) {
    squares += other.squares;
    drive_j += other.drive_j;
    regenerated_j += other.regenerated_j;
    friction_j += other.friction_j;
    return *this;
}

EffortSample SegmentEfforts::at(const Segment& segment, double t_s) const {
    return at(segment, t_s, rrs::JointPos::Zero(dynamics_.joint_count()));
}

// A joint at standstill for the instant, as at the end of a ramp, has friction against its motion around that
// instant.
EffortSample SegmentEfforts::at(const Segment& segment, double t_s, const rrs::JointPos& sense) const {
    EffortSample sample{.t_s = t_s, .motion = {}, .efforts = {}, .powers_w = {}};
    motion::JointState state = segment.at(t_s);
    sample.motion = {.position = state.position,
                     .velocity = state.velocity,
                     .acceleration = state.acceleration,
                     .sense = motion_directions(state.velocity)};
    for (int joint = 0; joint < sense.size(); ++joint) {
        if (sample.motion.sense[joint] == 0) sample.motion.sense[joint] = sense[joint];
    }
    sample.efforts = dynamics_.efforts(sample.motion);
    sample.powers_w = dynamics_.powers_w(sample.efforts, sample.motion.velocity);
    return sample;
}

void SegmentEfforts::split(const Segment& segment) {
    ends_s_.clear();
    add_law_ends(segment, ends_s_);
    if (may_reverse(segment)) {
        for (int joint = 0; joint < dynamics_.joint_count(); ++joint)
            motion::add_reversal_times(segment, joint, ends_s_);
    }
    ends_s_.push_back(segment.duration_s);
    std::sort(ends_s_.begin(), ends_s_.end());
}

SegmentEfforts::Integrand SegmentEfforts::integrand(const Segment& segment, double t_s, const Part& part,
                                                    const SampleHandler& visit) const {
    const double inset_s = kInset * (part.to_s - part.from_s);
    const EffortSample sample =
        at(segment, std::clamp(t_s, part.from_s + inset_s, part.to_s - inset_s), part.sense);
    visit(sample);
    const Eigen::Index joints = dynamics_.joint_count();
    Integrand integrand(4 * joints);
    integrand.segment(0, joints) = sample.efforts.array().square();
    integrand.segment(joints, joints) = sample.powers_w.array().max(0.0);
    integrand.segment(2 * joints, joints) = (-sample.powers_w).array().max(0.0);
    const rrs::JointPos friction = dynamics_.friction(sample.motion.velocity, sample.motion.sense);
    integrand.segment(3 * joints, joints) = dynamics_.powers_w(friction, sample.motion.velocity).array();
    return integrand;
}

void SegmentEfforts::add(const Segment& segment, const Part& part, int halvings, const SampleHandler& visit,
                         int& remaining_parts, Integrand& sum) const {
    const double half_s = (part.to_s - part.from_s) / 2;
    const double middle_s = part.from_s + half_s;
    const auto pair = [&](double at) -> Integrand {
        return integrand(segment, middle_s - at * half_s, part, visit) +
               integrand(segment, middle_s + at * half_s, part, visit);
    };
    const Integrand ends = pair(1);
    const Integrand outer = pair(std::sqrt(2.0 / 3));
    const Integrand inner = pair(1 / std::sqrt(5.0));
    const Integrand middle = integrand(segment, middle_s, part, visit);
    const Integrand coarse = half_s / 6 * (ends + 5 * inner);
    const Integrand fine = half_s / 1470 * (77 * ends + 432 * outer + 625 * inner + 672 * middle);
    if (halvings >= kMaxHalvings || --remaining_parts <= 0 || is_converged(coarse, fine, 2 * half_s)) {
        sum += fine;
        return;
    }
    add(segment, {part.from_s, middle_s, part.sense}, halvings + 1, visit, remaining_parts, sum);
    add(segment, {middle_s, part.to_s, part.sense}, halvings + 1, visit, remaining_parts, sum);
}

// If a power changes its sign, work in and work back have a corner, but their difference has none. The
// difference is held as closely as the other sums, the share of each only as closely as users need.
bool SegmentEfforts::is_converged(const Integrand& coarse, const Integrand& fine, double time_s) const {
    const Eigen::Index joints = dynamics_.joint_count();
    const auto close = [&](const auto& difference, const auto& reference, double joint_tolerance) {
        return (difference.abs() <= joint_tolerance * reference +
                                        (kTotalTolerance * reference.sum() + kAbsoluteTolerance * time_s))
            .all();
    };
    const Integrand differ = fine - coarse;
    const auto part = [&](const Integrand& of, int kind) { return of.segment(kind * joints, joints); };
    const auto work = (part(fine, 1) + part(fine, 2)).eval();
    return close(part(differ, 0), part(fine, 0), kJointTolerance) &&
           close(part(differ, 3), part(fine, 3), kJointTolerance) &&
           close(part(differ, 1) - part(differ, 2), work, kJointTolerance) &&
           close(part(differ, 1), work, kWorkShareTolerance);
}

void SegmentEfforts::add_standstill(const Segment& segment, const SampleHandler& visit,
                                    EffortSums& sums) const {
    const EffortSample sample = at(segment, segment.duration_s / 2);
    visit(sample);
    sums.squares = segment.duration_s * sample.efforts.cwiseAbs2();
}

EffortSums SegmentEfforts::sums(const Segment& segment, const SampleHandler& visit) {
    const Eigen::Index joints = dynamics_.joint_count();
    EffortSums sums(dynamics_.joint_count());
    if (segment.kind == motion::SegmentKind::rest && !segment.superimposed) {
        add_standstill(segment, visit, sums);
        return sums;
    }
    split(segment);
    Integrand sum = Integrand::Zero(4 * joints);
    double from_s = 0;
    for (const double end_s : ends_s_) {
        const double to_s = std::min(end_s, segment.duration_s);
        if (to_s - from_s <= kShortest_s) continue;
        const rrs::JointPos sense = motion_directions(segment.at((from_s + to_s) / 2).velocity);
        int remaining_parts = kMaxParts;
        add(segment, {from_s, to_s, sense}, 0, visit, remaining_parts, sum);
        from_s = to_s;
    }
    sums.squares = sum.segment(0, joints).matrix();
    sums.drive_j = sum.segment(joints, joints).matrix();
    sums.regenerated_j = sum.segment(2 * joints, joints).matrix();
    sums.friction_j = sum.segment(3 * joints, joints).matrix();
    return sums;
}

std::vector<EffortSample> SegmentEfforts::samples(const Segment& segment) {
    std::vector<EffortSample> samples;
    static_cast<void>(sums(segment, [&](const EffortSample& sample) { samples.push_back(sample); }));
    std::stable_sort(samples.begin(), samples.end(),
                     [](const EffortSample& a, const EffortSample& b) { return a.t_s < b.t_s; });
    return samples;
}

}  // namespace gsim::dynamics
