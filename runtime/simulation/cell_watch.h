#pragma once

#include <deque>
#include <optional>
#include <string_view>
#include <vector>

#include "runtime/cell/clearance_watch.h"
#include "runtime/motion/cell_frames.h"
#include "runtime/simulation/report.h"
#include "runtime/simulation/run_output.h"

namespace gsim::simulation {

/// The cell of a run: looks at each segment for contacts and near misses of its block, and has the frames
/// that programs may ask for and move.
class CellWatch final : public RunOutput, public motion::CellFrames {
  public:
    CellWatch(cell::Cell cell, const machine::Machine& machine);
    CellWatch(const CellWatch&) = delete;
    CellWatch& operator=(const CellWatch&) = delete;

    const cell::Cell& cell() const { return cell_; }
    tl::expected<rrs::CartPos, motion::PlanError> frame(std::string_view name) const override;
    motion::Planned move_frame(std::string_view name, const rrs::CartPos& pose, double time_s) override;
    tl::expected<motion::WorkFrames, motion::PlanError> work_frames(
        std::string_view tool_frame, std::string_view object_frame) const override;

    using RunOutput::take;
    void take(const motion::Segment& segment, const MoveInfo& info) override;
    void end(double end_s) override;

    /// After end().
    CellFindings release() { return std::move(findings_); }

  private:
    tl::expected<std::size_t, motion::PlanError> find(std::string_view name) const;
    void move_frames(double until_s);
    void end_block();

    cell::Cell cell_;
    /// Frames as the program has set them so far, which segments that are still to come may be behind.
    cell::FrameTree set_frames_;
    struct FrameMove {
        double time_s;
        std::size_t frame;
        rrs::CartPos pose;
    };
    std::deque<FrameMove> frame_moves_;  ///< Not reached yet, in the order of time.
    cell::ClearanceWatch watch_;
    CellFindings findings_;
    std::optional<Place> block_;
    std::vector<Place> places_;  ///< Of the watch's contacts.
};

}  // namespace gsim::simulation
