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

/// Two bodies begin to touch. One that is touched all the time is told once.
struct Contact {
    double t_s;  ///< Of the run's clock, to 1e-9 s.
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

/// Looks at a machine's motion through a cell, segment by segment: which bodies touch, and how near they
/// come. No contact is passed over, however thin the body and fast the motion: distances are those of whole
/// ways, by bounds of how far the way bends (conservative advancement: B. Mirtich, 1996).
///
/// What a probe touches (probes()) while it probes is no contact, nor are the braking behind it and the way
/// out; a later move that goes deeper is one, from its start on. How near the probe comes to what it may
/// touch counts again once it has been as far as the cell's clearance.
class ClearanceWatch {
  public:
    /// `cell` must outlive this; it was read for this machine.
    ClearanceWatch(const Cell& cell, const machine::Machine& machine);

    /// Frames of the cell, or the machine's base, have been moved, or go by themselves from now on: what
    /// touches then counts as another contact.
    void frames_changed();
    /// When that time is used up nothing is looked at any longer. Null: never. `cpu` outlives this.
    void end_by(os::CpuLimit* cpu) { cpu_ = cpu; }
    /// From now on it is known when the smallest distance of a block is, which takes a search for each.
    void keep_times() { keeps_times_ = true; }
    /// The segments that follow belong to another block.
    void begin_block() { nearest_.reset(); }
    /// The next segment, with or without the jet; `probing`: of a motion that ends where the probe touches,
    /// or ceases to.
    void take(const motion::Segment& segment, bool jet_on, bool probing = false);

    /// How many pairs can meet.
    std::size_t pair_count() const { return pairs_.size(); }
    /// All so far, in the order of segments; within one they may stand in any order.
    const std::vector<Contact>& contacts() const { return contacts_; }
    /// The smallest distance of the block so far, where it is below the cell's clearance.
    const std::optional<Clearance>& nearest() const { return nearest_; }

  private:
    /// A contact that a probe was to make.
    struct Touched {
        Eigen::Vector3d normal;        ///< Out of the second body, in its frame.
        Eigen::Vector3d on_first_mm;   ///< Where the first one was touched, in its frame,
        Eigen::Vector3d on_second_mm;  ///< and the second one in its own.
        double depth_mm = 0;           ///< How far the first went on along the normal.
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
    /// A distance and a pair that comes no nearer before its crowd has gone so far.
    struct Due {
        double at_mm;
        std::size_t pair;

        bool operator>(const Due& other) const { return at_mm > other.at_mm; }
    };
    /// Pairs of one body with all on one link: how far they go against each other has one bound, so that
    /// those that are far are not touched from segment to segment.
    struct Crowd {
        Body body;
        std::vector<int> between;  ///< From the body's link on.
        bool with_jet;             ///< All of them, or none.
        bool is_off = false;       ///< They wait for the jet.
        std::vector<std::size_t> pairs = {};
        double gone_mm = 0;
        double way_mm = 0;  ///< Of that, in the stretch that is looked at.
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
    std::shared_ptr<const kinematics::Kinematics> kinematics_;  ///< Where the machine stands now.
    std::vector<int> parents_;                                  ///< Of links that go by themselves.
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
