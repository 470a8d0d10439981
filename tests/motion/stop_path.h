#pragma once

#include <algorithm>
#include <span>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/motion/machines.h"

namespace gsim::motion {

/// Result of a step of GetNextStep.
struct TakenStep {
    rrs::Status status;
    rrs::JointPos joints;
    double elapsed_s;
};

inline TakenStep advance_step(DefaultPlanner& planner) {
    TakenStep step{};
    rrs::CartPos pose;
    step.status = planner.GetNextStep(step.joints, pose, step.elapsed_s);
    return step;
}

/// Steps until standstill; returns the position.
inline rrs::JointPos run_to_rest(DefaultPlanner& planner) {
    for (int i = 0; i < 1'000'000; ++i) {
        const TakenStep now = advance_step(planner);
        if (now.status == rrs::Status::RRS_NEED_MORE_DATA) return now.joints;
    }
    throw std::runtime_error("it does not come to an end");
}

/// Plan as a path that a motion must keep.
class Way {
  public:
    explicit Way(const std::vector<Segment>& plan)
        : plan_(plan), greatest_acceleration_(acceleration_of(plan)) {
        for (const Segment& segment : plan) {
            for (int k = 0; k <= kSamples; ++k)
                points_.push_back(segment.position_at(segment.duration_s * k / kSamples));
        }
    }

    /// The greatest of each joint.
    static rrs::JointPos acceleration_of(const std::vector<Segment>& segments) {
        rrs::JointPos max = rrs::JointPos::Zero(segments.front().start.size());
        for (const Segment& segment : segments) {
            for (int i = 0; i < 40; ++i) {
                const JointState state = segment.at(segment.duration_s * (i + 0.5) / 40);
                max = max.cwiseMax(state.acceleration.cwiseAbs());
            }
        }
        return max;
    }
    const rrs::JointPos& greatest_acceleration() const { return greatest_acceleration_; }

    /// Returns the distance of a point from the path. It checks the segments closely that can be nearest.
    double distance_to(const rrs::JointPos& point) const {
        double min = kUnlimited;
        for (const Sample& sample : nearest_samples(point)) {
            if (sample.least_distance > min) break;
            min = std::min(min, distance_near(sample, point));
        }
        return min;
    }

  private:
    static constexpr int kSamples = 12;
    struct Sample {
        const Segment* segment;
        int number;
        double distance;
        double least_distance;  ///< Min of the segment.
    };

    /// Returns a sample of each segment, in the order of their min distances.
    std::vector<Sample> nearest_samples(const rrs::JointPos& point) const {
        std::vector<Sample> samples;
        for (std::size_t i = 0; i < plan_.size(); ++i) {
            const std::span<const rrs::JointPos> points(&points_[i * (kSamples + 1)], kSamples + 1);
            Sample nearest{&plan_[i], 0, kUnlimited, 0};
            double spacing = 0;
            for (int k = 0; k <= kSamples; ++k) {
                const rrs::JointPos& at = points[static_cast<std::size_t>(k)];
                if (k > 0) spacing = std::max(spacing, (at - points[static_cast<std::size_t>(k - 1)]).norm());
                if (const double distance = (at - point).norm(); distance < nearest.distance)
                    nearest = {&plan_[i], k, distance, 0};
            }
            nearest.least_distance = nearest.distance - spacing;
            samples.push_back(nearest);
        }
        std::sort(samples.begin(), samples.end(),
                  [](const Sample& a, const Sample& b) { return a.least_distance < b.least_distance; });
        return samples;
    }
    static double distance_near(const Sample& sample, const rrs::JointPos& point) {
        const double step_s = sample.segment->duration_s / kSamples;
        const auto distance = [&](double t_s) { return (sample.segment->position_at(t_s) - point).norm(); };
        double low = step_s * std::max(sample.number - 1, 0);
        double high = step_s * std::min(sample.number + 1, kSamples);
        for (int i = 0; i < 50; ++i) {
            const double third = (high - low) / 3;
            if (distance(low + third) < distance(high - third))
                high -= third;
            else
                low += third;
        }
        return distance((low + high) / 2);
    }

    const std::vector<Segment>& plan_;
    rrs::JointPos greatest_acceleration_;
    std::vector<rrs::JointPos> points_;
};

/// Positions join, and all velocities.
inline void expect_smooth_joins(const std::vector<Segment>& segments, double speed_step) {
    for (std::size_t i = 1; i < segments.size(); ++i) {
        const Segment& before = segments[i - 1];
        const Segment& segment = segments[i];
        ASSERT_NEAR(segment.start_s, before.end_s(), 1e-9);
        ASSERT_LT((segment.start - before.end_position()).cwiseAbs().maxCoeff(), 1e-8) << i;
        const JointState from = before.at(before.duration_s);
        const JointState to = segment.at(0);
        ASSERT_LT((to.velocity - from.velocity).cwiseAbs().maxCoeff(), speed_step) << i;
    }
}

inline void expect_speeds(const Segment& segment, const PlannerSetup& setup) {
    for (int i = 0; i <= 12; ++i) {
        const rrs::JointPos speed = segment.at(segment.duration_s * i / 12).velocity.cwiseAbs();
        for (int joint = 0; joint < setup.joint_count(); ++joint)
            ASSERT_LE(speed[joint], setup.joints[static_cast<std::size_t>(joint)].max_speed * (1 + 1e-6));
    }
}

/// The greatest jump of a joint's speed from one segment to the next.
inline double greatest_speed_step(const std::vector<Segment>& segments) {
    double max = 0;
    for (std::size_t i = 1; i < segments.size(); ++i) {
        const Segment& before = segments[i - 1];
        const rrs::JointPos jump = segments[i].at(0).velocity - before.at(before.duration_s).velocity;
        max = std::max(max, jump.cwiseAbs().maxCoeff());
    }
    return max;
}

/// Expects that a motion that was stopped on the path keeps to the path of the plan. Its speeds jump no more,
/// and its accelerations are no larger, than those of the plan or the limits of the machine.
inline void expect_planned_way(const std::vector<Segment>& segments, const std::vector<Segment>& plan,
                               const PlannerSetup& setup) {
    constexpr double kPathTolerance = 3e-6;  // mm or rad
    const Way path(plan);
    ASSERT_NO_FATAL_FAILURE(expect_smooth_joins(segments, greatest_speed_step(plan) * (1 + 1e-6) + 1e-5));
    const rrs::JointPos max = Way::acceleration_of(segments);
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const JointSetup& joint_setup = setup.joints[static_cast<std::size_t>(joint)];
        const double limit = std::max(
            {joint_setup.max_acceleration, joint_setup.deceleration(), path.greatest_acceleration()[joint]});
        ASSERT_LE(max[joint], limit * 1.01) << "joint " << joint;
    }
    for (const Segment& segment : segments) {
        for (const double share : {0.27, 0.61}) {
            const rrs::JointPos at = segment.position_at(segment.duration_s * share);
            ASSERT_LT(path.distance_to(at), kPathTolerance) << segment.start_s;
        }
    }
}

}  // namespace gsim::motion
