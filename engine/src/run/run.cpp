#include "engine/run.h"

#include <utility>

#include "engine/src/guard_exceptions.h"
#include "engine/src/host_names.h"
#include "engine/src/run/chunk_outputs.h"
#include "engine/src/run/effort_columns.h"
#include "engine/src/run/following_columns.h"
#include "engine/src/run/run_state.h"
#include "engine/src/run/segment_columns.h"

namespace gsim::engine {

using text::DiagnosticKind;

tl::expected<Run, Error> Run::open(Request request, DiagnosticHandler on_diagnostic) {
    return guard_exceptions([&]() -> tl::expected<Run, Error> {
        if (auto error = find_contradiction(request))
            return tl::unexpected(make_error(DiagnosticKind::usage, *std::move(error)));
        const std::string cell = request.cell;
        auto found = resolve_files(std::move(request));
        if (!found)
            return tl::unexpected(make_error(DiagnosticKind::input_file, std::move(found.error()), cell));
        Run run(std::make_unique<State>(*std::move(found), std::move(on_diagnostic)));
        if (auto opened = run.state_->open(); !opened) return tl::unexpected(std::move(opened.error()));
        return run;
    });
}

tl::expected<Run, Error> Run::open(Request request, const Machine& machine, DiagnosticHandler on_diagnostic) {
    return guard_exceptions([&]() -> tl::expected<Run, Error> {
        if (auto error = find_contradiction(request))
            return tl::unexpected(make_error(DiagnosticKind::usage, *std::move(error)));
        auto resolved_request = resolve_names(std::move(request));
        if (!resolved_request)
            return tl::unexpected(
                make_error(DiagnosticKind::input_file, std::move(resolved_request.error())));
        Run run(std::make_unique<State>(ResolvedRequest{.request = *std::move(resolved_request)},
                                        std::move(on_diagnostic)));
        if (auto opened = run.state_->open_on_machine(machine.parts()); !opened)
            return tl::unexpected(std::move(opened.error()));
        return run;
    });
}

Run::Run(std::unique_ptr<State> state) : state_(std::move(state)) {}
Run::Run(Run&&) noexcept = default;
Run& Run::operator=(Run&&) noexcept = default;
Run::~Run() = default;

tl::expected<void, Error> Run::prepare() {
    return guard_exceptions([this] { return state_->prepare(); });
}

const std::vector<std::string>& Run::robots() const {
    return state_->names();
}

const std::vector<Axis>& Run::axes(std::size_t robot) const {
    return state_->axes()[robot];
}

AxisValues Run::home(std::size_t robot) const {
    const simulation::AxisVector& at = state_->simulator(robot).position().axes();
    AxisValues values{};
    for (std::size_t i = 0; i < axes(robot).size(); ++i) values[i] = at[static_cast<Eigen::Index>(i)];
    return values;
}

tl::expected<void, Error> Run::write(OutputKind output_kind, TextSink sink, const OutputOptions& options,
                                     std::size_t robot) {
    return guard_exceptions([&] {
        return state_->outputs(robot)
            .add(output_kind, std::move(sink), options)
            .map_error(
                [](const gsim::Error& error) { return make_error(DiagnosticKind::output, error.message); });
    });
}

void Run::on_moves(MovesHandler callback, std::size_t robot) {
    simulation::Simulator& simulator = state_->simulator(robot);
    state_->outputs(robot).add_output(
        make_moves_output(std::move(callback), simulator.machine(), simulator.program().files().names()));
}

void Run::observe_motion(simulation::MotionObserver& observer, std::size_t robot) {
    state_->simulator(robot).motion().observe(observer);
}

void Run::on_segments(SegmentsHandler callback, std::size_t robot) {
    state_->outputs(robot).add_output(
        make_segments_output(std::move(callback), state_->simulator(robot).machine()));
}

void Run::on_columns(ColumnsHandler callback, std::size_t robot) {
    simulation::Simulator& simulator = state_->simulator(robot);
    if (simulator.cell().monitor() != nullptr) simulator.cell().monitor()->keep_history();
    state_->outputs(robot).add_output(
        make_columns_output(std::move(callback), simulator.machine(), simulator.program().tool().tcps_mm()));
}

tl::expected<void, Error> Run::on_efforts(EffortsHandler callback, std::size_t robot) {
    const simulation::Simulator& simulator = state_->simulator(robot);
    const dynamics::Dynamics* dynamics = simulator.monitors().dynamics();
    if (dynamics == nullptr)
        return tl::unexpected(make_error(DiagnosticKind::usage, std::string(kNoMassesError)));
    state_->outputs(robot).add_output(
        make_efforts_output(std::move(callback), simulator.machine(), *dynamics));
    return {};
}

tl::expected<void, Error> Run::on_following(FollowingHandler callback, std::size_t robot) {
    const auto setup = state_->simulator(robot).monitors().following_setup();
    if (!setup) return tl::unexpected(make_error(DiagnosticKind::usage, std::string(kNoServosError)));
    state_->outputs(robot).add_output(make_following_output(std::move(callback), *setup));
    return {};
}

tl::expected<Scene, Error> Run::scene(std::size_t robot) const {
    return guard_exceptions([&]() -> tl::expected<Scene, Error> { return state_->scene(robot); });
}

const std::vector<std::string>& Run::files(std::size_t robot) const {
    return state_->simulator(robot).program().files().names();
}

tl::expected<void, Error> Run::on_samples(SamplesHandler callback, double step_s, std::size_t robot) {
    if (auto error = find_step_error(step_s))
        return tl::unexpected(make_error(DiagnosticKind::usage, *std::move(error)));
    const simulation::Simulator& simulator = state_->simulator(robot);
    state_->outputs(robot).add_output(make_samples_output(std::move(callback), simulator.machine(), step_s,
                                                          simulator.outcome().limits().max_time_s));
    return {};
}

void Run::on_progress(Progress progress) {
    state_->on_progress(std::move(progress));
}

tl::expected<Report, Error> Run::go() {
    return guard_exceptions([this] { return state_->go(); });
}

const std::vector<Error>& Run::errors() const {
    return state_->errors();
}

tl::expected<std::string, Error> Run::variables() const {
    return guard_exceptions([this] { return state_->variables(); });
}

tl::expected<std::string, Error> Run::machine_data() const {
    return guard_exceptions([this] { return state_->machine_data(); });
}

Report Run::make_report(const Error& error) const {
    return state_->make_report(error);
}

const Request& Run::request() const {
    return state_->found().request;
}

std::string program_folder(const std::string& program) {
    return main_program_folder(program).string();
}

std::vector<Run::NamedFile> Run::named_files() const {
    return state_->named_files();
}

}  // namespace gsim::engine
