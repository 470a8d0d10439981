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

#include "collision/monitor/neighbour_watch.h"
#include "runtime/report/robots_report.h"
#include "runtime/simulator/simulator.h"

namespace gsim::simulation {

/// A robot of a run, and where its world is in that of all.
struct PlacedRobot {
    std::string name;
    Simulator& simulator;
    rrs::CartPos base;
};

/// A zone in which one robot may be at a time, in the world of all.
struct PlacedZone {
    std::string name;
    cell::Shape shape;
    rrs::CartPos frame;
};

/// Looks at the robots of a run against each other, while they move: their bodies, and what they carry.
/// Robots of the same base have no places of their own, and are not looked at against each other. And finds
/// robots in zones that another process has.
///
/// Robots run ahead of each other. What one does waits here until it is known what the others do meanwhile.
class RobotsWatch {
  public:
    /// Before the first move. The robots' simulators have their cells, and outlive this.
    RobotsWatch(const std::vector<PlacedRobot>& robots, const std::vector<PlacedZone>& zones,
                os::CpuLimit* cpu);
    RobotsWatch(const RobotsWatch&) = delete;
    RobotsWatch& operator=(const RobotsWatch&) = delete;

    /// Whether there is something to be looked at.
    bool has_pairs() const { return !pairs_.empty(); }
    /// A robot that has not been told to move up to that time stands still until then, but for what its
    /// planner, or the wait for conveyors, has not passed on; and zones that nobody was given are as they
    /// were.
    void know_until(double time_s);
    /// Is called when a robot runs so far ahead that the others should be let go on, for the sake of memory.
    void on_far_ahead(std::function<void()> call) { far_ahead_ = std::move(call); }

    /// A process, by its number and its name.
    struct Holder {
        std::size_t process;
        std::string name;
    };
    /// That one has the zone from a time on up to which not all is known yet; none: nobody has it.
    void give_zone(std::size_t zone, double time_s, std::optional<Holder> holder);
    /// That process has the robot from a time on, likewise, and is who has had it where it lets it go. A
    /// robot that no process has had is in nobody's way in a zone.
    void give_robot(std::size_t robot, double time_s, std::size_t process);

    /// Behind the run: all robots stand where they are from there on.
    void finish() { know_until(std::numeric_limits<double>::infinity()); }
    /// Behind finish(): what touches goes into the reports of both robots, which are in the order of the
    /// robots.
    void add_findings(std::vector<RobotReport>& reports) const;
    /// For the report of all: which robots were not looked at against each other, as sentences.
    std::vector<std::string> warnings() const;

  private:
    /// A piece of a robot's motion.
    struct Piece {
        motion::Segment segment;
        Place place;
        bool jet_on = false;
        std::shared_ptr<const cell::MachineBodies> bodies = {};
    };
    /// Which process has a robot from a time on.
    struct Owner {
        double from_s;
        std::size_t process;
    };
    /// A robot's motion, as far as it is told and not yet looked at; or a zone, which stands.
    struct Track {
        std::string name;
        rrs::CartPos base;
        Simulator* simulator = nullptr;                                 ///< None of a zone.
        std::shared_ptr<const kinematics::Kinematics> kinematics = {};  ///< Of the machine's file.
        std::uint64_t frame_changes = 0;  ///< Of which `standing` has the bodies.
        std::deque<Piece> pieces = {};
        std::size_t first = 0;           ///< Number of the first of those, from the start of the run on.
        Piece standing = {};             ///< What it does behind them.
        std::vector<Owner> owners = {};  ///< In the order of time.
        bool moved = false;
    };
    /// Who has a zone from a time on.
    struct Turn {
        double from_s;
        std::optional<Holder> holder;
    };
    struct Zone {
        cell::Shape shape;
        std::vector<Turn> turns;  ///< In the order of time; at first nobody has it.
    };
    /// Two robots, or a robot and a zone.
    struct Pair {
        std::array<std::size_t, 2> tracks;
        std::optional<std::size_t> zone;
        cell::NeighbourWatch watch;
        std::array<std::size_t, 2> next = {};  ///< Numbers of the pieces that are still to be looked at.
        std::array<std::shared_ptr<const cell::MachineBodies>, 2> bodies = {};
        double time_s = 0;     ///< It has been looked at so far.
        std::size_t turn = 0;  ///< Of the zone, at that time.
        std::size_t told = 0;  ///< Of the contacts of `watch`, those in found_.
    };
    /// One side of a contact.
    struct Side {
        std::size_t robot;
        Place place;
        rrs::JointPos joints;
        std::string own;
        std::string other;
    };
    struct Found {
        std::size_t pair;
        std::size_t contact;  ///< Of its watch.
        std::vector<Side> sides;
    };

    void add_pair(std::size_t a, std::size_t b, std::optional<std::size_t> zone, os::CpuLimit* cpu);
    bool has_bodies(std::size_t robot) const;
    bool has_place_of_its_own(std::size_t a, std::size_t b) const;
    void follow(Track& track);
    void take(Track& track, const motion::Segment& segment, const MoveInfo& info);
    static std::shared_ptr<const cell::MachineBodies> bodies_of(const Track& track);
    static void stand(Track& track, const rrs::JointPos& joints, double from_s);
    static const Piece& piece(const Track& track, std::size_t number);
    static const Piece& piece_at(const Track& track, double time_s);
    static std::string item_name(const Track& track, std::size_t item);
    void go_on(Pair& pair, double known_s);
    double end_of_turn_s(Pair& pair, double known_s) const;
    static std::vector<Owner>::const_iterator owner_behind(const Track& track, double time_s);
    static std::optional<std::size_t> owner_at(const Track& track, double time_s);
    std::optional<std::size_t> robot_of(const Holder& holder, double time_s) const;
    bool is_let_in(const Pair& pair) const;
    void look(Pair& pair, const std::array<const Piece*, 2>& pieces, double until_s);
    void note(Pair& pair, const std::array<const Piece*, 2>& pieces);
    void drop_passed();
    void add_collision(const Found& found, const Side& side, std::vector<RobotReport>& reports) const;

    std::deque<Track> tracks_;  ///< Of the robots, and behind them of the zones; they stay where they are.
    std::size_t robots_;        ///< How many of those are robots.
    std::deque<Zone> zones_;
    std::vector<Pair> pairs_;
    std::vector<Found> found_;
    std::function<void()> far_ahead_;
};

}  // namespace gsim::simulation
