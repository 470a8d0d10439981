#include "tests/calibrate/black_box/black_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <utility>

#include <fmt/format.h>

namespace gsim::calibrate {

namespace {

constexpr double kGuess_mm_s2 = 300;
constexpr double kGuess_deg_s2 = 300;
constexpr std::size_t kParts = 3;
constexpr std::size_t kLeastForetold = 5;

/// The same order with every library: std::shuffle may differ.
std::vector<std::size_t> shuffled(std::size_t count, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<std::size_t> places(count);
    for (std::size_t i = 0; i < count; ++i) places[i] = i;
    for (std::size_t i = count; i > 1; --i) std::swap(places[i - 1], places[random() % i]);
    return places;
}

/// The runs of a box that the generic control brings to an end.
struct Usable {
    std::vector<RecordedRun> runs;
    Predictor predictor;
};

Result<Usable> usable_runs(const BlackBox& box, const machine::Machine& machine, const std::string& data,
                           std::vector<std::string>& left_out) {
    std::vector<RecordedRun> runs;
    for (const accuracy::Recording& recording : box.recordings)
        runs.push_back({recording.program.string(), recording.cycle_time_s});
    const ReadingOptions reading_options{box.recordings.front().dialect, data};
    auto predictor = Predictor::of(runs, reading_options, machine);
    if (!predictor) return tl::unexpected(predictor.error());
    const auto times = predictor->times_s(machine);
    std::vector<std::size_t> places;
    std::vector<RecordedRun> good;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (times[i]) {
            places.push_back(i);
            good.push_back(runs[i]);
        } else {
            left_out.push_back(fmt::format("{}: {}", box.recordings[i].name, times[i].error().message));
        }
    }
    return Usable{std::move(good), predictor->part(places)};
}

Result<void> predict(const Usable& usable, std::span<const std::size_t> places,
                     const machine::Machine& machine, BoxOutcome& outcome) {
    const auto runs = select_runs(usable.runs, places);
    const auto times = usable.predictor.part(places).times_s(machine);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (!times[i]) return Unexpected(fmt::format("{}: {}", runs[i].program, times[i].error().message));
        outcome.foretold.push_back({runs[i], *times[i]});
    }
    return {};
}

}  // namespace

double BoxOutcome::mean_percent() const {
    double sum = 0;
    for (const Foretold& run : foretold) sum += std::abs(run.error_percent());
    return foretold.empty() ? 0 : sum / static_cast<double>(foretold.size());
}

double BoxOutcome::largest_percent() const {
    double largest = 0;
    for (const Foretold& run : foretold) largest = std::max(largest, std::abs(run.error_percent()));
    return largest;
}

std::size_t BoxOutcome::within(double percent) const {
    return static_cast<std::size_t>(std::count_if(foretold.begin(), foretold.end(), [&](const Foretold& run) {
        return std::abs(run.error_percent()) <= percent;
    }));
}

std::vector<BlackBox> black_boxes(const std::vector<accuracy::Recording>& recordings) {
    std::map<std::string, std::vector<accuracy::Recording>> boxes;
    for (const accuracy::Recording& recording : recordings) {
        if (recording.counted && recording.overrides.empty())
            boxes[recording.machine_file].push_back(recording);
    }
    std::vector<BlackBox> found;
    for (auto& [file, of] : boxes) found.push_back({file.substr(0, file.rfind('.')), std::move(of)});
    return found;
}

machine::Machine without_inside(machine::Machine machine) {
    constexpr double kUnlimited = std::numeric_limits<double>::infinity();
    rrs::ControllerRules generic;
    // These are known from its manual: whether it has arcs and boring cycles, and how it drills.
    generic.klipper.arc_resolution_mm = machine.controller.klipper.arc_resolution_mm;
    generic.drilling.boring_cycles = machine.controller.drilling.boring_cycles;
    generic.drilling.pecks_feed_down = machine.controller.drilling.pecks_feed_down;
    generic.drilling.peck_clearance_mm = machine.controller.drilling.peck_clearance_mm;
    generic.drilling.peck_dwell_s = machine.controller.drilling.peck_dwell_s;
    machine.controller = generic;
    machine.times = {};
    machine.path.max_acceleration_mm_s2 = kUnlimited;
    machine.path.max_jerk_mm_s3 = kUnlimited;
    for (machine::Axis& axis : machine.axes) {
        axis.max_acceleration = axis.kind == machine::AxisKind::rotary ? kGuess_deg_s2 : kGuess_mm_s2;
        axis.max_deceleration.reset();
        axis.max_jerk = axis.max_speed_step = kUnlimited;
    }
    return machine;
}

std::vector<Candidate> candidates_for(const std::string& box, const machine::Machine& machine) {
    auto candidates = generic_candidates(machine, {});
    if (box.starts_with("grbl") || box.starts_with("klipper")) {
        std::erase_if(candidates, [](const Candidate& candidate) {
            return candidate.name.starts_with("junction-deviation");
        });
    }
    return candidates;
}

Result<BoxOutcome> try_box(const BlackBox& box, const machine::Machine& machine, std::size_t fitted,
                           std::size_t most_moves, std::uint32_t seed, const std::string& data,
                           const std::function<void(const std::string&)>& on_progress) {
    BoxOutcome outcome;
    const auto usable = usable_runs(box, machine, data, outcome.left_out);
    if (!usable) return tl::unexpected(usable.error());
    if (usable->runs.size() < fitted + kLeastForetold)
        return Unexpected(fmt::format("{} runs are too few", usable->runs.size()));
    auto order = shuffled(usable->runs.size(), seed);
    std::stable_partition(order.begin(), order.end(), [&](std::size_t place) {
        return usable->predictor.request_count(place) <= most_moves;
    });
    const std::span<const std::size_t> known = std::span(order).first(fitted);
    const auto runs = select_runs(usable->runs, known);
    const Predictor predictor = usable->predictor.part(known);
    auto choice = select_model(candidates_for(box.name, machine), runs, predictor, kParts, on_progress);
    if (!choice) return tl::unexpected(choice.error());
    outcome.choice = *std::move(choice);
    const Candidate& best = outcome.choice.candidate;
    const auto fit = fit_times(best.machine, runs, predictor, {.open = best.open, .multi_start = true});
    if (!fit) return tl::unexpected(fit.error());
    outcome.parameters = fit->parameters;
    if (const auto done = predict(*usable, std::span(order).subspan(fitted), fit->machine, outcome); !done)
        return tl::unexpected(done.error());
    return outcome;
}

}  // namespace gsim::calibrate
