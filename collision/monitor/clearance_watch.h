#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <queue>
#include <vector>

#include "base/os/cpu_limit.h"
#include "collision/cell/cell.h"
#include "collision/pairs/leeway.h"
#include "collision/pairs/meeting_pairs.h"
#include "collision/pairs/segment_motion.h"

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
    std::optional<double> t_s = {};  ///< When, of the run's clock; with keep_times() alone.
};

/// Monitor of a machine's motion through a cell, segment by segment: bodies that touch, and how near they
/// come. No contact is missed, however thin the body and fast the motion: distances are those of full paths,
/// by bounds of their curvature (conservative advancement: B. Mirtich, 1996).
///
/// A touch of a probe (probes()) while it probes is no contact, nor are the braking after it and the
/// retraction. A later move that presses deeper is one, from its start on. The distance of the probe from
/// what it may touch counts again once it has been as far as the cell's clearance.
class ClearanceWatch {
  public:
    /// Makes a monitor. `cell` must outlive this; it was read for this machine.
    ClearanceWatch(const Cell& cell, const machine::Machine& machine);

    /// Notes that frames of the cell, or the machine's base, have been moved, or move independently from now
    /// on. A touch after that counts as another contact.
    void frames_changed();
    /// Ends all checks after that time is used up. Null: never. `cpu` outlives this.
    void end_by(os::CpuLimit* cpu) { cpu_ = cpu; }
    /// Finds from now on the time of the smallest distance of a block, which takes a search for each.
    void keep_times() { keeps_times_ = true; }
    /// Starts another block with the segments that follow.
    void begin_block() { nearest_.reset(); }
    /// Checks the next segment, with the process on or off. `probing`: it belongs to a motion that ends when
    /// the probe touches, or ceases to.
    void take(const motion::Segment& segment, bool jet_on, bool probing = false);

    /// Returns how many pairs can meet.
    std::size_t pair_count() const { return pairs_.size(); }
    /// Returns all contacts so far, in the order of segments; within one they may be in any order.
    const std::vector<Contact>& contacts() const { return contacts_; }
    /// Returns the smallest distance of the block so far, if it is below the cell's clearance.
    const std::optional<Clearance>& nearest() const { return nearest_; }

  private:
    /// Contact that a probe was to make.
    struct Touched {
        Eigen::Vector3d normal;        ///< Out of the second body, in its frame.
        Eigen::Vector3d on_first_mm;   ///< Touch point on the first one, in its frame,
        Eigen::Vector3d on_second_mm;  ///< and on the second one in its own.
        double depth_mm = 0;           ///< Distance that the first moved on along the normal.
    };
    struct Watched : MeetingPair {
        bool by_probe = false;                              ///< One of them is the probe.
        double at_least_mm = 0;                             ///< Distance at the end of the last segment.
        std::optional<std::size_t> contact = std::nullopt;  ///< In contacts_, while it lasts.
        std::optional<Eigen::Vector3d> normal = std::nullopt;
        std::optional<Touched> touched = std::nullopt;  ///< By a probe, until they part.
        bool probed = false;                            ///< And until they are far from each other.
        std::size_t crowd = 0;                          ///< In crowds_.
        std::size_t looked = 0;                         ///< The stretch in which it was last looked at.
    };
    /// Distance, and a pair that comes no nearer before its pair cluster has moved so far.
    struct Due {
        double at_mm;
        std::size_t pair;

        bool operator>(const Due& other) const { return at_mm > other.at_mm; }
    };
    /// Pair cluster: pairs of one body with all on one link. One bound covers how far they move against each
    /// other, so that far pairs need no work from segment to segment.
    struct Crowd {
        Body body;
        std::vector<int> between;  ///< From the body's link on.
        bool with_jet;             ///< All of them, or none.
        bool is_off = false;       ///< They wait for the jet.
        std::vector<std::size_t> pairs = {};
        double gone_mm = 0;
        double way_mm = 0;  ///< Part of that in the checked stretch.
        std::priority_queue<Due, std::vector<Due>, std::greater<>> due = {};
    };

    void make_pairs();
    bool has_ended() const { return cpu_ != nullptr && cpu_->reached(); }
    void make_crowds();
    void forget_distances(Crowd& crowd);
    void switch_off(Crowd& crowd);
    void take_stretch(const SegmentMotion& motion, const MotionPart& stretch, bool jet_on);
    void collect_due(const MotionPart& stretch, bool jet_on, bool early);
    void collect_due(Crowd& crowd);
    bool is_far(const motion::Segment& segment, bool jet_on);
    void go_on_far();
    bool seeks_leeway();
    void find_leeway(const MotionPart& stretch, bool jet_on);
    double stretch_end_s(const motion::Segment& segment, double from_s) const;
    std::vector<DriftingLink> drifting(double time_s);
    void watch(const SegmentMotion& motion, const MotionPart& whole, Watched& pair);
    void look_ahead(const MotionPart& whole, Watched& pair) const;
    double cutoff_mm() const;
    void note(const Nearness& nearness, const Watched& pair, const SegmentMotion& motion,
              const MotionPart& whole);
    bool is_let_near(const MotionPart& whole, Watched& pair) const;
    void begin_contact(const SegmentMotion& motion, const MotionPart& whole, Watched& pair);
    void probe_contact(const SegmentMotion& motion, const MotionPart& whole, Watched& pair);
    void go_on_touched(const SegmentMotion& motion, const MotionPart& whole, Watched& pair);
    void go_on_in_contact(const SegmentMotion& motion, const MotionPart& whole, Watched& pair, double from_s);

    const Cell& cell_;
    std::shared_ptr<const kinematics::Kinematics> machine_kinematics_;
    std::shared_ptr<const kinematics::Kinematics> kinematics_;  ///< Machine at its current position.
    std::vector<int> parents_;                                  ///< Parents of independent links.
    std::vector<double> drifts_since_s_;                        ///< For those links, in the previous stretch.
    std::vector<Watched> pairs_;
    std::vector<Crowd> crowds_;
    std::vector<std::size_t> due_;  ///< Pairs to check in a stretch, in their order.
    std::size_t stretch_ = 0;       ///< Counted from 1.
    Leeway leeway_;                 ///< For all pairs that count while the jet state is unchanged.
    bool leeway_with_jet_ = false;
    int leeway_pause_ = 0;  ///< Checks until the next search for it,
    int next_pause_ = 1;    ///< and the next such count, if no budget was found.
    double early_mm_ = 0;   ///< Pairs that are due within that much more are looked at in this stretch.
    std::vector<Contact> contacts_;
    std::optional<Clearance> nearest_;
    bool keeps_times_ = false;
    os::CpuLimit* cpu_ = nullptr;
    bool probing_ = false;  ///< In the segment that is looked at.
};

}  // namespace gsim::cell
