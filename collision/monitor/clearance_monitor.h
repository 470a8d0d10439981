#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <queue>
#include <vector>

#include "base/os/cpu_limit.h"
#include "collision/cell/cell.h"
#include "collision/monitor/search_backoff.h"
#include "collision/pairs/candidate_pairs.h"
#include "collision/pairs/segment_motion.h"
#include "collision/pairs/separation_budget.h"

namespace gsim::cell {

/// Start of a contact of two bodies. A continuous contact is reported once.
struct Contact {
    double t_s;  ///< Time on the run's clock, to 1e-9 s.
    ItemPair pair;
    Eigen::Vector3d point_mm;  ///< In the world.
    bool penetrating;          ///< By more than 1e-5 mm, before they part; else they only touch.
};

/// The smallest distance of a part of a run.
struct Clearance {
    double distance_mm;  ///< To 1e-4 mm.
    ItemPair pair;
    Eigen::Vector3d point_mm;        ///< In the world, on the second item.
    std::optional<double> t_s = {};  ///< When, of the run's clock; with record_times() alone.
};

/// Monitor of a machine's motion through a cell, segment by segment: bodies that touch, and how near they
/// come. No contact is missed, however thin the body and fast the motion: distances are those of full paths,
/// by bounds of their curvature (conservative advancement: B. Mirtich, 1996).
///
/// A touch of a probe (probes()) while it probes is no contact, nor are the braking and the retraction that
/// follow it. A later move that presses deeper is one, from its start on. The distance of the probe from what
/// it may touch counts again once it has been as far as the cell's clearance.
class ClearanceMonitor {
  public:
    /// Makes a monitor. `cell` must outlive this; it was read for this machine.
    ClearanceMonitor(const Cell& cell, const machine::Machine& machine);

    /// Notes that frames of the cell, or the machine's base, have been moved, or move independently from now
    /// on. A later touch counts as another contact.
    void on_frames_changed();
    /// Ends all checks once that time is used up. Null: never. `cpu` outlives this.
    void set_time_limit(os::CpuLimit* cpu) { cpu_limit_ = cpu; }
    /// Finds from now on the time of the smallest distance of a block, which takes a search for each.
    void record_times() { records_times_ = true; }
    /// Starts another block with the segments that follow.
    void begin_block() { nearest_.reset(); }
    /// Checks the next segment, with the process on or off. `probing`: it belongs to a motion that ends when
    /// the probe touches, or ceases to.
    void on_segment(const motion::Segment& segment, bool process_on, bool probing = false);

    /// Returns how many pairs can meet.
    std::size_t pair_count() const { return pairs_.size(); }
    /// Returns all contacts so far, in the order of segments; within one they may be in any order.
    const std::vector<Contact>& contacts() const { return contacts_; }
    /// Returns the smallest distance of the block so far, if it is below the cell's clearance.
    const std::optional<Clearance>& nearest() const { return nearest_; }

  private:
    /// Max number of checks until a separation budget is sought again.
    static constexpr int kMaxPause = 64;

    /// Contact that a probe was to make.
    struct ProbeContact {
        Eigen::Vector3d normal;              ///< Out of the second body, in its frame.
        Eigen::Vector3d point_on_first_mm;   ///< Touch point on the first one, in its frame,
        Eigen::Vector3d point_on_second_mm;  ///< and on the second one in its own.
        double depth_mm = 0;                 ///< Distance that the first moved on along the normal.
    };
    struct MonitoredPair : CandidatePair {
        bool has_probe = false;                             ///< One of them is the probe.
        double min_distance_mm = 0;                         ///< Distance at the end of the last segment.
        std::optional<std::size_t> contact = std::nullopt;  ///< In contacts_, while it lasts.
        std::optional<Eigen::Vector3d> normal = std::nullopt;
        std::optional<ProbeContact> probe_touch = std::nullopt;  ///< By a probe, until they part.
        bool was_probed = false;                                 ///< And until they are far from each other.
        std::size_t cluster = 0;                                 ///< In clusters_.
        std::size_t checked_sub_segment = 0;  ///< The stretch in which it was last looked at.
    };
    /// Distance, and a pair that comes no nearer before its pair cluster has moved so far.
    struct ScheduledPair {
        double at_mm;
        std::size_t pair;

        bool operator>(const ScheduledPair& other) const { return at_mm > other.at_mm; }
    };
    /// Pair cluster: pairs of one body with all on one link. One bound covers how far they move against each
    /// other, so that far pairs need no work from segment to segment.
    struct PairCluster {
        Body body;
        std::vector<int> between;  ///< From the body's link on.
        bool includes_jet;         ///< All of them, or none.
        bool is_off = false;       ///< They wait for the jet.
        std::vector<std::size_t> pairs = {};
        double travelled_mm = 0;
        double travel_mm = 0;  ///< Part of that in the checked stretch.
        std::priority_queue<ScheduledPair, std::vector<ScheduledPair>, std::greater<>> scheduled_pairs = {};
    };

    void make_pairs();
    bool has_ended() const { return cpu_limit_ != nullptr && cpu_limit_->reached(); }
    void make_clusters();
    void reset_distances(PairCluster& cluster);
    void deactivate(PairCluster& cluster);
    void check_sub_segment(const SegmentMotion& motion, const MotionPart& motion_part, bool process_on);
    void collect_due_pairs(const MotionPart& motion_part, bool process_on, bool with_margin);
    void collect_due_pairs(PairCluster& cluster);
    bool fits_budget(const motion::Segment& segment, bool process_on);
    void add_budget_travel();
    bool should_search_budget();
    void update_budget(const MotionPart& motion_part, bool process_on);
    double sub_segment_end_s(const motion::Segment& segment, double from_s) const;
    std::vector<MovingLink> update_moving_links(double time_s);
    void monitor_pair(const SegmentMotion& motion, const MotionPart& full_motion, MonitoredPair& pair);
    void raise_min_distance(const MotionPart& full_motion, MonitoredPair& pair) const;
    double cutoff_mm() const;
    void note(const DistanceBounds& distance_bounds, const MonitoredPair& pair, const SegmentMotion& motion,
              const MotionPart& full_motion);
    bool is_exempt_probe_pair(const MotionPart& full_motion, MonitoredPair& pair) const;
    void begin_contact(const SegmentMotion& motion, const MotionPart& full_motion, MonitoredPair& pair);
    void begin_probe_contact(const SegmentMotion& motion, const MotionPart& full_motion, MonitoredPair& pair);
    void continue_probe_contact(const SegmentMotion& motion, const MotionPart& full_motion,
                                MonitoredPair& pair);
    void continue_contact(const SegmentMotion& motion, const MotionPart& full_motion, MonitoredPair& pair,
                          double from_s);

    const Cell& cell_;
    std::shared_ptr<const kinematics::Kinematics> machine_kinematics_;
    std::shared_ptr<const kinematics::Kinematics> kinematics_;  ///< Machine at its current position.
    std::vector<int> parents_;                                  ///< Parents of independent links.
    std::vector<double> motion_starts_s_;                       ///< For those links, in the previous stretch.
    std::vector<MonitoredPair> pairs_;
    std::vector<PairCluster> clusters_;
    std::vector<std::size_t> due_pairs_;  ///< Pairs to check in a stretch, in their order.
    std::size_t sub_segment_number_ = 0;  ///< Counted from 1.
    SeparationBudget budget_;             ///< For all pairs that count while the jet state is unchanged.
    bool budget_with_jet_ = false;
    SearchBackoff budget_backoff_{kMaxPause};
    double margin_mm_ = 0;  ///< Pairs that are due within that much more are looked at in this stretch.
    std::vector<Contact> contacts_;
    std::optional<Clearance> nearest_;
    bool records_times_ = false;
    os::CpuLimit* cpu_limit_ = nullptr;
    bool is_probing_ = false;  ///< In the segment that is looked at.
};

}  // namespace gsim::cell
