#include "calibrate/times/predictor.h"

#include <algorithm>
#include <atomic>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <thread>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "engine/run.h"
#include "machine/file/machine_file.h"
#include "machine/file/times_section.h"
#include "runtime/motion_sources/motion_replay.h"
#include "runtime/simulator/make_planner_setup.h"

namespace gsim::calibrate {

namespace {

constexpr double kPlaceholderTime_s = 0.01;
constexpr const char* kMachineFile = "calibrated machine.toml";

std::optional<std::string> read_bytes(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(in), {});
}

engine::Files files_with_machine(const std::string& machine) {
    return engine::Files::given([machine](const std::string& name) -> std::optional<std::string> {
        return name == kMachineFile ? machine : read_bytes(name);
    });
}

std::string failure_text(const engine::Report& report) {
    if (report.alarm) return report.alarm->message;
    if (!report.violations.empty()) return report.violations.front().message;
    return "it did not run to its end";
}

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < count; i = next++) body(i);
    };
    std::vector<std::jthread> threads;
    for (unsigned i = 1; i < std::max(std::thread::hardware_concurrency(), 1U); ++i)
        threads.emplace_back(work);
    work();
}

Result<double> total_time_s(const Result<std::vector<simulation::ReplayedMove>>& moves) {
    if (!moves) return tl::unexpected(moves.error());
    const auto span = replay_span(*moves);
    if (!span) return Unexpected("no motion");
    return span->end_s - span->start_s;
}

/// Gives all words some time, so that their positions are known.
machine::Machine with_all_times(machine::Machine machine) {
    machine.times.before_first_move = true;
    for (const std::string& key : machine::named_time_keys()) {
        double& time_s = *machine::word_time(key, machine.times);
        if (time_s <= 0) time_s = kPlaceholderTime_s;
    }
    return machine;
}

/// Adds the keys of dwells between moves.
void add_words(const simulation::MotionLog& log, std::set<std::string>& keys) {
    bool has_moved = false;
    std::vector<std::string> pending_keys;
    for (const simulation::MotionRequest& motion_request : log.requests()) {
        const auto* dwell = std::get_if<simulation::DwellRequest>(&motion_request);
        if (dwell != nullptr && !dwell->time_key.empty()) {
            if (has_moved) pending_keys.push_back(dwell->time_key);
        } else if (!std::holds_alternative<simulation::StopRequest>(motion_request)) {
            has_moved = true;
            keys.insert(pending_keys.begin(), pending_keys.end());
            pending_keys.clear();
        }
    }
}

}  // namespace

Result<Predictor> Predictor::of(std::span<const RecordedRun> runs, const ReadingOptions& reading_options,
                                const machine::Machine& machine) {
    Predictor predictor;
    predictor.reading_options_ = reading_options;
    std::vector<std::shared_ptr<Program>> programs;
    for (const RecordedRun& run : runs) {
        if (!read_bytes(run.program)) return Unexpected(fmt::format("cannot read {}", run.program));
        programs.push_back(std::make_shared<Program>());
        programs.back()->file = run.program;
    }
    const std::string text = machine::print_machine(with_all_times(machine));
    parallel_for(programs.size(), [&](std::size_t i) {
        Program& program = *programs[i];
        predictor.run(program, text);
        const bool is_total = runs[i].samples.empty() || !program.log.incomplete_reason().empty();
        program.data = is_total ? std::vector<TimedInterval>{{.time_s = runs[i].time_s}}
                                : timed_intervals(runs[i], program.log, machine);
    });
    predictor.programs_.assign(programs.begin(), programs.end());
    return predictor;
}

void Predictor::run(Program& program, const std::string& machine) const {
    if (const auto time_s = run_time_s(program.file, machine, &program.log); !time_s)
        program.error_text = time_s.error().message;
}

std::vector<std::string> Predictor::words() const {
    std::set<std::string> keys;
    for (const auto& program : programs_) add_words(program->log, keys);
    return {keys.begin(), keys.end()};
}

Predictor Predictor::part(std::span<const std::size_t> indices) const {
    Predictor selected;
    selected.reading_options_ = reading_options_;
    for (const std::size_t index : indices) selected.programs_.push_back(programs_[index]);
    return selected;
}

Result<double> Predictor::run_time_s(const std::string& program, const std::string& machine,
                                     simulation::MotionLog* log) const {
    engine::Request request;
    request.program = program;
    request.machine = kMachineFile;
    request.language.dialect = reading_options_.dialect;
    request.machine_data = reading_options_.machine_data;
    request.collisions = false;
    request.host.files = files_with_machine(machine);
    auto run = engine::Run::open(std::move(request));
    if (!run) return tl::unexpected(run.error().message);
    if (const auto ready = run->prepare(); !ready) return tl::unexpected(ready.error().message);
    if (log != nullptr) run->observe_motion(*log);
    double first_s = std::numeric_limits<double>::infinity();
    run->on_moves([&](std::span<const engine::Move> moves) {
        for (const engine::Move& move : moves) first_s = std::min(first_s, move.start_s);
    });
    const auto report = run->go();
    if (!report) return tl::unexpected(report.error().message);
    if (report->status != engine::RunStatus::completed) return tl::unexpected(failure_text(*report));
    if (!(report->cycle_time_s > first_s)) return Unexpected("no motion");
    return report->cycle_time_s - first_s;
}

std::vector<Result<Predictor::Moves>> Predictor::moves(const machine::Machine& machine) const {
    motion::PlannerSetup setup = simulation::make_planner_setup(machine);
    setup.overtravel_log.reset();
    std::vector<Result<Moves>> moves(programs_.size());
    parallel_for(programs_.size(), [&](std::size_t i) {
        const Program& program = *programs_[i];
        if (!program.error_text.empty()) {
            moves[i] = Unexpected(program.error_text);
        } else if (program.log.incomplete_reason().empty()) {
            moves[i] = simulation::replay(program.log, setup, machine.times);
        } else {
            moves[i] =
                run_time_s(program.file, machine::print_machine(machine), nullptr).map([](double time_s) {
                    return Moves{{0, 0, time_s}};
                });
        }
    });
    return moves;
}

std::vector<Result<double>> Predictor::times_s(const machine::Machine& machine) const {
    std::vector<Result<double>> times;
    for (const auto& each : moves(machine)) times.push_back(total_time_s(each));
    return times;
}

std::vector<TimedInterval> Predictor::data() const {
    std::vector<TimedInterval> all;
    for (std::size_t i = 0; i < programs_.size(); ++i) {
        for (TimedInterval datum : programs_[i]->data) {
            datum.run = i;
            all.push_back(datum);
        }
    }
    return all;
}

Result<std::vector<double>> Predictor::times_s(std::span<const TimedInterval> data,
                                               const machine::Machine& machine) const {
    const auto all = moves(machine);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (const auto is_total = total_time_s(all[i]); !is_total)
            return Unexpected(fmt::format("{}: {}", programs_[i]->file, is_total.error().message));
    }
    std::vector<double> times;
    for (const TimedInterval& datum : data)
        times.push_back(interval_time_s(datum, programs_[datum.run]->log, *all[datum.run]));
    return times;
}

}  // namespace gsim::calibrate
