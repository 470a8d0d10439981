#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "runtime/cell/neighbour_watch.h"
#include "runtime/simulation/robots_report.h"
#include "runtime/simulation/simulator.h"

namespace gsim::simulation {

/// A robot of a run, and where its world is in that of all.
struct PlacedRobot {
    std::string name;
    Simulator& simulator;
    rrs::CartPos base;
};

/// Looks at the robots of a run against each other, while they move: their bodies, and what they carry.
/// Robots of the same base have no places of their own, and are not looked at against each other.
///
/// Robots run ahead of each other. What one does waits here until it is known what the others do meanwhile.
class RobotsWatch {
  public:
    /// Before the first move. The robots' simulators have their cells, and outlive this.
    RobotsWatch(std::vector<PlacedRobot> robots, os::CpuLimit* cpu);
    RobotsWatch(const RobotsWatch&) = delete;
    RobotsWatch& operator=(const RobotsWatch&) = delete;

    /// Whether there are robots to be looked at.
    bool has_pairs() const { return !pairs_.empty(); }
    /// A robot that has not been told to move up to that time stands still until then.
    void know_until(double time_s);
    /// Is called when a robot runs so far ahead that the others should be let go on, for the sake of memory.
    void on_far_ahead(std::function<void()> call) { far_ahead_ = std::move(call); }
    bool is_far_ahead() const;

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
    /// A robot's motion, as far as it is told and not yet looked at.
    struct Track {
        PlacedRobot robot;
        std::shared_ptr<const kinematics::Kinematics> kinematics = {};  ///< Of the machine's file.
        std::uint64_t frame_changes = 0;  ///< Of which `standing` has the bodies.
        std::deque<Piece> pieces = {};
        std::size_t first = 0;  ///< Number of the first of those, from the start of the run on.
        Piece standing = {};    ///< What it does behind them.
        bool moved = false;
    };
    /// Where the robots of a pair were in a contact.
    struct Met {
        std::array<Place, 2> places;
        std::array<rrs::JointPos, 2> joints;
    };
    struct Pair {
        std::array<std::size_t, 2> robots;
        cell::NeighbourWatch watch;
        std::array<std::size_t, 2> next = {};  ///< Numbers of the pieces that are still to be looked at.
        std::array<std::shared_ptr<const cell::MachineBodies>, 2> bodies = {};
        double time_s = 0;          ///< It has been looked at so far.
        std::vector<Met> met = {};  ///< By the contacts of `watch`.
    };

    bool has_bodies(std::size_t robot) const;
    bool has_place_of_its_own(std::size_t a, std::size_t b) const;
    void follow(Track& track);
    void take(Track& track, const motion::Segment& segment, const MoveInfo& info);
    static std::shared_ptr<const cell::MachineBodies> bodies_of(const Track& track);
    static void stand(Track& track, const rrs::JointPos& joints, double from_s);
    const Piece& piece(const Track& track, std::size_t number) const;
    void go_on(Pair& pair, double known_s);
    void look(Pair& pair, const std::array<const Piece*, 2>& pieces, double until_s);
    void drop_passed();
    void add_contacts(const Pair& pair, std::vector<RobotReport>& reports) const;

    std::deque<Track> tracks_;  ///< By robot; they stay where they are.
    std::vector<Pair> pairs_;
    std::function<void()> far_ahead_;
};

}  // namespace gsim::simulation
