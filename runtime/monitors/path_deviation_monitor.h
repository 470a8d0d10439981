#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <deque>
#include <memory>
#include <span>

#include "motion/path/path_sink.h"
#include "motion/planner/planner_setup.h"
#include "runtime/monitors/programmed_move_path.h"
#include "runtime/monitors/workpiece_tcp.h"
#include "runtime/outputs/run_output.h"
#include "runtime/report/report.h"

namespace gsim::simulation {

/// Monitor of how far the TCP, on the part, leaves the programmed path: at corners that the controller
/// rounds, and at single lines that it runs for several (Segment::path_deviation). It is the greater of
/// - the distance of a point of the driven path from the programmed one, and
/// - the distance of the programmed end of a move from the driven path; of moves that are omitted completely
///   other
///   points of curves, too.
/// Only paths that come near each other in the program are compared: the driven path between two moves that
/// are driven as programmed, or some moves of it, with the moves there. Changes that a controller makes all
/// along a path (chords for arcs, the grid of its steps, an axis's own ramps) are not checked.
class PathDeviationMonitor final : public motion::PathSink, public RunOutput {
  public:
    /// `setup` must outlive this.
    explicit PathDeviationMonitor(const motion::PlannerSetup& setup);

    /// Sets the TCP for the moves that follow, relative to that without a tool offset. It makes no difference
    /// if no joint turns it about the part.
    void set_tcp(const Eigen::Vector3d& tcp_mm);
    /// Announces the move with this target, which is about to be enqueued.
    void expect(rrs::TargetId id, const SourceLocation& location);

    void on_programmed_move(const motion::PathMove& move) override;
    void discard_last_move() override;
    void forget() override;

    void on_segment(const motion::Segment& segment, const MoveInfo& info) override;
    void end(double end_s) override;

    const Blends& blends() const { return blends_; }

  private:
    /// Segment off the path, by points of the TCP.
    struct ActualSegment {
        rrs::TargetId id = 0;
        const WorkpieceTcp* tcp = nullptr;
        int count = 0;
        std::array<Eigen::Vector3d, 33> points;
        Eigen::AlignedBox3d box;  ///< Box of the points.

        std::span<const Eigen::Vector3d> curve() const {
            return {points.data(), static_cast<std::size_t>(count)};
        }
    };

    rrs::TargetId first_move_after_run(const motion::Segment& segment) const;
    void on_reported_corner(const motion::Segment& segment);
    void on_deviating_segment(const motion::Segment& segment);
    void sample_segment(const motion::Segment& segment, WorkpieceTcp& tcp, ActualSegment& actual) const;
    std::size_t find_path_index(rrs::TargetId id) const;
    double path_deviation(const Eigen::Vector3d& point, std::size_t path_index, double cutoff,
                          std::size_t& near);
    void measure(const ActualSegment& actual, std::size_t path_index);
    void measure_missed_point(const Eigen::Vector3d& point, std::size_t path_index);
    using CurveDistance = double (*)(const Eigen::Vector3d&, std::span<const Eigen::Vector3d>);
    double run_distance(const Eigen::Vector3d& point, const WorkpieceTcp* tcp, CurveDistance distance,
                        double cutoff) const;
    void finish_paths_before(rrs::TargetId end_id);
    void end_run(rrs::TargetId end_id);
    void drop_passed_moves();
    void note(double deviation_mm, bool rapid, const SourceLocation& location);

    const motion::PlannerSetup& setup_;
    std::shared_ptr<WorkpieceTcp> tcp_;  ///< For the moves that are programmed now.
    rrs::TargetId expected_id_ = 0;
    SourceLocation location_;  ///< For the expected move.
    std::deque<ProgrammedMovePath> paths_;
    std::deque<ActualSegment> run_;         ///< The last segments off the path, in order.
    rrs::TargetId nearest_id_ = 0;          ///< Move where the last point of the driven path was found.
    rrs::TargetId last_on_path_id_ = 0;     ///< Id of the last segment on the path.
    rrs::TargetId first_unsettled_id_ = 0;  ///< Ends of moves before this one have been looked at.
    Blends blends_;
};

}  // namespace gsim::simulation
