#include "engine/src/run/chunk_outputs.h"

#include <utility>

#include "engine/src/conversions.h"
#include "runtime/outputs/sampler.h"

namespace gsim::engine {

namespace {

using simulation::MoveInfo;
using simulation::RecordedMove;

constexpr std::size_t kChunkSize = 1024;

Arc to_arc(const RecordedMove& move) {
    Arc arc;
    const Eigen::Vector3d axis = move.arc->u.cross(move.arc->v);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        arc.center_mm[i] = move.arc->center[at];
        arc.axis[i] = axis[at];
    }
    arc.radius_mm = move.arc->radius_mm;
    arc.sweep_rad = move.arc->sweep_rad;
    return arc;
}

class MovesOutput final : public simulation::RunOutput {
  public:
    MovesOutput(MovesHandler on_segment, const machine::Machine& machine,
                const std::vector<std::string>& files)
        : handler_(std::move(on_segment)), machine_(machine), files_(files) {
        chunk_.reserve(kChunkSize);
    }

    void on_move(const RecordedMove& move) override {
        const MoveInfo& info = move.info;
        const bool has_feed =
            info.kind != simulation::MoveKind::rapid && info.kind != simulation::MoveKind::dwell;
        Move& public_move = chunk_.emplace_back();
        public_move.n = move.n;
        public_move.kind = static_cast<MoveKind>(info.kind);
        public_move.process_on = info.process_on;
        public_move.circular = move.arc.has_value();
        public_move.line = info.location.line;
        public_move.start_s = move.start_s;
        public_move.end_s = move.end_s;
        public_move.length_mm = move.length_mm;
        public_move.feed_per_min = has_feed && !info.timed ? info.feed_per_min : 0;
        public_move.deviation_mm = move.deviation_mm;
        public_move.end = axis_values(machine_, move.end);
        if (move.arc) public_move.arc = to_arc(move);
        file_index_.push_back(info.location.file);
        if (chunk_.size() == kChunkSize) deliver();
    }
    void end(double) override { deliver(); }

  private:
    void deliver() {
        // The names may have moved in memory while the chunk grew.
        for (std::size_t i = 0; i < chunk_.size(); ++i) {
            if (file_index_[i] < files_.size()) chunk_[i].file = files_[file_index_[i]];
        }
        if (!chunk_.empty()) handler_(chunk_);
        chunk_.clear();
        file_index_.clear();
    }

    MovesHandler handler_;
    const machine::Machine& machine_;
    const std::vector<std::string>& files_;
    std::vector<Move> chunk_;
    std::vector<std::uint32_t> file_index_;
};

class SegmentsOutput final : public simulation::RunOutput {
  public:
    SegmentsOutput(SegmentsHandler on_segment, const machine::Machine& machine)
        : handler_(std::move(on_segment)), machine_(machine) {
        exact_.reserve(kChunkSize);
        chunk_.reserve(kChunkSize);
    }

    void on_segment(const motion::Segment& segment, const MoveInfo& info) override {
        exact_.push_back(segment);  // within the reserved size: the others keep their address
        chunk_.emplace_back(exact_.back(), machine_, info.location.line, info.process_on);
        if (chunk_.size() == kChunkSize) deliver();
    }
    void end(double) override { deliver(); }

  private:
    void deliver() {
        if (!chunk_.empty()) handler_(chunk_);
        chunk_.clear();
        exact_.clear();
    }

    SegmentsHandler handler_;
    const machine::Machine& machine_;
    std::vector<motion::Segment> exact_;
    std::vector<Segment> chunk_;
};

class SamplesOutput final : public simulation::Sampler {
  public:
    SamplesOutput(SamplesHandler on_segment, const machine::Machine& machine, double step_s,
                  double max_time_s)
        : Sampler(step_s, max_time_s), handler_(std::move(on_segment)), machine_(machine) {
        chunk_.reserve(kChunkSize);
    }

    void end(double end_s) override {
        Sampler::end(end_s);
        deliver();
    }

  private:
    bool sample(double t_s, const rrs::JointPos& joints, double speed_mm_s, std::uint32_t line) override {
        chunk_.push_back({t_s, speed_mm_s, line, axis_values(machine_, joints)});
        if (chunk_.size() == kChunkSize) deliver();
        return true;
    }
    void deliver() {
        if (!chunk_.empty()) handler_(chunk_);
        chunk_.clear();
    }

    SamplesHandler handler_;
    const machine::Machine& machine_;
    std::vector<Sample> chunk_;
};

}  // namespace

std::unique_ptr<simulation::RunOutput> make_moves_output(MovesHandler on_segment,
                                                         const machine::Machine& machine,
                                                         const std::vector<std::string>& files) {
    return std::make_unique<MovesOutput>(std::move(on_segment), machine, files);
}

std::unique_ptr<simulation::RunOutput> make_segments_output(SegmentsHandler on_segment,
                                                            const machine::Machine& machine) {
    return std::make_unique<SegmentsOutput>(std::move(on_segment), machine);
}

std::unique_ptr<simulation::RunOutput> make_samples_output(SamplesHandler on_segment,
                                                           const machine::Machine& machine, double step_s,
                                                           double max_time_s) {
    return std::make_unique<SamplesOutput>(std::move(on_segment), machine, step_s, max_time_s);
}

}  // namespace gsim::engine
