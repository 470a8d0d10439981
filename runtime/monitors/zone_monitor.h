#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "machine/data/machine_data.h"
#include "machine/model/machine.h"
#include "motion/segment/segment.h"
#include "runtime/monitors/zone_box.h"
#include "runtime/report/report.h"

namespace gsim::simulation {

using ZoneWalls = std::array<std::optional<machine::ZoneLimits>, 3>;

/// Position at which the tool begins to do what a zone forbids.
struct ZoneHit {
    std::string zone;  ///< "security zone 3", "the working zone", "the zone of G22"
    bool stay_inside = false;
    bool is_initial = false;  ///< No wall is passed: it is so when the zone becomes active.
    double time_s = 0;        ///< On the clock of the run.
    ZoneWalls limits;
    std::array<std::optional<double>, 3> tool_mm;  ///< Machine coordinates of the tool's end.
    std::size_t axis = 0;                          ///< Axis of the passed wall: 0 x, 1 y, 2 z.
    double wall_mm = 0;
    bool upwards = false;  ///< Direction of that.
    double excess_mm = 0;  ///< Max distance past that wall until the tool is at an allowed position again.
};

/// Zone of machine data, as it is at the start.
struct ZoneRule {
    std::string name;
    ZoneWalls walls;  ///< In machine coordinates of X, Y and Z.
    bool stay_inside;
    bool on;
};

/// Filter between a planner and the receiver of its segments. It finds the point where the tool enters a
/// forbidden zone or leaves one that it must stay in. It ends the segments there, or else continues. The
/// instant is exact: a root of path and time law, not a sample. The tool's end is at the machine's X, Y and
/// Z, less the active tool offset.
///
/// Changes hold from a target of the program on, because segments come later than the program is read.
class ZoneMonitor final : public motion::SegmentSink {
  public:
    /// Both must outlive this.
    ZoneMonitor(const machine::Machine& machine, motion::SegmentSink& next);

    /// Call it before the first segment: segments then continue after a hit, and `on_hit` gets the first
    /// kMaxViolations, each once its segment has been passed on. The tool is out of a zone before it enters
    /// it again.
    void continue_after_violations(std::function<void(const ZoneHit&)> on_hit) {
        on_hit_ = std::move(on_hit);
    }
    /// Adds the zones of machine data, before the first segment.
    void add_zones(const machine::MachineData& data);
    /// Switches the zones of a number on or off; returns false if no zone has it.
    bool switch_zones(int switch_number, bool on, rrs::TargetId from);
    /// Sets the zone that a program gives, in place of the one before; without limits it removes that one. If
    /// the tool is inside when the zone becomes active it must stay inside, else outside.
    void set_programmed(const std::optional<ZoneWalls>& limits, rrs::TargetId from);
    void set_tool_offset(const Eigen::Vector3d& offset_mm, rrs::TargetId from);

    /// Passes segments on. Without continue_after_violations() the one that breaks a zone's rule ends there,
    /// and later ones are dropped.
    void on_segment(const motion::Segment& segment) override;
    /// Returns the hit that has ended the segments.
    const std::optional<ZoneHit>& hit() const { return hit_; }
    /// Returns the hits after which segments continued: those that on_hit got, in its order.
    const std::vector<ZoneHit>& hits() const { return hits_; }
    /// Returns the number of further hits.
    std::uint64_t further_hits() const { return further_hits_; }
    /// Returns the zones of machine data, before the first segment.
    std::vector<ZoneRule> rules() const;
    /// Returns axes on which a zone has walls, but the machine has no linear axis: these walls are omitted.
    const std::string& missing_axes() const { return missing_axes_; }

  private:
    struct ZoneState {
        std::string name;
        ZoneWalls limits;
        bool stay_inside;
        bool on;
        std::optional<int> switch_number;
        ZoneBox box = ZoneBox();
        std::optional<BoxViolationPeriod> violation_period = {};  ///< Still open.
        std::optional<std::size_t> hit = {};                      ///< Index of that stay in hits_.
    };
    struct Change {
        rrs::TargetId from;
        std::function<void(const rrs::JointPos&)> make;  ///< Gets the joint values.
    };

    void add_zone(std::string name, const machine::Zone& zone);
    void apply_changes(const motion::Segment& segment);
    void rebuild_boxes();
    ZoneBox make_zone_box(const ZoneWalls& limits, bool stay_inside) const;
    bool find_hit(const motion::Segment& segment);
    void update_violations(ZoneState& zone, const motion::Segment& segment);
    void add_hit(ZoneState& zone, const BoxViolationPeriod& violation_period, const motion::Segment& segment);
    ZoneHit describe(const ZoneState& zone, const BoxViolation& violation,
                     const motion::Segment& segment) const;

    const machine::Machine& machine_;
    motion::SegmentSink& next_;
    std::array<int, 3> joints_;  ///< Joints of X, Y and Z; -1: none.
    Eigen::Vector3d tool_offset_mm_ = Eigen::Vector3d::Zero();
    std::vector<ZoneState> zones_;
    std::optional<ZoneState> programmed_;
    std::vector<ZoneState*> active_;      ///< From zones_ and programmed_.
    std::deque<Change> pending_changes_;  ///< In the order of their targets.
    std::optional<ZoneHit> hit_;
    std::function<void(const ZoneHit&)> on_hit_;
    std::vector<ZoneHit> hits_;
    std::uint64_t further_hits_ = 0;
    std::string missing_axes_;
};

}  // namespace gsim::simulation
