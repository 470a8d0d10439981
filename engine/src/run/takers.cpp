#include "engine/src/run/takers.h"

#include <utility>

#include "engine/src/values.h"
#include "runtime/outputs/sampler.h"

namespace gsim::engine {

namespace {

using simulation::MoveInfo;
using simulation::RecordedMove;

constexpr std::size_t kChunk = 1024;

Arc arc_of(const RecordedMove& move) {
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

class MovesOut final : public simulation::RunOutput {
  public:
    MovesOut(TakeMoves take, const machine::Machine& machine, const std::vector<std::string>& files)
        : take_(std::move(take)), machine_(machine), files_(files) {
        chunk_.reserve(kChunk);
    }

    using RunOutput::take;
    void take(const RecordedMove& move) override {
        const MoveInfo& info = move.info;
        const bool has_feed =
            info.kind != simulation::MoveKind::rapid && info.kind != simulation::MoveKind::dwell;
        Move& made = chunk_.emplace_back();
        made.n = move.n;
        made.kind = static_cast<MoveKind>(info.kind);
        made.jet_on = info.jet_on;
        made.circular = move.arc.has_value();
        made.line = info.place.line;
        made.start_s = move.start_s;
        made.end_s = move.end_s;
        made.length_mm = move.length_mm;
        made.feed_per_min = has_feed && !info.timed ? info.feed_per_min : 0;
        made.deviation_mm = move.deviation_mm;
        made.end = axis_values(machine_, move.end);
        if (move.arc) made.arc = arc_of(move);
        file_of_.push_back(info.place.file);
        if (chunk_.size() == kChunk) hand_out();
    }
    void end(double) override { hand_out(); }

  private:
    void hand_out() {
        // The names may have moved in memory while the chunk grew.
        for (std::size_t i = 0; i < chunk_.size(); ++i) {
            if (file_of_[i] < files_.size()) chunk_[i].file = files_[file_of_[i]];
        }
        if (!chunk_.empty()) take_(chunk_);
        chunk_.clear();
        file_of_.clear();
    }

    TakeMoves take_;
    const machine::Machine& machine_;
    const std::vector<std::string>& files_;
    std::vector<Move> chunk_;
    std::vector<std::uint32_t> file_of_;
};

class SegmentsOut final : public simulation::RunOutput {
  public:
    SegmentsOut(TakeSegments take, const machine::Machine& machine)
        : take_(std::move(take)), machine_(machine) {
        exact_.reserve(kChunk);
        chunk_.reserve(kChunk);
    }

    using RunOutput::take;
    void take(const motion::Segment& segment, const MoveInfo& info) override {
        exact_.push_back(segment);  // within the reserved size: the others keep their address
        chunk_.emplace_back(exact_.back(), machine_, info.place.line, info.jet_on);
        if (chunk_.size() == kChunk) hand_out();
    }
    void end(double) override { hand_out(); }

  private:
    void hand_out() {
        if (!chunk_.empty()) take_(chunk_);
        chunk_.clear();
        exact_.clear();
    }

    TakeSegments take_;
    const machine::Machine& machine_;
    std::vector<motion::Segment> exact_;
    std::vector<Segment> chunk_;
};

class SamplesOut final : public simulation::Sampler {
  public:
    SamplesOut(TakeSamples take, const machine::Machine& machine, double step_s, double max_time_s)
        : Sampler(step_s, max_time_s), take_(std::move(take)), machine_(machine) {
        chunk_.reserve(kChunk);
    }

    void end(double end_s) override {
        Sampler::end(end_s);
        hand_out();
    }

  private:
    bool sample(double t_s, const rrs::JointPos& joints, double speed_mm_s, std::uint32_t line) override {
        chunk_.push_back({t_s, speed_mm_s, line, axis_values(machine_, joints)});
        if (chunk_.size() == kChunk) hand_out();
        return true;
    }
    void hand_out() {
        if (!chunk_.empty()) take_(chunk_);
        chunk_.clear();
    }

    TakeSamples take_;
    const machine::Machine& machine_;
    std::vector<Sample> chunk_;
};

}  // namespace

std::unique_ptr<simulation::RunOutput> hand_out_moves(TakeMoves take, const machine::Machine& machine,
                                                      const std::vector<std::string>& files) {
    return std::make_unique<MovesOut>(std::move(take), machine, files);
}

std::unique_ptr<simulation::RunOutput> hand_out_segments(TakeSegments take, const machine::Machine& machine) {
    return std::make_unique<SegmentsOut>(std::move(take), machine);
}

std::unique_ptr<simulation::RunOutput> hand_out_samples(TakeSamples take, const machine::Machine& machine,
                                                        double step_s, double max_time_s) {
    return std::make_unique<SamplesOut>(std::move(take), machine, step_s, max_time_s);
}

}  // namespace gsim::engine
