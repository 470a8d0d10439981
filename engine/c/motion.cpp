#include <algorithm>
#include <string>
#include <vector>

#include "engine/c/handles.h"

namespace gsim::engine {

static_assert(kMostAxes == GSIM_MOST_AXES);

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
    gsim_move made{};
    made.n = move.n;
    made.start_s = move.start_s;
    made.end_s = move.end_s;
    made.length_mm = move.length_mm;
    made.feed_per_min = move.feed_per_min;
    made.deviation_mm = move.deviation_mm;
    std::copy(move.end.begin(), move.end.end(), made.end);
    if (move.circular) {
        std::copy(move.arc.center_mm.begin(), move.arc.center_mm.end(), made.center_mm);
        std::copy(move.arc.axis.begin(), move.arc.axis.end(), made.axis);
        made.radius_mm = move.arc.radius_mm;
        made.sweep_rad = move.arc.sweep_rad;
    }
    made.kind = static_cast<std::int32_t>(move.kind);
    made.jet_on = move.jet_on ? 1 : 0;
    made.line = move.line;
    made.file = file;
    return made;
}

gsim_segment plain(const Segment& segment) {
    gsim_segment made{};
    made.start_s = segment.start_s;
    made.duration_s = segment.duration_s;
    made.length_mm = segment.length_mm;
    std::copy(segment.start.begin(), segment.start.end(), made.start);
    std::copy(segment.end.begin(), segment.end.end(), made.end);
    made.kind = static_cast<std::int32_t>(segment.kind);
    made.jet_on = segment.jet_on ? 1 : 0;
    made.line = segment.line;
    made.exact = &segment;
    return made;
}

gsim_sample plain(const Sample& sample) {
    gsim_sample made{};
    made.t_s = sample.t_s;
    made.speed_mm_s = sample.speed_mm_s;
    std::copy(sample.axes.begin(), sample.axes.end(), made.axes);
    made.line = sample.line;
    return made;
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

/// Calls `ask` on a run that is about to start; returns the status.
template <typename Ask>
std::int32_t ask_of(gsim_run* run, std::size_t robot, const Ask& ask) {
    return without_throwing([&]() -> std::int32_t {
        const bool ready = run->run && run->status == GSIM_OK && !run->report;
        if (!ready || robot >= run->run->robots().size()) {
            if (run->error.empty()) run->error = ready ? "there is no such robot" : "the run has gone";
            return GSIM_FAILED;
        }
        const tl::expected<void, Failure> done = ask(*run->run);
        return done ? GSIM_OK : keep_failure(*run, done.error());
    });
}

}  // namespace
}  // namespace gsim::engine

using namespace gsim::engine;

int32_t gsim_run_take_moves(gsim_run* run, size_t robot, gsim_take_moves take, void* user) {
    return ask_of(run, robot, [&](Run& asked) -> tl::expected<void, Failure> {
        asked.take_moves(
            [run, take, user](std::span<const Move> moves) {
                std::vector<gsim_move> chunk;
                chunk.reserve(moves.size());
                for (const Move& move : moves) chunk.push_back(plain(move, file_number(*run, move.file)));
                take(user, chunk.data(), chunk.size());
            },
            robot);
        return {};
    });
}

int32_t gsim_run_take_segments(gsim_run* run, size_t robot, gsim_take_segments take, void* user) {
    return ask_of(run, robot, [&](Run& asked) -> tl::expected<void, Failure> {
        asked.take_segments(
            [take, user](std::span<const Segment> segments) {
                std::vector<gsim_segment> chunk;
                chunk.reserve(segments.size());
                for (const Segment& segment : segments) chunk.push_back(plain(segment));
                take(user, chunk.data(), chunk.size());
            },
            robot);
        return {};
    });
}

int32_t gsim_run_take_samples(gsim_run* run, size_t robot, double step_s, gsim_take_samples take,
                              void* user) {
    return ask_of(run, robot, [&](Run& asked) {
        return asked.take_samples(
            [take, user](std::span<const Sample> samples) {
                std::vector<gsim_sample> chunk;
                chunk.reserve(samples.size());
                for (const Sample& sample : samples) chunk.push_back(plain(sample));
                take(user, chunk.data(), chunk.size());
            },
            step_s, robot);
    });
}

int32_t gsim_run_write(gsim_run* run, size_t robot, const char* document, double step_s, gsim_take_text take,
                       void* user) {
    return ask_of(run, robot, [&](Run& asked) -> tl::expected<void, Failure> {
        const auto known = document_named(document);
        if (!known) {
            return tl::unexpected(Failure{
                .code = "usage",
                .message =
                    std::string("'") + document + "' is no document; there are " + listed(document_names())});
        }
        DocumentOptions options;
        options.step_s = step_s;
        return asked.write(
            *known, [take, user](std::string_view text) { return take(user, text.data(), text.size()) != 0; },
            options, robot);
    });
}

void gsim_segment_axes(const gsim_segment* segment, double t_s, double axes[GSIM_MOST_AXES]) {
    const AxisValues values = static_cast<const Segment*>(segment->exact)->axes_at(t_s);
    std::copy(values.begin(), values.end(), axes);
}

double gsim_segment_speed_mm_s(const gsim_segment* segment, double t_s) {
    return static_cast<const Segment*>(segment->exact)->speed_mm_s(t_s);
}
