#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <queue>
#include <vector>

#include "base/os/cpu_limit.h"
#include "collision/cell/machine_bodies.h"
#include "collision/monitor/clearance_watch.h"
#include "collision/pairs/two_machines_motion.h"

namespace gsim::cell {

/// Looks at the motion of two machines in one world, on one clock: which bodies of the first touch which of
/// the second. As with ClearanceWatch no contact is passed over; how near they come besides is not told.
class NeighbourWatch {
  public:
    /// How one of them goes from the instant on from which both are looked at.
    struct Going {
        const motion::Segment& segment;
        double from_s;  ///< Since the start of the segment.
        bool jet_on;
    };

    /// Where the worlds of the machines are in that of both.
    NeighbourWatch(const rrs::CartPos& first_world, const rrs::CartPos& second_world)
        : worlds_{first_world, second_world} {}

    /// What is looked at from now on: at first, and when frames have been moved. What touches then counts as
    /// another contact.
    void set_bodies(std::shared_ptr<const MachineBodies> first, std::shared_ptr<const MachineBodies> second);
    /// When that time is used up nothing is looked at any longer. Null: never. `cpu` outlives this.
    void end_by(os::CpuLimit* cpu) { cpu_ = cpu; }
    /// Both go on for that long, from `start_s` of the run's clock on.
    void take(double start_s, double duration_s, const Going& first, const Going& second);

    /// How many pairs of bodies are looked at.
    std::size_t pair_count() const { return pairs_.size(); }
    /// All so far; the first item of a pair is one of the first machine's cell, the second one of the
    /// second's. Points are in the world of both.
    const std::vector<Contact>& contacts() const { return contacts_; }

  private:
    struct Watched {
        ItemPair items;
        BodyPair bodies;
        std::array<bool, 2> jets;                           ///< Whose jet it is; none: of bodies.
        std::optional<std::size_t> contact = std::nullopt;  ///< In contacts_, while it lasts.
        std::optional<Eigen::Vector3d> normal = std::nullopt;
    };
    /// A way of both together, and a pair that does not touch before it is gone.
    struct Due {
        double at_mm;
        std::size_t pair;

        bool operator>(const Due& other) const { return at_mm > other.at_mm; }
    };
    using DueQueue = std::priority_queue<Due, std::vector<Due>, std::greater<>>;

    void add_pair(const CarriedBody& first, const CarriedBody& second);
    void forget_distances();
    bool goes_on_far(const std::array<JointTravel, 2>& travels);
    void measure_reaches(const std::array<MachineStretch, 2>& stretches, double t_s);
    void look(double start_s, const TwoMachinesMotion& motion, const MotionPart& whole, double way_mm);
    double look_at(double start_s, const TwoMachinesMotion& motion, const MotionPart& whole, Watched& pair,
                   double ahead_mm);

    std::array<rrs::CartPos, 2> worlds_;
    std::array<std::shared_ptr<const MachineBodies>, 2> machines_;
    std::array<ReachBound, 2> reaches_;
    std::array<bool, 2> jets_{};  ///< That are on.
    std::vector<Watched> pairs_;
    double gone_mm_ = 0;
    DueQueue due_;
    std::vector<std::size_t> now_;  ///< The pairs to look at in a stretch, in their order.
    std::vector<Contact> contacts_;
    os::CpuLimit* cpu_ = nullptr;
};

}  // namespace gsim::cell
