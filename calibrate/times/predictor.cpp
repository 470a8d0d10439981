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
#include "runtime/simulator/setup_of_machine.h"

namespace gsim::calibrate {

namespace {

constexpr double kAnyTime_s = 0.01;
constexpr const char* kMachine = "calibrated machine.toml";

std::optional<std::string> bytes_of(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(in), {});
}

engine::Files files_with(const std::string& machine) {
    return engine::Files::given([machine](const std::string& name) -> std::optional<std::string> {
        return name == kMachine ? machine : bytes_of(name);
    });
}

std::string why(const engine::Report& report) {
    if (report.alarm) return report.alarm->message;
    if (!report.violations.empty()) return report.violations.front().message;
    return "it did not come to its end";
}

void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& make) {
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < count; i = next++) make(i);
    };
    std::vector<std::jthread> threads;
    for (unsigned i = 1; i < std::max(std::thread::hardware_concurrency(), 1U); ++i)
        threads.emplace_back(work);
    work();
}

tl::expected<double, std::string> whole_s(
    const tl::expected<std::vector<simulation::ReplayedMove>, std::string>& moves) {
    if (!moves) return tl::unexpected(moves.error());
    const auto span = span_of(*moves);
    if (!span) return tl::unexpected<std::string>("nothing moves");
    return span->end_s - span->start_s;
}

/// Gives all words some time, so that their positions are known.
machine::Machine with_all_times(machine::Machine machine) {
    machine.times.before_first_move = true;
    for (const std::string& key : machine::named_time_keys()) {
        double& time_s = *machine::time_at(key, machine.times);
        if (time_s <= 0) time_s = kAnyTime_s;
    }
    return machine;
}

/// Adds the keys of dwells between moves.
void add_words(const simulation::MotionLog& log, std::set<std::string>& keys) {
    bool has_moved = false;
    std::vector<std::string> since;
    for (const simulation::MotionAsk& ask : log.asks()) {
        const auto* rest = std::get_if<simulation::AskedRest>(&ask);
        if (rest != nullptr && !rest->time_key.empty()) {
            if (has_moved) since.push_back(rest->time_key);
        } else if (!std::holds_alternative<simulation::AskedStop>(ask)) {
            has_moved = true;
            keys.insert(since.begin(), since.end());
            since.clear();
        }
    }
}

}  // namespace

tl::expected<Predictor, std::string> Predictor::of(std::span<const RecordedRun> runs, const Reading& reading,
                                                   const machine::Machine& machine) {
    Predictor predictor;
    predictor.reading_ = reading;
    std::vector<std::shared_ptr<Program>> programs;
    for (const RecordedRun& run : runs) {
        if (!bytes_of(run.program)) return tl::unexpected(fmt::format("cannot read {}", run.program));
        programs.push_back(std::make_shared<Program>());
        programs.back()->file = run.program;
    }
    const std::string text = machine::print_machine(with_all_times(machine));
    on_all_cores(programs.size(), [&](std::size_t i) {
        Program& program = *programs[i];
        predictor.run(program, text);
        const bool whole = runs[i].samples.empty() || !program.log.gap().empty();
        program.data =
            whole ? std::vector<Datum>{{.time_s = runs[i].time_s}} : data_of(runs[i], program.log, machine);
    });
    predictor.programs_.assign(programs.begin(), programs.end());
    return predictor;
}

void Predictor::run(Program& program, const std::string& machine) const {
    if (const auto time_s = run_time_s(program.file, machine, &program.log); !time_s)
        program.refused = time_s.error();
}

std::vector<std::string> Predictor::words() const {
    std::set<std::string> keys;
    for (const auto& program : programs_) add_words(program->log, keys);
    return {keys.begin(), keys.end()};
}

Predictor Predictor::part(std::span<const std::size_t> places) const {
    Predictor chosen;
    chosen.reading_ = reading_;
    for (const std::size_t place : places) chosen.programs_.push_back(programs_[place]);
    return chosen;
}

tl::expected<double, std::string> Predictor::run_time_s(const std::string& program,
                                                        const std::string& machine,
                                                        simulation::MotionLog* log) const {
    engine::Request request;
    request.program = program;
    request.machine = kMachine;
    request.language.dialect = reading_.dialect;
    request.machine_data = reading_.machine_data;
    request.collisions = false;
    request.host.files = files_with(machine);
    auto run = engine::Run::open(std::move(request));
    if (!run) return tl::unexpected(run.error().message);
    if (const auto ready = run->prepare(); !ready) return tl::unexpected(ready.error().message);
    if (log != nullptr) run->observe_motion(*log);
    double first_s = std::numeric_limits<double>::infinity();
    run->take_moves([&](std::span<const engine::Move> moves) {
        for (const engine::Move& move : moves) first_s = std::min(first_s, move.start_s);
    });
    const auto report = run->go();
    if (!report) return tl::unexpected(report.error().message);
    if (report->status != engine::RunStatus::completed) return tl::unexpected(why(*report));
    if (!(report->cycle_time_s > first_s)) return tl::unexpected<std::string>("nothing moves");
    return report->cycle_time_s - first_s;
}

std::vector<tl::expected<Predictor::Moves, std::string>> Predictor::moves(
    const machine::Machine& machine) const {
    motion::PlannerSetup setup = simulation::setup_of_machine(machine);
    setup.range_notes.reset();
    std::vector<tl::expected<Moves, std::string>> moves(programs_.size());
    on_all_cores(programs_.size(), [&](std::size_t i) {
        const Program& program = *programs_[i];
        if (!program.refused.empty()) {
            moves[i] = tl::unexpected(program.refused);
        } else if (program.log.gap().empty()) {
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

std::vector<tl::expected<double, std::string>> Predictor::times_s(const machine::Machine& machine) const {
    std::vector<tl::expected<double, std::string>> times;
    for (const auto& each : moves(machine)) times.push_back(whole_s(each));
    return times;
}

std::vector<Datum> Predictor::data() const {
    std::vector<Datum> all;
    for (std::size_t i = 0; i < programs_.size(); ++i) {
        for (Datum datum : programs_[i]->data) {
            datum.run = i;
            all.push_back(datum);
        }
    }
    return all;
}

tl::expected<std::vector<double>, std::string> Predictor::times_s(std::span<const Datum> data,
                                                                  const machine::Machine& machine) const {
    const auto all = moves(machine);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (const auto whole = whole_s(all[i]); !whole)
            return tl::unexpected(fmt::format("{}: {}", programs_[i]->file, whole.error()));
    }
    std::vector<double> times;
    for (const Datum& datum : data)
        times.push_back(time_of(datum, programs_[datum.run]->log, *all[datum.run]));
    return times;
}

}  // namespace gsim::calibrate
