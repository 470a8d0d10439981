#include <algorithm>
#include <string>
#include <vector>

#include "engine/c/handles.h"

namespace gsim::engine {

static_assert(kMaxAxes == GSIM_MAX_AXES);

#define GSIM_MOVE_KIND(name, number, constant) static_assert((constant) == (number));
#include "base/kinds/move_kind.def"
#define GSIM_SEGMENT_KIND(name, number, constant) static_assert((constant) == (number));
#include "base/kinds/segment_kind.def"

namespace {

std::uint32_t file_number(gsim_run& run, std::string_view name) {
    auto known = run.files.find(name);
    if (known == run.files.end()) {
        known = run.files.emplace(std::string(name), static_cast<std::uint32_t>(run.files.size())).first;
        run.file_names.push_back(&known->first);
    }
    return known->second;
}

gsim_move plain(const Move& move, std::uint32_t file) {
    gsim_move result{};
    result.n = move.n;
    result.start_s = move.start_s;
    result.end_s = move.end_s;
    result.length_mm = move.length_mm;
    result.feed_per_min = move.feed_per_min;
    result.deviation_mm = move.deviation_mm;
    std::copy(move.end.begin(), move.end.end(), result.end);
    if (move.circular) {
        std::copy(move.arc.center_mm.begin(), move.arc.center_mm.end(), result.center_mm);
        std::copy(move.arc.axis.begin(), move.arc.axis.end(), result.axis);
        result.radius_mm = move.arc.radius_mm;
        result.sweep_rad = move.arc.sweep_rad;
    }
    result.kind = static_cast<std::int32_t>(move.kind);
    result.process_on = move.process_on ? 1 : 0;
    result.line = move.line;
    result.file = file;
    return result;
}

gsim_segment plain(const Segment& segment) {
    gsim_segment result{};
    result.start_s = segment.start_s;
    result.duration_s = segment.duration_s;
    result.length_mm = segment.length_mm;
    std::copy(segment.start.begin(), segment.start.end(), result.start);
    std::copy(segment.end.begin(), segment.end.end(), result.end);
    result.kind = static_cast<std::int32_t>(segment.kind);
    result.process_on = segment.process_on ? 1 : 0;
    result.line = segment.line;
    result.exact = &segment;
    return result;
}

gsim_sample plain(const Sample& sample) {
    gsim_sample result{};
    result.t_s = sample.t_s;
    result.speed_mm_s = sample.speed_mm_s;
    std::copy(sample.axes.begin(), sample.axes.end(), result.axes);
    result.line = sample.line;
    return result;
}

/// Returns "moves, trajectory and plot".
std::string listed(const std::vector<std::string>& names) {
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) list += i + 1 < names.size() ? ", " : " and ";
        list += names[i];
    }
    return list;
}

/// Calls `run_action` on a run that is about to start; returns the status.
template <typename RunAction>
std::int32_t call_on_ready_run(gsim_run* run, std::size_t robot, const RunAction& run_action) {
    return call_noexcept([&]() -> std::int32_t {
        const bool ready = run->run && run->status == GSIM_OK && !run->report;
        if (!ready || robot >= run->run->robots().size()) {
            if (run->error.empty())
                run->error = ready ? "the robot does not exist" : "the run has already ended";
            return GSIM_FAILED;
        }
        const tl::expected<void, Error> done = run_action(*run->run);
        return done ? GSIM_OK : store_error(*run, done.error());
    });
}

}  // namespace
}  // namespace gsim::engine

using namespace gsim::engine;

int32_t gsim_run_on_moves(gsim_run* run, size_t robot, gsim_on_moves callback, void* user) {
    return call_on_ready_run(run, robot, [&](Run& queried_run) -> tl::expected<void, Error> {
        queried_run.on_moves(
            [run, callback, user](std::span<const Move> moves) {
                std::vector<gsim_move> chunk;
                chunk.reserve(moves.size());
                for (const Move& move : moves) chunk.push_back(plain(move, file_number(*run, move.file)));
                callback(user, chunk.data(), chunk.size());
            },
            robot);
        return {};
    });
}

int32_t gsim_run_on_segments(gsim_run* run, size_t robot, gsim_on_segments callback, void* user) {
    return call_on_ready_run(run, robot, [&](Run& queried_run) -> tl::expected<void, Error> {
        queried_run.on_segments(
            [callback, user](std::span<const Segment> segments) {
                std::vector<gsim_segment> chunk;
                chunk.reserve(segments.size());
                for (const Segment& segment : segments) chunk.push_back(plain(segment));
                callback(user, chunk.data(), chunk.size());
            },
            robot);
        return {};
    });
}

int32_t gsim_run_on_samples(gsim_run* run, size_t robot, double step_s, gsim_on_samples callback,
                            void* user) {
    return call_on_ready_run(run, robot, [&](Run& queried_run) {
        return queried_run.on_samples(
            [callback, user](std::span<const Sample> samples) {
                std::vector<gsim_sample> chunk;
                chunk.reserve(samples.size());
                for (const Sample& sample : samples) chunk.push_back(plain(sample));
                callback(user, chunk.data(), chunk.size());
            },
            step_s, robot);
    });
}

int32_t gsim_run_write(gsim_run* run, size_t robot, const char* output_kind, double step_s,
                       gsim_write_text callback, void* user) {
    return call_on_ready_run(run, robot, [&](Run& queried_run) -> tl::expected<void, Error> {
        const auto known = find_output(output_kind);
        if (!known) {
            return tl::unexpected(
                Error{.code = "usage",
                      .message = std::string("'") + output_kind +
                                 "' is not an output; known outputs: " + listed(output_names())});
        }
        OutputOptions options;
        options.step_s = step_s;
        return queried_run.write(
            *known,
            [callback, user](std::string_view text) { return callback(user, text.data(), text.size()) != 0; },
            options, robot);
    });
}

void gsim_segment_axes(const gsim_segment* segment, double t_s, double axes[GSIM_MAX_AXES]) {
    const AxisValues values = static_cast<const Segment*>(segment->exact)->axes_at(t_s);
    std::copy(values.begin(), values.end(), axes);
}

double gsim_segment_speed_mm_s(const gsim_segment* segment, double t_s) {
    return static_cast<const Segment*>(segment->exact)->speed_mm_s(t_s);
}
