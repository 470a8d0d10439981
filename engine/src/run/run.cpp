#include "engine/run.h"

#include <utility>

#include "engine/src/guarded.h"
#include "engine/src/host_names.h"
#include "engine/src/run/effort_columns.h"
#include "engine/src/run/following_columns.h"
#include "engine/src/run/run_state.h"
#include "engine/src/run/segment_columns.h"
#include "engine/src/run/takers.h"

namespace gsim::engine {

using text::DiagnosticKind;

tl::expected<Run, Failure> Run::open(Request request, Tell tell) {
    return guarded([&]() -> tl::expected<Run, Failure> {
        if (std::string fault = find_contradiction(request); !fault.empty())
            return tl::unexpected(failure_of(DiagnosticKind::usage, std::move(fault)));
        const std::string cell = request.cell;
        auto found = with_files_found(std::move(request));
        if (!found)
            return tl::unexpected(failure_of(DiagnosticKind::input_file, std::move(found.error()), cell));
        Run run(std::make_unique<State>(*std::move(found), std::move(tell)));
        if (auto opened = run.state_->open(); !opened) return tl::unexpected(std::move(opened.error()));
        return run;
    });
}

tl::expected<Run, Failure> Run::open(Request request, const Machine& machine, Tell tell) {
    return guarded([&]() -> tl::expected<Run, Failure> {
        if (std::string fault = find_contradiction(request); !fault.empty())
            return tl::unexpected(failure_of(DiagnosticKind::usage, std::move(fault)));
        auto named = with_names_found(std::move(request));
        if (!named) return tl::unexpected(failure_of(DiagnosticKind::input_file, std::move(named.error())));
        Run run(std::make_unique<State>(FoundRequest{.request = *std::move(named)}, std::move(tell)));
        if (auto opened = run.state_->open_on(machine.parts()); !opened)
            return tl::unexpected(std::move(opened.error()));
        return run;
    });
}

Run::Run(std::unique_ptr<State> state) : state_(std::move(state)) {}
Run::Run(Run&&) noexcept = default;
Run& Run::operator=(Run&&) noexcept = default;
Run::~Run() = default;

tl::expected<void, Failure> Run::prepare() {
    return guarded([this] { return state_->prepare(); });
}

const std::vector<std::string>& Run::robots() const {
    return state_->names();
}

const std::vector<Axis>& Run::axes(std::size_t robot) const {
    return state_->axes()[robot];
}

AxisValues Run::home(std::size_t robot) const {
    const simulation::AxisVector& at = state_->simulator(robot).position();
    AxisValues values{};
    for (std::size_t i = 0; i < axes(robot).size(); ++i) values[i] = at[static_cast<Eigen::Index>(i)];
    return values;
}

tl::expected<void, Failure> Run::write(Document document, TextSink sink, const DocumentOptions& options,
                                       std::size_t robot) {
    return guarded([&] {
        return state_->documents(robot)
            .add(document, std::move(sink), options)
            .map_error(
                [](std::string fault) { return failure_of(DiagnosticKind::output, std::move(fault)); });
    });
}

void Run::take_moves(TakeMoves take, std::size_t robot) {
    simulation::Simulator& simulator = state_->simulator(robot);
    state_->documents(robot).add_output(
        hand_out_moves(std::move(take), simulator.machine(), simulator.files()));
}

void Run::observe_motion(simulation::MotionObserver& observer, std::size_t robot) {
    state_->simulator(robot).observe_motion(observer);
}

void Run::take_segments(TakeSegments take, std::size_t robot) {
    state_->documents(robot).add_output(
        hand_out_segments(std::move(take), state_->simulator(robot).machine()));
}

void Run::take_columns(TakeColumns take, std::size_t robot) {
    simulation::Simulator& simulator = state_->simulator(robot);
    if (simulator.cell() != nullptr) simulator.cell()->keep_history();
    state_->documents(robot).add_output(
        hand_out_columns(std::move(take), simulator.machine(), simulator.tips_mm()));
}

tl::expected<void, Failure> Run::take_efforts(TakeEfforts take, std::size_t robot) {
    const simulation::Simulator& simulator = state_->simulator(robot);
    const dynamics::Dynamics* dynamics = simulator.dynamics();
    if (dynamics == nullptr) return tl::unexpected(failure_of(DiagnosticKind::usage, std::string(kNoMasses)));
    state_->documents(robot).add_output(hand_out_efforts(std::move(take), simulator.machine(), *dynamics));
    return {};
}

tl::expected<void, Failure> Run::take_following(TakeFollowing take, std::size_t robot) {
    const auto setup = state_->simulator(robot).following_setup();
    if (!setup) return tl::unexpected(failure_of(DiagnosticKind::usage, std::string(kNoServos)));
    state_->documents(robot).add_output(hand_out_following(std::move(take), *setup));
    return {};
}

tl::expected<Scene, Failure> Run::scene(std::size_t robot) const {
    return guarded([&]() -> tl::expected<Scene, Failure> { return state_->scene(robot); });
}

const std::vector<std::string>& Run::files(std::size_t robot) const {
    return state_->simulator(robot).files();
}

tl::expected<void, Failure> Run::take_samples(TakeSamples take, double step_s, std::size_t robot) {
    if (auto fault = fault_of_step(step_s))
        return tl::unexpected(failure_of(DiagnosticKind::usage, *std::move(fault)));
    const simulation::Simulator& simulator = state_->simulator(robot);
    state_->documents(robot).add_output(
        hand_out_samples(std::move(take), simulator.machine(), step_s, simulator.max_time_s()));
    return {};
}

void Run::show_progress(Progress progress) {
    state_->show_progress(std::move(progress));
}

tl::expected<Report, Failure> Run::go() {
    return guarded([this] { return state_->go(); });
}

const std::vector<Failure>& Run::faults() const {
    return state_->faults();
}

tl::expected<std::string, Failure> Run::variables() const {
    return guarded([this] { return state_->variables(); });
}

tl::expected<std::string, Failure> Run::machine_data() const {
    return guarded([this] { return state_->machine_data(); });
}

Report Run::report_of(const Failure& failure) const {
    return state_->report_of(failure);
}

const Request& Run::request() const {
    return state_->found().request;
}

std::string program_folder(const std::string& program) {
    return folder_of_program(program).string();
}

std::vector<Run::NamedFile> Run::named_files() const {
    return state_->named_files();
}

}  // namespace gsim::engine
