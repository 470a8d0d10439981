#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "machine/model/machine.h"
#include "motion/planner/planner_setup.h"
#include "runtime/monitors/workpiece_tcp.h"
#include "runtime/outputs/run_output.h"
#include "runtime/outputs/text_stream.h"

namespace gsim::simulation {

/// Writer of the TCP path on the part as a DXF drawing of release 12, in mm (docs/report.md). The lines of a
/// move become one LINE or POLYLINE, arcs parallel to XY stay arcs, other curves become lines within
/// kTolerance_mm. Layers distinguish rapids, feed moves, and feed moves with the process on. Each exists once
/// for paths that stay at their height and once for others, because drawings of parts are flat.
class DxfWriter : public RunOutput {
  public:
    static constexpr double kTolerance_mm = 0.005;

    static constexpr std::uint64_t kMaxPoints = 10'000'000;  ///< Some 1 GB.

    /// `out` must outlive this. It draws at most `max_points`.
    DxfWriter(TextStream& out, const machine::Machine& machine, std::uint64_t max_points = kMaxPoints);

    /// Returns true if moves are missing, because the points would be too many: a helix may have any number
    /// of turns.
    bool is_truncated() const { return drawn_points_ > max_points_; }

    void begin(const rrs::JointPos& start) override;
    void on_segment(const motion::Segment& segment, const MoveInfo& info) override;
    void end(double end_s) override;

  private:
    /// Arc about an axis along Z.
    struct FlatArc {
        Eigen::Vector3d center_mm;
        double radius_mm = 0;
        double from_rad = 0;
        double sweep_rad = 0;  ///< Below 0: clockwise.
    };
    enum class Layer : std::uint8_t { rapid, feed, cut };

    Eigen::Vector3d tcp_at(const motion::Segment& segment, const Eigen::Vector3d& position_mm) const;
    std::optional<FlatArc> find_flat_arc(const motion::Segment& segment) const;
    bool follows_arc(const motion::Segment& segment, const FlatArc& flat_arc) const;
    void add(const FlatArc& flat_arc);
    void add_curve(const motion::Segment& segment);
    void add_point(const Eigen::Vector3d& point_mm);
    void flush();
    void write_line();
    void write_polyline();
    void write_flat_arc();
    void begin_entity(std::string_view kind, bool level);
    void write(int code, std::string_view value);
    void write(int code, double value);
    void write_point(int code, const Eigen::Vector3d& point_mm);

    TextStream& out_;
    std::uint64_t max_points_;
    std::uint64_t drawn_points_ = 0;
    motion::PlannerSetup setup_;
    WorkpieceTcp tcp_;
    Layer layer_ = Layer::rapid;
    std::int64_t target_id_ = 0;
    std::vector<Eigen::Vector3d> points_;  ///< For lines that are not written yet; empty, or two and more.
    std::optional<FlatArc> flat_arc_;      ///< Or an arc that is not.
};

}  // namespace gsim::simulation
