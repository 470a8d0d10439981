#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <deque>
#include <memory>
#include <span>

#include "motion/path/way_sink.h"
#include "motion/planner/planner_setup.h"
#include "runtime/monitors/part_tip.h"
#include "runtime/monitors/programmed_way.h"
#include "runtime/outputs/run_output.h"
#include "runtime/report/report.h"

namespace gsim::simulation {

/// Monitor of how far the TCP, on the part, leaves the programmed path: at corners that the controller
/// rounds, and at single lines that it runs for several (Segment::off_way). It is the greater of
/// - the distance of a point of the driven path from the programmed one, and
/// - the distance of the programmed end of a move from the driven path; of moves that are omitted completely
///   other
///   points of curves, too.
/// Only paths that come near each other in the program are compared: the driven path between two moves that
/// are driven as programmed, or some moves of it, with the moves there. Changes that a controller makes all
/// along a path (chords for arcs, the grid of its steps, an axis's own ramps) are not checked.
class WayDeviation final : public motion::WaySink, public RunOutput {
  public:
    /// `setup` must outlive this.
    explicit WayDeviation(const motion::PlannerSetup& setup);

    /// Sets the tool tip for the moves that follow, as seen from the machine's tool centre point. It makes no
    /// difference if no joint turns it about the part.
    void set_tip(const Eigen::Vector3d& tip_mm);
    /// Announces the move with this target, which is about to be enqueued.
    void expect(rrs::TargetId id, const Place& place);

    void programmed(const motion::PathMove& move) override;
    void take_back() override;
    void forget() override;

    using RunOutput::take;
    void take(const motion::Segment& segment, const MoveInfo& info) override;
    void end(double end_s) override;

    const Blends& blends() const { return blends_; }

  private:
    /// Segment off the path, by points of the TCP.
    struct Driven {
        rrs::TargetId id = 0;
        const PartTip* tip = nullptr;
        int count = 0;
        std::array<Eigen::Vector3d, 33> points;
        Eigen::AlignedBox3d box;  ///< Box of the points.

        std::span<const Eigen::Vector3d> curve() const {
            return {points.data(), static_cast<std::size_t>(count)};
        }
    };

    rrs::TargetId first_behind_run(const motion::Segment& segment) const;
    void take_told(const motion::Segment& segment);
    void take_off_way(const motion::Segment& segment);
    void look_at(const motion::Segment& segment, PartTip& tip, Driven& driven) const;
    std::size_t way_of(rrs::TargetId id) const;
    double off_way(const Eigen::Vector3d& point, std::size_t way, double enough, std::size_t& near);
    void measure(const Driven& driven, std::size_t way);
    void measure_missed(const Eigen::Vector3d& point, std::size_t way);
    using CurveDistance = double (*)(const Eigen::Vector3d&, std::span<const Eigen::Vector3d>);
    double run_distance(const Eigen::Vector3d& point, const PartTip* tip, CurveDistance distance,
                        double enough) const;
    void settle(rrs::TargetId until);
    void end_run(rrs::TargetId until);
    void drop_old();
    void note(double deviation_mm, bool rapid, const Place& place);

    const motion::PlannerSetup& setup_;
    std::shared_ptr<PartTip> tip_;  ///< For the moves that are programmed now.
    rrs::TargetId expected_ = 0;
    Place place_;  ///< For the expected move.
    std::deque<ProgrammedWay> ways_;
    std::deque<Driven> run_;       ///< The last segments off the path, one after the other.
    rrs::TargetId near_ = 0;       ///< Move at which the last point of the driven path was found.
    rrs::TargetId passed_ = 0;     ///< Id of the last segment on the path.
    rrs::TargetId unsettled_ = 0;  ///< Ends of moves before this one have been looked at.
    Blends blends_;
};

}  // namespace gsim::simulation
