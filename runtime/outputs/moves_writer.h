#pragma once

#include <string>
#include <vector>

#include "machine/model/machine.h"
#include "runtime/outputs/run_output.h"
#include "runtime/outputs/text_stream.h"

namespace gsim::simulation {

/// Writer of each move as one line of JSON (docs/report.md). Values are those of the machine's axes.
class MovesWriter : public RunOutput {
  public:
    /// `files` are the names that SourceLocation::file indexes; they may grow while the writer is in use. All
    /// must outlive this.
    MovesWriter(TextStream& out, const machine::Machine& machine, const std::vector<std::string>& files);

    void on_move(const RecordedMove& move) override;

  private:
    void append_target(const rrs::JointPos& joints);
    void append_arc(const RecordedMove& move);
    void append_center(const RecordedMove& move);
    void append_normal(const Eigen::Vector3d& normal);
    void append_limit(const RecordedMove& move);
    void append_axes_out_of_range(std::uint16_t joints);
    const std::string& file_text(std::size_t file);

    TextStream& out_;
    const machine::Machine& machine_;
    const std::vector<std::string>& files_;
    std::vector<std::string> file_texts_;  // the names as JSON, for as many as were needed
};

}  // namespace gsim::simulation
