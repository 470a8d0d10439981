#include "runtime/simulation/motion_replay.h"

#include <fmt/format.h>

namespace gsim::simulation {

namespace {

/// Keeps when moves begin and end.
class Times final : public motion::SegmentSink {
  public:
    void take(const motion::Segment& segment) override {
        const double end_s = segment.end_s();
        if (!(end_s > segment.start_s)) return;
        if (!moves.empty() && moves.back().target_id == segment.target_id) {
            moves.back().end_s = end_s;
        } else {
            moves.push_back({segment.target_id, segment.start_s, end_s});
        }
    }

    std::vector<ReplayedMove> moves;
};

struct Asks {
    motion::Planner& planner;

    motion::Planned operator()(const motion::Move& move) const {
        if (const auto put = planner.put(move); !put) return tl::unexpected(put.error());
        return {};
    }
    motion::Planned operator()(const AskedRest& rest) const {
        return planner.put_rest(rest.target_id, rest.rest_s);
    }
    motion::Planned operator()(const AskedOwn& own) const { return planner.put_own(own.end); }
    motion::Planned operator()(const AskedStop& stop) const {
        planner.come_to_rest(stop.waits);
        return {};
    }
};

}  // namespace

motion::Planned ask_again(const MotionAsk& ask, motion::Planner& planner) {
    return std::visit(Asks{planner}, ask);
}

tl::expected<std::vector<ReplayedMove>, std::string> replay(const MotionLog& log,
                                                            const motion::PlannerSetup& machine) {
    Times times;
    motion::Planner planner(machine, &times);
    if (const auto stands = planner.stand_at({log.start(), std::nullopt}); !stands)
        return tl::unexpected(stands.error().message);
    for (std::size_t i = 0; i < log.asks().size(); ++i) {
        if (const auto put = ask_again(log.asks()[i], planner); !put)
            return tl::unexpected(fmt::format("move {}: {}", i + 1, put.error().message));
    }
    planner.come_to_last_rest();
    planner.flush();
    return std::move(times.moves);
}

}  // namespace gsim::simulation
