#include "engine/src/run/run_state.h"

#include "engine/src/host_names.h"
#include "engine/src/run/run_cell.h"
#include "engine/src/run/variables_text.h"
#include "runtime/simulator/machine_dynamics.h"

namespace gsim::engine {

using text::DiagnosticKind;

tl::expected<void, Error> Run::State::open() {
    if (found_.request.robots.empty()) {
        return open_single_robot().and_then([this] { return open_module(); }).and_then([this] {
            return open_program();
        });
    }
    return RobotsRun::open(found_, run_context_)
        .map([this](RobotsRun run) {
            robots_ = std::make_unique<RobotsRun>(std::move(run));
            for (const RobotsRun::Station& station : robots_->stations())
                names_.push_back(station.entry.name);
        })
        .and_then([this] { return open_program(); });
}

tl::expected<void, Error> Run::State::open_single_robot() {
    names_ = {{}};
    const Request& request = found_.request;
    auto input = read_machine_input(request.host, request.machine, found_.machine_named_by);
    if (!input) return tl::unexpected(make_error(DiagnosticKind::input_file, input.error(), request.machine));
    for (const text::Diagnostic& diagnostic : machine_diagnostics(*input)) diagnostics_.handler()(diagnostic);
    machine_ = *std::move(input);
    auto cell = read_cell_contents(make_cell_source(found_), machine_->machine);
    if (!cell) return tl::unexpected(make_error(DiagnosticKind::input_file, cell.error(), request.cell));
    cell_ = std::make_shared<const cell::Cell>(*std::move(cell));
    return open_dynamics();
}

/// Reads meshes of bodies with masses.
tl::expected<void, Error> Run::State::open_dynamics() {
    auto dynamics = simulation::make_dynamics(machine_->machine, mesh_files(found_.request.host));
    if (!dynamics)
        return tl::unexpected(
            make_error(DiagnosticKind::input_file, dynamics.error(), found_.request.machine));
    dynamics_ = *std::move(dynamics);
    return {};
}

tl::expected<void, Error> Run::State::open_on_machine(const Machine::Parts& parts) {
    names_ = {{}};
    Request& request = found_.request;
    request.machine = parts.found.request.machine;
    request.cell = parts.found.request.cell;
    request.collisions = parts.found.request.collisions;
    found_.cell_text = parts.found.cell_text;
    found_.machine_named_by = parts.found.machine_named_by;
    if (parts.found.machine_data_named_by == os::NameSource::in_file) {
        request.machine_data = parts.found.request.machine_data;
        found_.machine_data_named_by = os::NameSource::in_file;
    }
    machine_ = parts.input;
    cell_ = parts.bodies;
    return open_dynamics().and_then([this] { return open_module(); }).and_then([this] {
        return open_program();
    });
}

/// Called before a program is confined, because confinement blocks resources that a module may use.
tl::expected<void, Error> Run::State::open_module() {
    auto module = load_module(found_.request, machine_->machine);
    if (!module) return tl::unexpected(make_error(DiagnosticKind::input_file, module.error()));
    module_ = *std::move(module);
    return {};
}

tl::expected<void, Error> Run::State::open_program() {
    Request& request = found_.request;
    if (request.text) {
        program_ = open_text_script(std::move(request.text->impl()));
        request.text.reset();
        return {};
    }
    if (request.program.empty())
        return tl::unexpected(make_error(DiagnosticKind::usage, "no program is given"));
    auto file = resolve_name(request.host, NameKind::sample, request.program);
    if (!file) return tl::unexpected(make_error(DiagnosticKind::file, file.error(), request.program));
    request.program = *std::move(file);
    return open_script(request.host.files.impl(), request.program).map([this](OpenedScript opened) {
        program_ = std::move(opened);
    });
}

tl::expected<void, Error> Run::State::prepare() {
    if (robots_ != nullptr) {
        if (auto prepared = robots_->prepare(*program_, progress()); !prepared)
            return tl::unexpected(prepared.error());
        for (RobotsRun::Station& station : robots_->stations()) add(*station.simulator);
        return {};
    }
    auto inputs = read_run_inputs(found_, MachineInput(*machine_), cell_, *program_, run_context_);
    if (!inputs) return tl::unexpected(inputs.error());
    inputs->module = std::exchange(module_, std::nullopt);
    program_run_ = std::make_unique<ProgramRun>(found_, *std::move(inputs), run_context_, progress());
    program_run_->simulator().monitors().set_dynamics(dynamics_);
    add(program_run_->simulator());
    return {};
}

void Run::State::add(simulation::Simulator& simulator) {
    std::vector<Axis>& axes = axes_.emplace_back();
    for (const machine::Axis& axis : simulator.machine().axes)
        axes.push_back({axis.letter, axis.kind == machine::AxisKind::rotary});
    simulators_.push_back(&simulator);
    output_sets_.push_back(std::make_unique<OutputSet>(simulator));
    if (found_.request.explain) output_sets_.back()->explain();
}

simulation::Report Run::State::run_single_robot() {
    simulation::Report report = program_run_->run();
    report.messages.diagnostics = diagnostics_.diagnostics();
    output_sets_.front()->complete(report);
    errors_ = output_sets_.front()->finish(report);
    return report;
}

simulation::RobotsReport Run::State::run_robots() {
    std::vector<simulation::RobotReport> reports = robots_->run();
    for (std::size_t i = 0; i < reports.size(); ++i) {
        output_sets_[i]->complete(reports[i].report);
        for (Error& error : output_sets_[i]->finish(reports[i].report)) errors_.push_back(std::move(error));
    }
    return robots_->combined_report(std::move(reports));
}

tl::expected<Report, Error> Run::State::go() {
    if (robots_ != nullptr) return engine::make_report(run_robots());
    return engine::make_report(run_single_robot());
}

tl::expected<ProgramRun*, Error> Run::State::kept() {
    if (program_run_) return program_run_.get();
    return tl::unexpected(
        make_error(DiagnosticKind::usage, "persistent data are available only for a run of one robot"));
}

tl::expected<std::string, Error> Run::State::variables() {
    return kept().and_then([](ProgramRun* run) {
        return run->engine()
            .permanent_variables()
            .map(variables_text)
            .map_error(
                [](const gsim::Error& error) { return make_error(DiagnosticKind::output, error.message); });
    });
}

tl::expected<std::string, Error> Run::State::machine_data() {
    return kept().and_then([](ProgramRun* run) {
        return run->engine()
            .machine_data()
            .and_then([&](const machine::MachineData& data) { return run->document().update(data); })
            .map([&] { return run->document().text(); })
            .map_error(
                [](const gsim::Error& error) { return make_error(DiagnosticKind::output, error.message); });
    });
}

Report Run::State::make_report(const Error& error) const {
    simulation::Report report;
    report.source.program = program_ ? program_->source.name() : found_.request.program;
    if (machine_) {
        report.source.machine = machine_->machine.name;
        if (found_.request.module.empty()) report.source.controller = machine_->machine.controller.model;
    }
    const auto kind = text::diagnostic_kind(error.code).value_or(DiagnosticKind::internal);
    const bool stopped = kind == DiagnosticKind::run_limit;
    report.status = stopped ? simulation::RunStatus::stopped : simulation::RunStatus::alarm;
    report.alarm = simulation::Alarm{};
    report.alarm->kind = kind;
    report.alarm->message = "the program has errors: " + error.message;
    if (error.first_error) {
        if (stopped) report.alarm->message = error.first_error->text;
        report.source.files.push_back(error.first_error->file);
        report.alarm->location = {0, error.first_error->line};
    }
    report.messages.diagnostics = diagnostics_.diagnostics();
    return engine::make_report(std::move(report));
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
    if (found_.machine_named_by == os::NameSource::in_file)
        add(found_.request.machine, "the machine of the cell", {});
    if (found_.machine_data_named_by == os::NameSource::in_file)
        add(found_.request.machine_data, "the machine data of the cell", {});
    return files;
}

}  // namespace gsim::engine
