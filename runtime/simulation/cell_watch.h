#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "runtime/cell/clearance_watch.h"
#include "runtime/rrs/status.h"
#include "runtime/simulation/report.h"
#include "runtime/simulation/run_output.h"

namespace gsim::simulation {

/// The cell of a run: looks at each segment for contacts and near misses of its block, and has the frames
/// that programs may ask for and move.
class CellWatch final : public RunOutput {
  public:
    CellWatch(cell::Cell cell, const machine::Machine& machine);
    CellWatch(const CellWatch&) = delete;
    CellWatch& operator=(const CellWatch&) = delete;

    const cell::Cell& cell() const { return cell_; }
    /// The value of a frame, relative to what it is attached to. RRS_UNKNOWN_FRAME.
    rrs::Status get_frame(std::string_view name, rrs::CartPos& frame) const;
    /// Gives a frame another value, from now on. RRS_UNKNOWN_FRAME; RRS_INVALID_PARAMETER for a frame of the
    /// machine.
    rrs::Status move_frame(std::string_view name, const rrs::CartPos& frame);

    using RunOutput::take;
    void take(const motion::Segment& segment, const MoveInfo& info) override;
    void end(double end_s) override;

    /// After end().
    CellFindings release() { return std::move(findings_); }

  private:
    void end_block();

    cell::Cell cell_;
    cell::ClearanceWatch watch_;
    CellFindings findings_;
    std::optional<Place> block_;
    std::vector<Place> places_;  ///< Of the watch's contacts.
};

}  // namespace gsim::simulation
