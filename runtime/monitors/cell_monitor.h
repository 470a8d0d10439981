#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "collision/monitor/clearance_monitor.h"
#include "collision/monitor/touch_search.h"
#include "motion/path/machine_frames.h"
#include "runtime/monitors/frame_history.h"
#include "runtime/monitors/programmed_frames.h"
#include "runtime/outputs/run_output.h"
#include "runtime/report/report.h"

namespace gsim::simulation {

/// Use of a cell in a run.
struct CellOptions {
    bool is_from_file =
        true;  ///< A cell file describes it; else it is the machine alone, and no probe feels it.
    bool monitored = true;  ///< Contacts and near misses are looked for.
};

/// Cell of a run: checks each segment for contacts and near misses of its block, and has the frames that
/// programs may query and move.
class CellMonitor final : public RunOutput, public motion::CellFrames {
  public:
    CellMonitor(cell::Cell cell, const machine::Machine& machine, CellOptions use = {});
    CellMonitor(const CellMonitor&) = delete;
    CellMonitor& operator=(const CellMonitor&) = delete;

    const cell::Cell& cell() const { return cell_; }
    /// Ends all checks of segments once that CPU time is used up. Null: never.
    void set_time_limit(os::CpuLimit* cpu) { monitor_.set_time_limit(cpu); }
    const CellOptions& use() const { return options_; }
    const machine::Machine& machine() const { return machine_; }
    /// Receiver of the checked segments, in order, while the frames of cell() are at their poses in it.
    using SegmentListener = std::function<void(const motion::Segment& segment, const MoveInfo& info)>;
    void set_segment_listener(SegmentListener follower) { segment_listener_ = std::move(follower); }
    /// Returns how often frames of cell() have been moved so far.
    std::uint64_t frame_changes() const { return frame_changes_; }
    tl::expected<rrs::CartPos, motion::PlanError> frame(std::string_view name, double time_s) const override;
    motion::PlanResult move_frame(std::string_view name, const rrs::CartPos& pose, double time_s) override;
    motion::PlanResult enable_frame_motion(std::string_view name) override;
    void interpolate_frame(std::string_view name, const rrs::CartPos& pose, double from_s,
                           double to_s) override;
    tl::expected<motion::WorkFrames, motion::PlanError> work_frames(
        std::string_view tool_frame, std::string_view object_frame) const override {
        return programmed_frames_.work_frames(tool_frame, object_frame);
    }
    const rrs::CartPos& base_shift() const override {
        return programmed_frames_.machine_frames().base_shift();
    }

    /// Returns the search for what a probe feels from a time on at which the machine is at standstill, after
    /// all motion before has been processed. The cell must not change while the search is used. `tcp_mm` and
    /// the error are those of TouchSearch.
    Result<cell::TouchSearch> touch_search(const Eigen::Vector3d& tcp_mm, double time_s);

    /// Keeps from now on the motion of frames, for history(), and the times at which blocks come near, for
    /// clearance_times_s().
    void keep_history() {
        history_.start();
        monitor_.record_times();
    }
    const FrameHistory& history() const { return history_; }
    /// Returns the time of each of CellFindings::clearances, on the run's clock; nullopt if unknown.
    std::span<const std::optional<double>> clearance_times_s() const { return clearance_times_s_; }

    /// Returns true if the cell has conveyors: their motion must be known before a segment can be checked.
    bool has_conveyors() const;
    /// Sets the motion of a conveyor from drift.from_s on, wherever it was. It has no effect if the cell does
    /// not know it.
    void set_conveyor(std::string_view name, const cell::UniformMotion& uniform_motion);
    /// Sets the time up to which the motion of conveyors is known (at first, infinite): segments that end
    /// later wait.
    void set_known_until(double time_s);
    /// Returns the time up to which the follower (set_segment_listener) has got all motion; infinite if no
    /// segment waits.
    double delivered_until_s() const {
        return pending_segments_.empty() ? std::numeric_limits<double>::infinity()
                                         : pending_segments_.front().segment.start_s;
    }

    void on_segment(const motion::Segment& segment, const MoveInfo& info) override;
    void end(double end_s) override;

    /// Returns the findings, after end().
    CellFindings release() { return std::move(findings_); }

  private:
    struct PendingSegment {
        motion::Segment segment;
        MoveInfo info;
    };

    tl::expected<std::size_t, motion::PlanError> find_movable(std::string_view name) const;
    std::optional<std::size_t> find_carrier(std::size_t frame) const;
    void check_segment(const motion::Segment& segment, const MoveInfo& info);
    void move_frames(double until_s);
    void on_frames_changed();
    void end_block();

    machine::Machine machine_;
    CellOptions options_;
    cell::Cell cell_;
    ProgrammedFrames programmed_frames_;
    struct FrameMove {
        double time_s;
        std::size_t frame;
        rrs::CartPos pose;
    };
    std::deque<FrameMove> frame_moves_;  ///< Not reached yet, in the order of time.
    double known_until_s_ = std::numeric_limits<double>::infinity();
    std::deque<PendingSegment> pending_segments_;
    cell::ClearanceMonitor monitor_;
    SegmentListener segment_listener_;
    std::uint64_t frame_changes_ = 0;
    FrameHistory history_;
    std::vector<std::optional<double>> clearance_times_s_;
    CellFindings findings_;
    std::optional<SourceLocation> block_;
    std::vector<SourceLocation> contact_locations_;  ///< Locations of the contacts,
    std::vector<rrs::JointPos> joints_;              ///< and the machine's joint values.
};

}  // namespace gsim::simulation
