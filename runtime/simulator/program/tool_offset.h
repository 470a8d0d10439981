#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "motion/path/machine_frames.h"
#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/program/program_notifier.h"
#include "runtime/simulator/program/program_position.h"
#include "runtime/simulator/program/target_ids.h"
#include "runtime/simulator/tcp_frame.h"
#include "runtime/simulator/tcp_table.h"

namespace gsim::simulation {

/// Offset of the tool in use, and the TCPs of the tools that moves have used.
class ToolOffset {
  public:
    /// Begins without an offset; `frames` are the machine's as the program has set them. All arguments must
    /// outlive this.
    ToolOffset(MachineMotion& motion, const ProgramPosition& position, const motion::MachineFrames& frames,
               const TargetIds& ids, const ProgramNotifier& notifier)
        : motion_(motion), position_(position), frames_(frames), ids_(ids), notifier_(notifier) {}

    /// Sets the distance of the tool's end from the position of X, Y and Z of the machine, for zones and
    /// probes (mm).
    void set(const Eigen::Vector3d& offset_mm);
    const Eigen::Vector3d& offset_mm() const { return offset_mm_; }
    /// Updates the TCP of the tool in use as the machine carries it, even if the program does not set the
    /// TCP. To be called once the machine's frames have changed.
    void update_tcp();
    /// Returns the number of the TCP in use, for MoveInfo::tcp.
    std::uint16_t tcp() const { return tcp_; }
    /// Returns the TCPs of the tools of the moves so far, by their number, in the frame of the kinematics'
    /// tool centre point (mm).
    const std::vector<Eigen::Vector3d>& tcps_mm() const { return tcps_.offsets_mm(); }
    /// Returns the coordinates under TCP control with a tool of this length offset; the error is a message.
    tl::expected<TcpFrame, std::string> make_tcp_frame(const Eigen::Vector3d& offset_mm) const;

  private:
    MachineMotion& motion_;
    const ProgramPosition& position_;
    const motion::MachineFrames& frames_;
    const TargetIds& ids_;
    const ProgramNotifier& notifier_;
    Eigen::Vector3d offset_mm_ = Eigen::Vector3d::Zero();
    TcpTable tcps_;
    std::uint16_t tcp_ = 0;
};

}  // namespace gsim::simulation
