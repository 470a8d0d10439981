#include "calibrate/times/predictor.h"

#include <algorithm>
#include <atomic>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "engine/run.h"
#include "runtime/machine/machine_file.h"

namespace gsim::calibrate {

namespace {

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

}  // namespace

tl::expected<Predictor, std::string> Predictor::of(std::span<const RecordedRun> runs, std::string dialect) {
    Predictor predictor;
    predictor.dialect_ = std::move(dialect);
    for (const RecordedRun& run : runs) {
        if (!bytes_of(run.program)) return tl::unexpected(fmt::format("cannot read {}", run.program));
        predictor.programs_.push_back(run.program);
    }
    return predictor;
}

tl::expected<double, std::string> Predictor::time_s(const std::string& program,
                                                    const std::string& machine) const {
    engine::Request request;
    request.program = program;
    request.machine = kMachine;
    request.language.dialect = dialect_;
    request.collisions = false;
    request.host.files = files_with(machine);
    auto run = engine::Run::open(std::move(request));
    if (!run) return tl::unexpected(run.error().message);
    if (const auto ready = run->prepare(); !ready) return tl::unexpected(ready.error().message);
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

std::vector<tl::expected<double, std::string>> Predictor::times_s(const machine::Machine& machine) const {
    const std::string text = machine::print_machine(machine);
    std::vector<tl::expected<double, std::string>> times(programs_.size(), 0.0);
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < programs_.size(); i = next++) times[i] = time_s(programs_[i], text);
    };
    std::vector<std::jthread> threads;
    for (unsigned i = 1; i < std::max(std::thread::hardware_concurrency(), 1U); ++i)
        threads.emplace_back(work);
    work();
    threads.clear();
    return times;
}

}  // namespace gsim::calibrate
