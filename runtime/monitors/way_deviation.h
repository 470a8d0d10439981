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

/// Measures how far the tip, on the part, leaves the way that the program asks for: where the controller
/// rounds corners, and where it goes one line for several (Segment::off_way). It is the greater of
/// - how far a place of the driven way is from the programmed one, and
/// - how far the programmed end of a move is from the driven way; of moves that are left out as a whole other
///   points of curves, too.
/// Compared are ways that come near each other in the program: the driven way between two moves that are
/// driven as programmed, or some moves of it, with the moves there. What a controller does to a way all along
/// it (chords for arcs, the grid of its steps, ramps of an axis's own) is not looked at.
class WayDeviation final : public motion::WaySink, public RunOutput {
  public:
    /// `setup` must outlive this.
    explicit WayDeviation(const motion::PlannerSetup& setup);

    /// The moves that follow have a tool whose tip is here, as seen from the machine's tool centre point.
    /// Where nothing turns it about the part it makes no difference.
    void set_tip(const Eigen::Vector3d& tip_mm);
    /// The move with this target is about to be put.
    void expect(rrs::TargetId id, const Place& place);

    void programmed(const motion::PathMove& move) override;
    void take_back() override;
    void forget() override;

    using RunOutput::take;
    void take(const motion::Segment& segment, const MoveInfo& info) override;
    void end(double end_s) override;

    const Blends& blends() const { return blends_; }

  private:
    /// A segment off the way, by points of the tip.
    struct Driven {
        rrs::TargetId id = 0;
        const PartTip* tip = nullptr;
        int count = 0;
        std::array<Eigen::Vector3d, 33> points;
        Eigen::AlignedBox3d box;  ///< Of the points.

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
    std::shared_ptr<PartTip> tip_;  ///< Of the moves that are programmed now.
    rrs::TargetId expected_ = 0;
    Place place_;  ///< Of the move that is expected.
    std::deque<ProgrammedWay> ways_;
    std::deque<Driven> run_;       ///< The last segments off the way, one behind the other.
    rrs::TargetId near_ = 0;       ///< The move at which the last point of the driven way was found.
    rrs::TargetId passed_ = 0;     ///< Of the last segment on the way.
    rrs::TargetId unsettled_ = 0;  ///< Ends of moves before this one have been looked at.
    Blends blends_;
};

}  // namespace gsim::simulation
