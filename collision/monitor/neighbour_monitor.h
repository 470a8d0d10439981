#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <queue>
#include <vector>

#include "base/os/cpu_limit.h"
#include "collision/cell/machine_bodies.h"
#include "collision/monitor/clearance_monitor.h"
#include "collision/pairs/two_machines_motion.h"

namespace gsim::cell {

/// Monitor of the motion of two machines in one world, on one clock: reports which bodies of the first touch
/// which of the second. As with ClearanceMonitor no contact is missed. Distances without contact are not
/// reported.
class NeighbourMonitor {
  public:
    /// Motion of one of the machines, from the instant at which the check of both starts.
    struct ActiveSegment {
        const motion::Segment& segment;
        double from_s;  ///< Since the start of the segment.
        bool process_on;
    };

    /// Sets the poses of the machines' worlds in the common world.
    NeighbourMonitor(const rrs::CartPos& first_world, const rrs::CartPos& second_world)
        : world_frames_{first_world, second_world} {}

    /// Sets the bodies to check from now on: at first, and whenever frames have been moved. Bodies that touch
    /// then count as another contact.
    void set_bodies(std::shared_ptr<const MachineBodies> first, std::shared_ptr<const MachineBodies> second);
    /// Ends all checks once that CPU time is used up. Null: never. `cpu` outlives this.
    void set_time_limit(os::CpuLimit* cpu) { cpu_limit_ = cpu; }
    /// Checks the motion of both for that duration, from `start_s` of the run's clock on.
    void on_segment(double start_s, double duration_s, const ActiveSegment& first,
                    const ActiveSegment& second);

    /// Returns the number of body pairs that are checked.
    std::size_t pair_count() const { return pairs_.size(); }
    /// Returns all contacts so far. The first item of a pair is from the first machine's cell, the second
    /// from the second's. Points are in the common world.
    const std::vector<Contact>& contacts() const { return contacts_; }

  private:
    struct MonitoredPair {
        ItemPair items;
        BodyPair bodies;
        std::array<bool, 2> jets;                           ///< True for a jet; both false: bodies.
        std::optional<std::size_t> contact = std::nullopt;  ///< In contacts_, while it lasts.
        std::optional<Eigen::Vector3d> normal = std::nullopt;
    };
    /// Pair of bodies, and the combined travel of both machines before which it does not touch.
    struct ScheduledPair {
        double at_mm;
        std::size_t pair;

        bool operator>(const ScheduledPair& other) const { return at_mm > other.at_mm; }
    };
    using ScheduleQueue = std::priority_queue<ScheduledPair, std::vector<ScheduledPair>, std::greater<>>;

    void add_pair(const CarriedBody& first, const CarriedBody& second);
    void reset_distances();
    bool stays_clear(const std::array<JointTravel, 2>& travels);
    void measure_reaches(const std::array<MachineMotion, 2>& motion_parts, double t_s);
    void check_pairs(double start_s, const TwoMachinesMotion& motion, const MotionPart& full_motion,
                     double travel_mm);
    double check_ahead(double start_s, const TwoMachinesMotion& motion, const MotionPart& full_motion,
                       MonitoredPair& pair, double search_limit_mm);

    std::array<rrs::CartPos, 2> world_frames_;
    std::array<std::shared_ptr<const MachineBodies>, 2> machines_;
    std::array<ReachBound, 2> reaches_;
    std::array<bool, 2> jets_{};  ///< That are on.
    std::vector<MonitoredPair> pairs_;
    double travelled_mm_ = 0;
    ScheduleQueue scheduled_pairs_;
    std::vector<std::size_t> due_pairs_;  ///< Pairs to check in a stretch, in their order.
    std::vector<Contact> contacts_;
    os::CpuLimit* cpu_limit_ = nullptr;
};

}  // namespace gsim::cell
