#include "runtime/motion_sources/motion_replay.h"

#include <set>
#include <utility>

#include <fmt/format.h>

#include "machine/file/times_section.h"

namespace gsim::simulation {

namespace {

/// Recorder of when moves begin and end.
class Times final : public motion::SegmentSink {
  public:
    explicit Times(const MotionLog& log) {
        for (const MotionAsk& ask : log.asks()) {
            if (const auto* rest = std::get_if<AskedRest>(&ask); rest != nullptr)
                (rest->time_key.empty() ? dwells_ : words_).insert(rest->target_id);
        }
    }

    void take(const motion::Segment& segment) override {
        const double end_s = segment.end_s();
        if (!(end_s > segment.start_s)) return;
        const bool rests = segment.kind == motion::SegmentKind::rest && dwells_.count(segment.target_id) == 0;
        if (!moves.empty() && moves.back().target_id == segment.target_id) {
            moves.back().end_s = end_s;
            moves.back().rests = moves.back().rests && rests;
        } else {
            const bool of_word = words_.count(segment.target_id) > 0;
            moves.push_back({segment.target_id, segment.start_s, end_s, rests, of_word});
        }
    }

    std::vector<ReplayedMove> moves;

  private:
    std::set<rrs::TargetId> dwells_, words_;  // requested by the program, and dwells for words
};

struct Asks {
    const machine::WordTimes& times;
    motion::Planner& planner;

    motion::Planned operator()(const motion::Move& move) const {
        if (const auto put = planner.put(move); !put) return tl::unexpected(put.error());
        return {};
    }
    motion::Planned operator()(const AskedRest& rest) const {
        if (rest.time_key.empty()) return planner.put_rest(rest.target_id, rest.rest_s);
        const double* time_s = machine::time_at(rest.time_key, times);
        if (time_s == nullptr || *time_s <= 0) return {};
        return planner.put_rest(rest.target_id, *time_s);
    }
    motion::Planned operator()(const AskedOwn& own) const { return planner.put_own(own.end); }
    motion::Planned operator()(const AskedStop& stop) const {
        planner.come_to_rest(stop.waits);
        return {};
    }
};

}  // namespace

motion::Planned ask_again(const MotionAsk& ask, const machine::WordTimes& times, motion::Planner& planner) {
    return std::visit(Asks{times, planner}, ask);
}

tl::expected<std::vector<ReplayedMove>, std::string> replay(const MotionLog& log,
                                                            const motion::PlannerSetup& machine,
                                                            const machine::WordTimes& times_of_words) {
    Times times(log);
    motion::Planner planner(machine, &times);
    if (const auto stands = planner.stand_at({log.start(), std::nullopt}); !stands)
        return tl::unexpected(stands.error().message);
    for (std::size_t i = 0; i < log.asks().size(); ++i) {
        if (const auto put = ask_again(log.asks()[i], times_of_words, planner); !put)
            return tl::unexpected(fmt::format("move {}: {}", i + 1, put.error().message));
    }
    planner.come_to_last_rest();
    planner.flush();
    return std::move(times.moves);
}

}  // namespace gsim::simulation
