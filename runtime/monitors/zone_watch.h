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

/// Where the tool begins to do what a zone forbids.
struct ZoneHit {
    std::string zone;  ///< "security zone 3", "the working zone", "the zone of G22"
    bool stay_inside = false;
    bool stands = false;  ///< No wall is passed: it is so where the zone comes into force.
    double time_s = 0;    ///< On the clock of the run.
    ZoneWalls limits;
    std::array<std::optional<double>, 3> tool_mm;  ///< Machine coordinates of the tool's end.
    std::size_t axis = 0;                          ///< Whose wall is passed: 0 x, 1 y, 2 z.
    double wall_mm = 0;
    bool upwards = false;  ///< Which way that is.
    double beyond_mm = 0;  ///< How far past that wall the tool goes before it is where it may be again.
};

/// A zone of machine data, as it is at the start.
struct ZoneRule {
    std::string name;
    ZoneWalls walls;  ///< In machine coordinates of X, Y and Z.
    bool stay_inside;
    bool on;
};

/// Stands between a planner and what takes its segments, and finds where the tool enters a zone that is
/// forbidden or leaves one that it must stay in; it ends the segments there, or else goes on. The instant is
/// exact: a root of path and time law, not a sample. The tool's end is where the machine's X, Y and Z are,
/// less the tool offset in force.
///
/// Changes hold from a target of the program on, as segments come later than the program is read.
class ZoneWatch final : public motion::SegmentSink {
  public:
    /// Both must outlive this.
    ZoneWatch(const machine::Machine& machine, motion::SegmentSink& next);

    /// Before the first segment: segments go on behind a hit, and `on_hit` is told of the first
    /// kMostViolations, each when its segment has been taken on. The tool is out of a zone before it enters
    /// it again.
    void go_on(std::function<void(const ZoneHit&)> on_hit) { on_hit_ = std::move(on_hit); }
    /// Before the first segment: the zones of machine data.
    void add_zones(const machine::MachineData& data);
    /// Switches the zones of a number on or off; false where no zone has it.
    bool switch_zones(int switch_number, bool on, rrs::TargetId from);
    /// The zone that a program gives, in place of the one before; without limits there is none any more. If
    /// the tool stands inside when it comes into force it must stay inside, else outside.
    void set_programmed(const std::optional<ZoneWalls>& limits, rrs::TargetId from);
    void set_tool_offset(const Eigen::Vector3d& offset_mm, rrs::TargetId from);

    /// Without go_on() the segment in which a zone's rule is broken goes on until there, and those behind it
    /// go nowhere.
    void take(const motion::Segment& segment) override;
    /// The one that has ended the segments.
    const std::optional<ZoneHit>& hit() const { return hit_; }
    /// Those behind which segments went on: all that on_hit was told of, in its order.
    const std::vector<ZoneHit>& hits() const { return hits_; }
    /// How many more there were.
    std::uint64_t further_hits() const { return further_hits_; }
    /// Those of machine data, before the first segment.
    std::vector<ZoneRule> rules() const;
    /// Axes on which a zone has walls, but the machine has no linear axis: these walls are left out.
    const std::string& missing_axes() const { return missing_axes_; }

  private:
    struct Known {
        std::string name;
        ZoneWalls limits;
        bool stay_inside;
        bool on;
        std::optional<int> switch_number;
        ZoneBox box = ZoneBox();
        std::optional<BoxStay> stay = {};     ///< That goes on.
        std::optional<std::size_t> hit = {};  ///< Of that stay, in hits_.
    };
    struct Change {
        rrs::TargetId from;
        std::function<void(const rrs::JointPos&)> make;  ///< Gets where the joints stand.
    };

    void add_zone(std::string name, const machine::Zone& zone);
    void make_changes(const motion::Segment& segment);
    void renew_boxes();
    ZoneBox box_of(const ZoneWalls& limits, bool stay_inside) const;
    bool find_hit(const motion::Segment& segment);
    void follow(Known& zone, const motion::Segment& segment);
    void add_hit(Known& zone, const BoxStay& stay, const motion::Segment& segment);
    ZoneHit describe(const Known& zone, const BoxOffence& offence, const motion::Segment& segment) const;

    const machine::Machine& machine_;
    motion::SegmentSink& next_;
    std::array<int, 3> joints_;  ///< That carry X, Y and Z; -1: none.
    Eigen::Vector3d offset_mm_ = Eigen::Vector3d::Zero();
    std::vector<Known> zones_;
    std::optional<Known> programmed_;
    std::vector<Known*> active_;  ///< Of zones_ and programmed_.
    std::deque<Change> changes_;  ///< In the order of their targets.
    std::optional<ZoneHit> hit_;
    std::function<void(const ZoneHit&)> on_hit_;
    std::vector<ZoneHit> hits_;
    std::uint64_t further_hits_ = 0;
    std::string missing_axes_;
};

}  // namespace gsim::simulation
