#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "machine/model/machine.h"
#include "motion/dynamics/segment_efforts.h"
#include "runtime/monitors/following_motion.h"
#include "runtime/outputs/path_thinner.h"
#include "runtime/outputs/run_output.h"
#include "runtime/report/time_buckets.h"

namespace gsim::simulation {

/// Kind of mark on the path.
enum class MarkKind : std::uint8_t { pierce, alarm, collision };

struct PlotMark {
    Eigen::Vector2d at_mm;
    MarkKind kind;
};

/// Collector of the data of a Picture, in bounded memory: the path seen from above, or from a side, that is
/// two of the machine's X, Y and Z; and the tool's speed, acceleration along its path and programmed feed
/// over time.
class PlotData : public RunOutput {
  public:
    static constexpr std::size_t kMaxPierces = 10'000;  ///< Max number of marks; later ones are omitted.

    /// Selects the axes across and upwards: X Y, X Z and Y Z for the planes xy, zx and yz; for xy a machine's
    /// first two axes if it has no such letters. An axis of the plane that the machine lacks is an error,
    /// find_missing_axes_error().
    explicit PlotData(const machine::Machine& machine, Plane plane = Plane::xy);
    /// Adds, before the run, the efforts of the motors to the picture. `dynamics` must outlive this.
    void add_efforts(const dynamics::Dynamics& dynamics);
    /// Adds, before the run, following errors.
    void add_following(const FollowingSetup& setup);
    /// Returns an error if the machine lacks the axes of a side view.
    static std::optional<Error> find_missing_axes_error(const machine::Machine& machine, Plane plane);

    void begin(const rrs::JointPos& start) override;
    void on_segment(const motion::Segment& segment, const MoveInfo& info) override;
    void end(double end_s) override;

    /// Marks a contact of bodies of the cell and, last of all, the position where an alarm ends the run.
    void mark_collision(const rrs::JointPos& joints);
    void mark_alarm();

    const std::vector<PlotMark>& marks() const { return marks_; }
    std::vector<PathPoint> path() const { return path_.points(); }
    std::vector<TimePoint> speed() const { return speed_.points(); }
    std::vector<TimePoint> acceleration() const { return acceleration_.points(); }
    /// Returns the feed in mm/s at the ends of moves for which a feed in mm/min is programmed.
    std::vector<TimePoint> feed() const { return feed_.points(); }
    /// Returns the effort of an axis motor, N or Nm; empty if no masses are known.
    std::vector<TimePoint> efforts(std::size_t axis) const {
        return efforts_.empty() ? std::vector<TimePoint>() : efforts_[axis].points();
    }
    bool has_efforts() const { return !efforts_.empty(); }
    /// Returns the following error of an axis, mm or deg.
    std::vector<TimePoint> following(std::size_t axis) const { return following_[axis].points(); }
    bool has_following() const { return !following_.empty(); }
    /// Returns the distance of the TCP from the path of its set points, mm, if it is known.
    std::vector<TimePoint> contour() const { return contour_.points(); }
    const std::vector<machine::Axis>& axes() const { return machine_.axes; }
    /// Returns the machine's limit of acceleration along the path, mm/s2; infinite if it has none.
    double max_acceleration_mm_s2() const { return machine_.path.max_acceleration_mm_s2; }
    /// Returns the process of the machine: "jet".
    std::string process() const {
        return std::string(
            machine::name(machine_.process ? machine_.process->kind : machine::ProcessKind::jet));
    }
    /// Returns the labels of the two path axes, such as "X (mm)".
    const std::array<std::string, 2>& labels() const { return labels_; }

  private:
    Eigen::Vector2d project(const rrs::JointPos& joints) const;
    void mark_pierce(const motion::Segment& segment, bool process_on);
    void add_path(const motion::Segment& segment, PathStyle style);
    void add_joint_path(const motion::Segment& segment, PathStyle style);
    void add_speed(const motion::Segment& segment, PathStyle style);
    void add_acceleration(const motion::Segment& segment, PathStyle style);
    void add_joint_acceleration(const motion::Segment& segment, PathStyle style);
    void add_segment_efforts(const motion::Segment& segment);
    void add_following_at(double t_s);
    void add_standstill(const motion::Segment& segment, PathStyle style);
    void add_feed(const motion::Segment& segment, const MoveInfo& info);

    const machine::Machine& machine_;
    std::array<std::size_t, 2> axes_{0, 0};
    std::array<std::string, 2> labels_;
    rrs::JointPos at_;
    bool jet_ = false;
    std::vector<PlotMark> marks_;
    PathThinner path_;
    TimeBuckets speed_;
    TimeBuckets acceleration_;
    TimeBuckets feed_;
    std::optional<dynamics::SegmentEfforts> motors_;
    std::vector<TimeBuckets> efforts_;  ///< By axis.
    std::optional<FollowingMotion> servos_;
    std::vector<TimeBuckets> following_;  ///< By axis.
    TimeBuckets contour_;
};

}  // namespace gsim::simulation
