// Cuts a tool path into lines of the joints; declared in tool_path.h.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/text/number.h"
#include "base/units.h"
#include "motion/path/tool_path.h"
#include "motion/planner/range_check.h"

namespace gsim::motion {

namespace {

constexpr double kToleranceShare = 0.95;  // checks at only the quarters may miss the worst
constexpr double kSubdivisionAngle_rad = 1e-4;
constexpr double kMaxRotation_rad = 0.2;  // of a sub-segment, before any check of it
constexpr int kMaxCutHalvings = 30;       // of such a sub-segment
constexpr std::size_t kMaxPathSubSegments = 200'000;
constexpr double kMinChordError = 2e-9;  // mm or rad between a chord and its curve: what inverses leave

/// Part of the path that may be a line of the joints or have to be halved, by shares of the path.
struct PathInterval {
    double from = 0;
    double to = 0;
    int halvings = 0;
};

class PathSubdivider {
  public:
    PathSubdivider(const ToolPath& path, const PlannerSetup& setup, const rrs::JointPos& start)
        : path_(path), setup_(setup), from_(start) {}

    tl::expected<std::vector<PathSubSegment>, PlanError> run() {
        fill();
        while (!prefetch_.empty()) {
            const PathInterval next = prefetch_.back();
            prefetch_.pop_back();
            if (PlanResult planned = add_part(next); !planned)
                return tl::unexpected(std::move(planned.error()));
        }
        return with_neighbor_curvature();
    }

  private:
    void fill() {
        const double turns =
            path_.tcp_path().kind == SegmentKind::circular ? path_.tcp_path().arc.sweep_rad : 0.0;
        const double count = std::ceil((turns + path_.turn_rad()) / kMaxRotation_rad);
        const int section_count = static_cast<int>(std::clamp(count, 1.0, 1e5));
        for (int i = section_count; i > 0; --i)
            prefetch_.push_back(
                {static_cast<double>(i - 1) / section_count, static_cast<double>(i) / section_count, 0});
    }

    PlanResult add_part(const PathInterval& interval) {
        const double middle = (interval.from + interval.to) / 2;
        const auto middle_joints = path_.joints_at(middle, from_);
        if (!middle_joints) return unreachable(middle_joints.error(), middle);
        const auto end = path_.joints_at(interval.to, *middle_joints);
        if (!end) return unreachable(end.error(), interval.to);
        if (PlanResult checked = check_target_ranges(setup_, *end); !checked) return checked;
        if (follows(interval, *middle_joints, *end)) return add(interval, *middle_joints, *end);
        if (interval.halvings >= kMaxCutHalvings) return jump(interval, *end);
        prefetch_.push_back({middle, interval.to, interval.halvings + 1});
        prefetch_.push_back({interval.from, middle, interval.halvings + 1});
        return {};
    }

    bool follows(const PathInterval& interval, const rrs::JointPos& middle_joints,
                 const rrs::JointPos& end) const {
        for (const double share : {0.25, 0.5, 0.75}) {
            const rrs::CartPos pose = path_.tool_pose(from_ + share * (end - from_));
            const Eigen::Vector3d requested =
                path_.tcp_path().at(interval.from + share * (interval.to - interval.from));
            const double deviation_mm = (pose * path_.tcp_mm() - requested).norm();
            if (!(deviation_mm <= kToleranceShare * setup_.controller.coordination.tcp_tolerance_mm))
                return false;
            if (share != 0.5) continue;
            const Eigen::Quaterniond sample_orientation(pose.linear());
            if (!(sample_orientation.angularDistance(Eigen::Quaterniond(
                      path_.tool_pose(middle_joints).linear())) <= kSubdivisionAngle_rad)) {
                return false;
            }
        }
        return true;
    }

    PlanResult add(const PathInterval& interval, const rrs::JointPos& middle_joints,
                   const rrs::JointPos& end) {
        if (sub_segments_.size() >= kMaxPathSubSegments) {
            return make_plan_error(
                rrs::Status::RRS_INVALID_PARAMETER,
                fmt::format("The path of the tool would need more than {} lines of the joints.",
                            kMaxPathSubSegments));
        }
        PathSubSegment sub_segment;
        sub_segment.share = interval.to - interval.from;
        sub_segment.end = end;
        sub_segment.joint_curvature = (from_ - 2 * middle_joints + end).cwiseAbs();
        const double length = sub_segment.share * path_.length();
        for (double& joint_curvature : sub_segment.joint_curvature)
            joint_curvature = joint_curvature > kMinChordError ? 4 * joint_curvature / (length * length) : 0;
        sub_segments_.push_back(std::move(sub_segment));
        from_ = end;
        return {};
    }

    /// The larger curvature holds on both of two neighbours if it changes fast between them.
    std::vector<PathSubSegment> with_neighbor_curvature() const {
        std::vector<PathSubSegment> sub_segments = sub_segments_;
        for (std::size_t i = 1; i < sub_segments.size(); ++i) {
            sub_segments[i].joint_curvature =
                sub_segments[i].joint_curvature.cwiseMax(sub_segments_[i - 1].joint_curvature);
            sub_segments[i - 1].joint_curvature =
                sub_segments[i - 1].joint_curvature.cwiseMax(sub_segments_[i].joint_curvature);
        }
        return sub_segments;
    }

    std::string location_text(double share) const {
        const Eigen::Vector3d point = path_.tcp_path().at(share);
        return fmt::format("at X{} Y{} Z{} of the work frame", text::fixed(point.x(), 3),
                           text::fixed(point.y(), 3), text::fixed(point.z(), 3));
    }

    PlanResult unreachable(const std::string& reason, double share) const {
        return make_plan_error(
            rrs::Status::RRS_NO_SOLUTION,
            fmt::format("The tool cannot follow its path {}: {}", location_text(share), reason));
    }

    PlanResult jump(const PathInterval& interval, const rrs::JointPos& end) const {
        Eigen::Index joint = 0;
        (end - from_).cwiseAbs().maxCoeff(&joint);
        const bool rotary = setup_.role(static_cast<int>(joint)) == JointRole::rotary;
        return make_plan_error(
            rrs::Status::RRS_NO_SOLUTION,
            fmt::format("The path of the tool passes a singularity {}, where joint {} (counted from 0) would "
                        "jump by {:.3g} {}; avoid that position, or move by joints.",
                        location_text(interval.to), joint,
                        std::abs(end[joint] - from_[joint]) * (rotary ? kDegPerRad : 1.0),
                        rotary ? "deg" : "mm"));
    }

    const ToolPath& path_;
    const PlannerSetup& setup_;
    rrs::JointPos from_;
    std::vector<PathInterval> prefetch_;  ///< The next one at the back.
    std::vector<PathSubSegment> sub_segments_;
};

}  // namespace

tl::expected<std::vector<PathSubSegment>, PlanError> cut(const ToolPath& path, const PlannerSetup& setup,
                                                         const rrs::JointPos& start) {
    if (!(path.length() > 0)) return std::vector<PathSubSegment>();
    return PathSubdivider(path, setup, start).run();
}

}  // namespace gsim::motion
