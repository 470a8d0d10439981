#include "engine/src/run/run_state.h"

#include "engine/src/host_names.h"
#include "engine/src/run/run_cell.h"
#include "engine/src/run/variables_text.h"
#include "runtime/simulator/machine_dynamics.h"

namespace gsim::engine {

using text::DiagnosticKind;

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

/// Reads meshes of bodies with masses.
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

/// Called before a program is confined, because confinement blocks resources that a module may use.
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

}  // namespace gsim::engine
