#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "collision/monitor/clearance_watch.h"
#include "collision/monitor/touch_search.h"
#include "motion/path/machine_frames.h"
#include "runtime/outputs/run_output.h"
#include "runtime/report/report.h"

namespace gsim::simulation {

/// What a run takes of a cell.
struct CellUse {
    bool of_file = true;  ///< A cell file describes it; else it is the machine alone, and no probe feels it.
    bool watched = true;  ///< Contacts and near misses are looked for.
};

/// How a frame of a cell went, or stood, from a time on.
struct FrameDrift {
    std::size_t frame;
    cell::Drift drift;
};

/// The cell of a run: looks at each segment for contacts and near misses of its block, and has the frames
/// that programs may ask for and move.
class CellWatch final : public RunOutput, public motion::CellFrames {
  public:
    CellWatch(cell::Cell cell, const machine::Machine& machine, CellUse use = {});
    CellWatch(const CellWatch&) = delete;
    CellWatch& operator=(const CellWatch&) = delete;

    const cell::Cell& cell() const { return cell_; }
    /// When that time is used up segments are looked at no longer. Null: never.
    void end_by(os::CpuLimit* cpu) { watch_.end_by(cpu); }
    const CellUse& use() const { return use_; }
    const machine::Machine& machine() const { return machine_; }
    /// Who is told each segment once it has been looked at, in their order, while the frames of cell() are
    /// where they are in it.
    using Follower = std::function<void(const motion::Segment& segment, const MoveInfo& info)>;
    void set_follower(Follower follower) { follower_ = std::move(follower); }
    /// How often frames of cell() have been moved so far.
    std::uint64_t frame_changes() const { return frame_changes_; }
    tl::expected<rrs::CartPos, motion::PlanError> frame(std::string_view name, double time_s) const override;
    motion::Planned move_frame(std::string_view name, const rrs::CartPos& pose, double time_s) override;
    motion::Planned carry_frame(std::string_view name) override;
    void lead_frame(std::string_view name, const rrs::CartPos& pose, double from_s, double to_s) override;
    tl::expected<motion::WorkFrames, motion::PlanError> work_frames(
        std::string_view tool_frame, std::string_view object_frame) const override;
    const rrs::CartPos& base_shift() const override { return machine_frames_.base_shift(); }

    /// What a probe feels from a time on at which the machine is at rest, all its motion before having been
    /// taken; the cell must not change while the search is used. `tip_mm` and the error are those of
    /// TouchSearch.
    tl::expected<cell::TouchSearch, std::string> touch_search(const Eigen::Vector3d& tip_mm, double time_s);

    /// From now on what moves frames is kept, for history(), and when blocks come near, for near_s().
    void keep_history() {
        keeps_history_ = true;
        watch_.keep_times();
    }
    /// Of more than these there is no history.
    static constexpr std::size_t kMostDrifts = 100'000;
    bool history_is_whole() const { return history_is_whole_; }
    /// When each of CellFindings::clearances is, of the run's clock; nothing where it is not known.
    std::span<const std::optional<double>> near_s() const { return near_s_; }
    /// In the order in which it was told, which is that of time for each frame; from `from_s` of an entry on
    /// earlier ones of its frame no longer hold.
    std::span<const FrameDrift> history() const { return history_; }

    /// Whether there are conveyors, whose motion must be known before a segment can be looked at.
    bool has_conveyors() const;
    /// A conveyor runs so from drift.from_s on, no matter where it was. Nothing where the cell does not know
    /// it.
    void set_conveyor(std::string_view name, const cell::Drift& drift);
    /// The motion of conveyors is known up to that time (at first, for ever): segments that end later wait.
    void know_until(double time_s);
    /// Up to here what follows the motion (set_follower) has got it; infinite where none waits.
    double passed_on_s() const {
        return waiting_.empty() ? std::numeric_limits<double>::infinity() : waiting_.front().segment.start_s;
    }

    using RunOutput::take;
    void take(const motion::Segment& segment, const MoveInfo& info) override;
    void end(double end_s) override;

    /// After end().
    CellFindings release() { return std::move(findings_); }

  private:
    struct Waiting {
        motion::Segment segment;
        MoveInfo info;
    };

    tl::expected<std::size_t, motion::PlanError> find(std::string_view name) const;
    tl::expected<std::size_t, motion::PlanError> find_movable(std::string_view name) const;
    tl::expected<rrs::CartPos, motion::PlanError> tip_frame(std::string_view name) const;
    tl::expected<rrs::CartPos, motion::PlanError> object_frame(std::string_view name) const;
    motion::Planned moves_together(std::size_t frame, std::size_t origin) const;
    std::optional<std::size_t> carrier_of(std::size_t frame) const;
    void note(std::size_t frame, const cell::Drift& drift) {
        if (!keeps_history_) return;
        if (history_.size() < kMostDrifts)
            history_.push_back({frame, drift});
        else
            history_is_whole_ = false;
    }
    void look_at(const motion::Segment& segment, const MoveInfo& info);
    void move_frames(double until_s);
    void frames_changed();
    void end_block();

    machine::Machine machine_;
    CellUse use_;
    cell::Cell cell_;
    /// Frames as the program has set them so far, which segments that are still to come may be behind.
    cell::FrameTree set_frames_;
    /// The machine's own as the program has set them. In the trees "tool" is the file's: another tip moves no
    /// body.
    motion::MachineFrames machine_frames_;
    struct FrameMove {
        double time_s;
        std::size_t frame;
        rrs::CartPos pose;
    };
    std::deque<FrameMove> frame_moves_;  ///< Not reached yet, in the order of time.
    double known_until_s_ = std::numeric_limits<double>::infinity();
    std::deque<Waiting> waiting_;
    cell::ClearanceWatch watch_;
    Follower follower_;
    std::uint64_t frame_changes_ = 0;
    bool keeps_history_ = false;
    bool history_is_whole_ = true;
    std::vector<FrameDrift> history_;
    std::vector<std::optional<double>> near_s_;
    CellFindings findings_;
    std::optional<Place> block_;
    std::vector<Place> places_;          ///< Of the watch's contacts,
    std::vector<rrs::JointPos> joints_;  ///< and where the machine stood.
};

}  // namespace gsim::simulation
