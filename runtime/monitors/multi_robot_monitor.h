#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision/monitor/neighbour_monitor.h"
#include "runtime/monitors/cell_monitor.h"
#include "runtime/report/robots_report.h"
#include "runtime/simulator/machine_motion.h"

namespace gsim::simulation {

/// Robot of a run, and the pose of its world in the common one.
struct PlacedRobot {
    std::string name;
    const MachineMotion& motion;
    CellMonitor* cell;  ///< Null: the robot has no cell.
    rrs::CartPos base;
};

/// Zone in which one robot may be at a time, in the common world.
struct PlacedZone {
    std::string name;
    cell::Shape shape;
    rrs::CartPos frame;
};

/// Monitor of the robots of a run against each other, while they move: their bodies, and what they carry.
/// Robots of the same base have no positions of their own, and are not checked against each other. It also
/// finds robots in zones that another process has.
///
/// Robots run ahead of each other. The motion of one waits here until it is known what the others do
/// meanwhile.
class MultiRobotMonitor {
  public:
    /// Call it before the first move. The robots' motions and cells outlive this.
    MultiRobotMonitor(const std::vector<PlacedRobot>& robots, const std::vector<PlacedZone>& zones,
                      os::CpuLimit* cpu);
    MultiRobotMonitor(const MultiRobotMonitor&) = delete;
    MultiRobotMonitor& operator=(const MultiRobotMonitor&) = delete;

    /// Returns true if the monitor has something to check.
    bool has_pairs() const { return !pairs_.empty(); }
    /// Sets the time up to which all is known. A robot without a move up to that time is at standstill until
    /// then. An exception is motion that its planner, or the wait for conveyors, has not passed on. Zones
    /// that were not given are as they were.
    void set_known_until(double time_s);
    /// Sets a callback for a robot that runs so far ahead that the others should continue, to save memory.
    void on_buffer_full(std::function<void()> call) { on_buffer_full_ = std::move(call); }

    /// Process, by its number and its name.
    struct ZoneHolder {
        std::size_t process;
        std::string name;
    };
    /// Gives that process the zone from a time on up to which not all is known yet; nullopt: the zone is
    /// free.
    void assign_zone(std::size_t zone, double time_s, std::optional<ZoneHolder> holder);
    /// Gives that process the robot from a time on, likewise; it still counts as the owner once it has
    /// released the robot. A robot that no process has had disturbs none in a zone.
    void assign_robot(std::size_t robot, double time_s, std::size_t process);

    /// Ends the run: from there on all robots stay at their positions.
    void finish() { set_known_until(std::numeric_limits<double>::infinity()); }
    /// Adds contacts, after finish(), to the reports of both robots, which are in the order of the robots.
    void add_findings(std::vector<RobotReport>& reports) const;
    /// Returns messages for the common report: which robots were not checked against each other.
    std::vector<std::string> warnings() const;

  private:
    /// Part of a robot's motion.
    struct TrackSegment {
        motion::Segment segment;
        SourceLocation location;
        bool process_on = false;
        std::shared_ptr<const cell::MachineBodies> bodies = {};
    };
    /// Process that has a robot from a time on.
    struct Owner {
        double from_s;
        std::size_t process;
    };
    /// Motion of a robot, as far as it is reported and not yet checked; or a zone, at standstill.
    struct Track {
        std::string name;
        rrs::CartPos base;
        const MachineMotion* motion = nullptr;  ///< Null for a zone.
        CellMonitor* cell = nullptr;
        std::shared_ptr<const kinematics::Kinematics> kinematics = {};  ///< From the machine file.
        std::uint64_t frame_changes = 0;  ///< At which `standstill` has the bodies.
        std::deque<TrackSegment> sub_segments = {};
        std::size_t first = 0;           ///< Number of the first of those, from the start of the run on.
        TrackSegment standstill = {};    ///< State past their end.
        std::vector<Owner> owners = {};  ///< In the order of time.
        bool moved = false;
    };
    /// Process that has a zone from a time on.
    struct ZoneOccupancy {
        double from_s;
        std::optional<ZoneHolder> holder;
    };
    struct Zone {
        cell::Shape shape;
        std::vector<ZoneOccupancy> turns;  ///< In the order of time; at first it is free.
    };
    /// Two robots, or a robot and a zone.
    struct Pair {
        std::array<std::size_t, 2> tracks;
        std::optional<std::size_t> zone;
        cell::NeighbourMonitor monitor;
        std::array<std::size_t, 2> next = {};  ///< Numbers of the parts that are still to be checked.
        std::array<std::shared_ptr<const cell::MachineBodies>, 2> bodies = {};
        double time_s = 0;               ///< It has been looked at so far.
        std::size_t turn = 0;            ///< Index in the zone, at that time.
        std::size_t reported_count = 0;  ///< Number of contacts of `monitor` in found_.
    };
    /// One side of a contact.
    struct ContactSide {
        std::size_t robot;
        SourceLocation location;
        rrs::JointPos joints;
        std::string robot_body;
        std::string other;
    };
    struct CollisionFinding {
        std::size_t pair;
        std::size_t contact;  ///< Index in its watch.
        std::vector<ContactSide> sides;
    };

    void add_pair(std::size_t a, std::size_t b, std::optional<std::size_t> zone, os::CpuLimit* cpu);
    bool has_bodies(std::size_t robot) const;
    bool has_separate_base(std::size_t a, std::size_t b) const;
    void attach_track(Track& track);
    void on_segment(Track& track, const motion::Segment& segment, const MoveInfo& info);
    static std::shared_ptr<const cell::MachineBodies> make_bodies(const Track& track);
    static void set_standstill(Track& track, const rrs::JointPos& joints, double from_s);
    static const TrackSegment& sub_segment(const Track& track, std::size_t number);
    static const TrackSegment& segment_at(const Track& track, double time_s);
    static std::string item_name(const Track& track, std::size_t item);
    void advance(Pair& pair, double known_s);
    double occupancy_end_s(Pair& pair, double known_s) const;
    static std::vector<Owner>::const_iterator find_next_owner(const Track& track, double time_s);
    static std::optional<std::size_t> owner_at(const Track& track, double time_s);
    std::optional<std::size_t> find_robot(const ZoneHolder& holder, double time_s) const;
    bool may_enter_zone(const Pair& pair) const;
    void check_pair(Pair& pair, const std::array<const TrackSegment*, 2>& sub_segments, double until_s);
    void note(Pair& pair, const std::array<const TrackSegment*, 2>& sub_segments);
    void discard_passed();
    void add_collision(const CollisionFinding& found, const ContactSide& side,
                       std::vector<RobotReport>& reports) const;

    std::deque<Track> tracks_;  ///< Robots, then zones; their addresses do not change.
    std::size_t robots_;        ///< Number of robots in them.
    std::deque<Zone> zones_;
    std::vector<Pair> pairs_;
    std::vector<CollisionFinding> found_;
    std::function<void()> on_buffer_full_;
};

}  // namespace gsim::simulation
