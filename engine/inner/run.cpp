#include "engine/run.h"

#include <optional>
#include <utility>

#include "engine/inner/documents.h"
#include "engine/inner/effort_columns.h"
#include "engine/inner/following_columns.h"
#include "engine/inner/guarded.h"
#include "engine/inner/host_names.h"
#include "engine/inner/machine_parts.h"
#include "engine/inner/program_run.h"
#include "engine/inner/robots_run.h"
#include "engine/inner/run_cell.h"
#include "engine/inner/run_inputs.h"
#include "engine/inner/scene.h"
#include "engine/inner/segment_columns.h"
#include "engine/inner/takers.h"
#include "engine/inner/values.h"
#include "engine/inner/variables_text.h"
#include "runtime/simulation/machine_dynamics.h"

namespace gsim::engine {

using text::DiagnosticKind;

class Run::State {
  public:
    State(FoundRequest found, Tell tell)
        : found_(std::move(found)), cpu_(found_.request.limits.cpu_s), user_(std::move(tell)) {
        cpu_.end_when(found_.request.cancel.flag());
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    tl::expected<void, Failure> open();
    tl::expected<void, Failure> open_on(const Machine::Parts& parts);
    tl::expected<void, Failure> prepare();
    tl::expected<Report, Failure> go();
    tl::expected<std::string, Failure> variables();
    tl::expected<std::string, Failure> machine_data();
    Report report_of(const Failure& failure) const;

    const FoundRequest& found() const { return found_; }
    const std::vector<std::string>& names() const { return names_; }
    const std::vector<std::vector<Axis>>& axes() const { return axes_; }
    const std::vector<Failure>& faults() const { return faults_; }
    simulation::Simulator& simulator(std::size_t robot) { return *simulators_[robot]; }
    Documents& documents(std::size_t robot) { return *documents_[robot]; }
    void show_progress(Progress progress) { progress_ = std::move(progress); }
    std::vector<NamedFile> named_files() const;
    Scene scene(std::size_t robot) const {
        if (robots_ == nullptr) return scene_of(*simulators_[robot]);
        return scene_of(*simulators_[robot], robots_->stations()[robot].entry.base);
    }

  private:
    tl::expected<void, Failure> open_one();
    tl::expected<void, Failure> open_program();
    tl::expected<void, Failure> open_module();
    tl::expected<void, Failure> open_dynamics();
    void add(simulation::Simulator& simulator);
    ShowProgress progress() {
        return [this](std::uint64_t done, std::uint64_t total) {
            if (progress_) progress_(done, total);
        };
    }
    simulation::Report run_one();
    simulation::RobotsReport run_robots();
    /// What is kept of a run of one robot; nothing else is.
    tl::expected<ProgramRun*, Failure> kept();

    FoundRequest found_;
    os::CpuLimit cpu_;
    Tell user_;
    std::vector<text::Diagnostic> told_;
    TellDiagnostic tell_ = [this](const text::Diagnostic& told) {
        told_.push_back(told);
        if (user_) user_(diagnostic_of(told));
    };
    RunTools tools_{cpu_, tell_};
    std::optional<MachineInput> machine_;
    std::shared_ptr<const cell::Cell> cell_;
    std::shared_ptr<const dynamics::Dynamics> dynamics_;
    std::optional<OpenedScript> program_;
    std::optional<rrs::RcsModule> module_;
    std::unique_ptr<ProgramRun> one_;
    std::unique_ptr<RobotsRun> robots_;
    std::vector<std::string> names_;
    std::vector<std::vector<Axis>> axes_;
    std::vector<simulation::Simulator*> simulators_;
    std::vector<std::unique_ptr<Documents>> documents_;
    std::vector<Failure> faults_;
    Progress progress_;
};

tl::expected<void, Failure> Run::State::open() {
    if (found_.request.robots.empty()) {
        return open_one().and_then([this] { return open_module(); }).and_then([this] {
            return open_program();
        });
    }
    return RobotsRun::open(found_, tools_)
        .map([this](RobotsRun run) {
            robots_ = std::make_unique<RobotsRun>(std::move(run));
            for (const RobotsRun::Station& station : robots_->stations())
                names_.push_back(station.entry.name);
        })
        .map_error([](const InputError& error) { return failure_of(error); })
        .and_then([this] { return open_program(); });
}

tl::expected<void, Failure> Run::State::open_one() {
    names_ = {{}};
    const Request& request = found_.request;
    auto input = read_machine_input(request.host, request.machine, found_.machine_named_by);
    if (!input) return tl::unexpected(failure_of(DiagnosticKind::input_file, input.error(), request.machine));
    for (const std::string& note : input->notes)
        tell_({.severity = text::Severity::note, .kind = DiagnosticKind::machine, .text = note});
    machine_ = *std::move(input);
    auto cell = read_cell_of_run(cell_choice(found_), machine_->machine);
    if (!cell) return tl::unexpected(failure_of(DiagnosticKind::input_file, cell.error(), request.cell));
    cell_ = std::make_shared<const cell::Cell>(*std::move(cell));
    return open_dynamics();
}

/// Reads meshes of bodies that have masses.
tl::expected<void, Failure> Run::State::open_dynamics() {
    auto dynamics = simulation::make_dynamics(machine_->machine, mesh_files(found_.request.host));
    if (!dynamics)
        return tl::unexpected(
            failure_of(DiagnosticKind::input_file, dynamics.error(), found_.request.machine));
    dynamics_ = *std::move(dynamics);
    return {};
}

tl::expected<void, Failure> Run::State::open_on(const Machine::Parts& parts) {
    names_ = {{}};
    Request& request = found_.request;
    request.machine = parts.found.request.machine;
    request.cell = parts.found.request.cell;
    request.collisions = parts.found.request.collisions;
    found_.cell_text = parts.found.cell_text;
    found_.machine_named_by = parts.found.machine_named_by;
    if (parts.found.machine_data_named_by == os::NamedBy::a_file) {
        request.machine_data = parts.found.request.machine_data;
        found_.machine_data_named_by = os::NamedBy::a_file;
    }
    machine_ = parts.input;
    cell_ = parts.bodies;
    return open_dynamics().and_then([this] { return open_module(); }).and_then([this] {
        return open_program();
    });
}

/// Before a program is confined, which takes from it what a module may reach.
tl::expected<void, Failure> Run::State::open_module() {
    auto module = load_module(found_.request, machine_->machine);
    if (!module) return tl::unexpected(failure_of(DiagnosticKind::input_file, module.error()));
    module_ = *std::move(module);
    return {};
}

tl::expected<void, Failure> Run::State::open_program() {
    Request& request = found_.request;
    if (request.text) {
        program_ = opened_text(std::move(request.text->inner()));
        request.text.reset();
        return {};
    }
    if (request.program.empty())
        return tl::unexpected(failure_of(DiagnosticKind::usage, "no program is given"));
    auto file = find_name(request.host, NameKind::sample, request.program);
    if (!file) return tl::unexpected(failure_of(DiagnosticKind::file, file.error(), request.program));
    request.program = *std::move(file);
    return open_script(request.host.files.inner(), request.program)
        .map([this](OpenedScript opened) { program_ = std::move(opened); })
        .map_error([](const InputError& error) { return failure_of(error); });
}

tl::expected<void, Failure> Run::State::prepare() {
    if (robots_ != nullptr) {
        if (auto prepared = robots_->prepare(*program_, progress()); !prepared)
            return tl::unexpected(failure_of(prepared.error()));
        for (RobotsRun::Station& station : robots_->stations()) add(*station.simulator);
        return {};
    }
    auto inputs = read_run_inputs(found_, MachineInput(*machine_), cell_, *program_, tools_);
    if (!inputs) return tl::unexpected(failure_of(inputs.error()));
    inputs->module = std::exchange(module_, std::nullopt);
    one_ = std::make_unique<ProgramRun>(found_, *std::move(inputs), tools_, progress());
    one_->simulator().set_dynamics(dynamics_);
    add(one_->simulator());
    return {};
}

void Run::State::add(simulation::Simulator& simulator) {
    std::vector<Axis>& axes = axes_.emplace_back();
    for (const machine::Axis& axis : simulator.machine().axes)
        axes.push_back({axis.letter, axis.kind == machine::AxisKind::rotary});
    simulators_.push_back(&simulator);
    documents_.push_back(std::make_unique<Documents>(simulator));
    if (found_.request.explain) documents_.back()->explain();
}

simulation::Report Run::State::run_one() {
    simulation::Report report = one_->run();
    report.diagnostics = told_;
    documents_.front()->complete(report);
    faults_ = documents_.front()->finish(report);
    return report;
}

simulation::RobotsReport Run::State::run_robots() {
    std::vector<simulation::RobotReport> reports = robots_->run();
    for (std::size_t i = 0; i < reports.size(); ++i) {
        documents_[i]->complete(reports[i].report);
        for (Failure& fault : documents_[i]->finish(reports[i].report)) faults_.push_back(std::move(fault));
    }
    return robots_->whole(std::move(reports));
}

tl::expected<Report, Failure> Run::State::go() {
    if (robots_ != nullptr) return engine::report_of(run_robots());
    return engine::report_of(run_one());
}

tl::expected<ProgramRun*, Failure> Run::State::kept() {
    if (one_) return one_.get();
    return tl::unexpected(
        failure_of(DiagnosticKind::usage, "what a control keeps is told of a run of one robot"));
}

tl::expected<std::string, Failure> Run::State::variables() {
    return kept().and_then([](ProgramRun* run) {
        return run->engine().permanent_variables().map(variables_text).map_error([](std::string sentence) {
            return failure_of(DiagnosticKind::output, std::move(sentence));
        });
    });
}

tl::expected<std::string, Failure> Run::State::machine_data() {
    return kept().and_then([](ProgramRun* run) {
        return run->engine()
            .machine_data()
            .and_then([&](const machine::MachineData& data) { return run->document().update(data); })
            .map([&] { return run->document().text(); })
            .map_error(
                [](std::string sentence) { return failure_of(DiagnosticKind::output, std::move(sentence)); });
    });
}

Report Run::State::report_of(const Failure& failure) const {
    simulation::Report report;
    report.program = program_ ? program_->source.name() : found_.request.program;
    if (machine_) {
        report.machine = machine_->machine.name;
        if (found_.request.module.empty()) report.controller = machine_->machine.controller.model;
    }
    const auto kind = text::diagnostic_kind(failure.code).value_or(DiagnosticKind::internal);
    const bool stopped = kind == DiagnosticKind::run_limit;
    report.status = stopped ? simulation::RunStatus::stopped : simulation::RunStatus::alarm;
    report.alarm = simulation::Alarm{};
    report.alarm->kind = kind;
    report.alarm->message = "the program has errors: " + failure.message;
    if (failure.first_error) {
        if (stopped) report.alarm->message = failure.first_error->text;
        report.files.push_back(failure.first_error->file);
        report.alarm->place = {0, failure.first_error->line};
    }
    report.diagnostics = told_;
    return engine::report_of(std::move(report));
}

std::vector<Run::NamedFile> Run::State::named_files() const {
    std::vector<NamedFile> files;
    const auto add = [&](const std::string& name, const char* what, const std::string& robot) {
        if (!name.empty()) files.push_back({name, what, robot});
    };
    if (robots_ != nullptr) {
        for (const RobotsRun::Station& station : robots_->stations()) {
            add(station.entry.machine.string(), "its machine", station.entry.name);
            add(station.entry.machine_data.string(), "its machine data", station.entry.name);
            add(station.entry.cell.string(), "its cell", station.entry.name);
        }
        return files;
    }
    if (found_.machine_named_by == os::NamedBy::a_file)
        add(found_.request.machine, "the machine of the cell", {});
    if (found_.machine_data_named_by == os::NamedBy::a_file)
        add(found_.request.machine_data, "the machine data of the cell", {});
    return files;
}

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
    const dynamics::Dynamics* dynamics = state_->simulator(robot).dynamics();
    if (dynamics == nullptr) return tl::unexpected(failure_of(DiagnosticKind::usage, std::string(kNoMasses)));
    state_->documents(robot).add_output(hand_out_efforts(std::move(take), *dynamics));
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
