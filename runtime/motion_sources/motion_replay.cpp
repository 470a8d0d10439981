#include "runtime/motion_sources/motion_replay.h"

#include <set>
#include <utility>

#include <fmt/format.h>

#include "machine/file/times_section.h"

namespace gsim::simulation {

namespace {

/// Recorder of when moves begin and end.
class SegmentTimes final : public motion::SegmentSink {
  public:
    explicit SegmentTimes(const MotionLog& log) {
        for (const MotionRequest& request : log.requests()) {
            if (const auto* standstill = std::get_if<DwellRequest>(&request); standstill != nullptr)
                (standstill->time_key.empty() ? dwells_ : words_).insert(standstill->target_id);
        }
    }

    void on_segment(const motion::Segment& segment) override {
        const double end_s = segment.end_s();
        if (!(end_s > segment.start_s)) return;
        const bool is_standstill =
            segment.kind == motion::SegmentKind::rest && dwells_.count(segment.target_id) == 0;
        if (!moves.empty() && moves.back().target_id == segment.target_id) {
            moves.back().end_s = end_s;
            moves.back().is_standstill = moves.back().is_standstill && is_standstill;
        } else {
            const bool is_for_word = words_.count(segment.target_id) > 0;
            moves.push_back({segment.target_id, segment.start_s, end_s, is_standstill, is_for_word});
        }
    }

    std::vector<ReplayedMove> moves;

  private:
    std::set<rrs::TargetId> dwells_, words_;  // requested by the program, and dwells for words
};

struct RequestExecutor {
    const machine::WordTimes& times;
    motion::Planner& planner;

    motion::PlanResult operator()(const motion::Move& move) const {
        if (const auto enqueue = planner.enqueue(move); !enqueue) return tl::unexpected(enqueue.error());
        return {};
    }
    motion::PlanResult operator()(const DwellRequest& standstill) const {
        if (standstill.time_key.empty())
            return planner.dwells().enqueue(standstill.target_id, standstill.dwell_s);
        const double* time_s = machine::word_time(standstill.time_key, times);
        if (time_s == nullptr || *time_s <= 0) return {};
        return planner.dwells().enqueue(standstill.target_id, *time_s);
    }
    motion::PlanResult operator()(const IndependentMoveRequest& joint_request) const {
        return planner.independent_moves().enqueue(joint_request.end);
    }
    motion::PlanResult operator()(const StopRequest& stop) const {
        planner.dwells().plan_to_standstill(stop.waits);
        return {};
    }
};

}  // namespace

motion::PlanResult replay_request(const MotionRequest& request, const machine::WordTimes& times,
                                  motion::Planner& planner) {
    return std::visit(RequestExecutor{times, planner}, request);
}

Result<std::vector<ReplayedMove>> replay(const MotionLog& log, const motion::PlannerSetup& machine,
                                         const machine::WordTimes& word_times) {
    SegmentTimes times(log);
    motion::Planner planner(machine, &times);
    if (const auto started = planner.set_position({log.start(), std::nullopt}); !started)
        return tl::unexpected(started.error().message);
    for (std::size_t i = 0; i < log.requests().size(); ++i) {
        if (const auto enqueue = replay_request(log.requests()[i], word_times, planner); !enqueue)
            return Unexpected(fmt::format("move {}: {}", i + 1, enqueue.error().message));
    }
    planner.dwells().plan_to_final_standstill();
    planner.flush();
    return std::move(times.moves);
}

}  // namespace gsim::simulation
