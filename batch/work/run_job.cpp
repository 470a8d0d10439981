#include "batch/work/run_job.h"

#include <algorithm>
#include <ctime>
#include <exception>
#include <filesystem>
#include <map>
#include <new>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "batch/work/edits.h"
#include "batch/work/run_options.h"
#include "engine/findings.h"
#include "engine/machine.h"
#include "engine/system/host_of_system.h"
#include "runtime/machine/machine_file.h"

namespace gsim::batch {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using Fault = tl::unexpected<std::string>;

constexpr const char* kBuiltIn = "built-in machine.toml";
constexpr std::size_t kMostFindings = 20;  // of a row

double cpu_now_s() {
    std::timespec now{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) / 1e9;
}

std::string normal(const std::string& name) {
    return std::filesystem::path(name).lexically_normal().string();
}

/// The files of one run: those of the system, and in place of some other texts. It keeps in mind what was
/// asked for.
class FilesOfRun {
  public:
    explicit FilesOfRun(InputFiles& files) : files_(files) {}

    void replace(const std::string& name, std::string text) { replaced_[normal(name)] = std::move(text); }
    bool is_replaced(const std::string& name) const { return replaced_.contains(normal(name)); }
    std::optional<std::string> read(const std::string& name) {
        const std::string plain = normal(name);
        if (const auto replaced = replaced_.find(plain); replaced != replaced_.end()) return replaced->second;
        const auto content = files_.get(plain);
        asked_[plain] = content == nullptr ? std::string() : content->sha256;
        return content == nullptr ? std::nullopt : std::optional(content->bytes);
    }
    /// A file that others read (meshes by OpenCASCADE, controller modules).
    void note(const std::string& name) { asked_[normal(name)] = files_.hash_of(normal(name)); }
    std::vector<ReadFile> asked() const {
        std::vector<ReadFile> all;
        for (const auto& [name, hash] : asked_) all.push_back({name, hash});
        return all;
    }

  private:
    InputFiles& files_;
    std::map<std::string, std::string> replaced_;
    std::map<std::string, std::string> asked_;
};

engine::Host host_with(const engine::Host& system, FilesOfRun& files) {
    engine::Host host = system;
    host.files = engine::Files::given([&files](const std::string& name) { return files.read(name); });
    host.find = [&files, find = system.find](engine::NameKind kind, const std::string& name) {
        return files.is_replaced(name) ? tl::expected<std::string, std::string>(name) : find(kind, name);
    };
    host.read_solid = [&files, read = system.read_solid](const std::string& file, double tolerance_mm) {
        files.note(file);
        return read(file, tolerance_mm);
    };
    host.load_module = [&files, load = system.load_module](const std::string& file,
                                                           const machine::Machine& machine) {
        files.note(file);
        return load(file, machine);
    };
    return host;
}

/// Puts edited texts in place of the files that settings are of.
class Edits {
  public:
    Edits(const Job& job, engine::Request& request, FilesOfRun& files)
        : job_(job), request_(request), files_(files) {}

    tl::expected<void, std::string> make() {
        // The cell may name another machine when it has been changed.
        return cell().and_then([&] { return machine(); }).and_then([&] { return data(); });
    }

  private:
    /// The text of a file that is asked for by name.
    tl::expected<std::string, std::string> text_of(engine::NameKind kind, std::string& name) {
        auto found = request_.host.find(kind, name);
        if (!found) return Fault(found.error());
        name = *std::move(found);
        auto text = files_.read(name);
        if (!text) return Fault(fmt::format("cannot read '{}'", name));
        return *std::move(text);
    }

    tl::expected<void, std::string> machine() {
        const auto settings = settings_of(job_.settings, kOfMachine);
        if (settings.empty()) return {};
        if (request_.machine.empty() && !request_.cell.empty()) {
            auto of_cell = engine::Machine::read(request_);
            if (!of_cell) return Fault(of_cell.error().message);
            request_.machine = of_cell->machine_file();
        }
        tl::expected<std::string, std::string> text = std::string(machine::built_in_machine_toml());
        if (request_.machine.empty()) {
            request_.machine = kBuiltIn;
        } else {
            text = text_of(engine::NameKind::machine, request_.machine);
        }
        if (!text) return Fault(text.error());
        return put(request_.machine, edited_toml(*std::move(text), request_.machine, settings));
    }

    tl::expected<void, std::string> cell() {
        const auto settings = settings_of(job_.settings, kOfCell);
        if (settings.empty()) return {};
        if (request_.cell.empty()) return Fault("a setting of the cell needs a cell file (option 'cell')");
        auto text = text_of(engine::NameKind::sample, request_.cell);
        if (!text) return Fault(text.error());
        return put(request_.cell, edited_toml(*std::move(text), request_.cell, settings));
    }

    tl::expected<void, std::string> data() {
        const auto settings = settings_of(job_.settings, kOfData);
        if (settings.empty()) return {};
        if (request_.machine_data.empty())
            return Fault("a setting of machine data needs a file of them (option 'machine_data')");
        const auto text = text_of(engine::NameKind::sample, request_.machine_data);
        if (!text) return Fault(text.error());
        return put(request_.machine_data, edited_data(*text, request_.machine_data, settings));
    }

    tl::expected<void, std::string> put(const std::string& name,
                                        tl::expected<std::string, std::string> edited) {
        return std::move(edited).map([&](std::string text) { files_.replace(name, std::move(text)); });
    }

    const Job& job_;
    engine::Request& request_;
    FilesOfRun& files_;
};

tl::expected<void, std::string> set_options(const Job& job, engine::Request& request) {
    for (const auto& [name, value] : job.options.items()) {
        if (const auto set = set_option(request, name, value); !set) return Fault(set.error());
    }
    for (const SettingValue& setting : settings_of(job.settings, kOfRun)) {
        if (const auto set = set_option(request, setting.key, setting.value); !set) return Fault(set.error());
    }
    return {};
}

std::string findings_text(const std::vector<engine::Diagnostic>& diagnostics) {
    if (diagnostics.empty()) return "[]";
    const std::size_t count = std::min(diagnostics.size(), kMostFindings);
    return json::parse(engine::findings_json(std::span(diagnostics).first(count))).at("diagnostics").dump();
}

void blame(RunRow& row, const engine::Diagnostic& told) {
    row.cause = told.code;
    row.message = told.text;
    row.file = told.file;
    row.line = told.line;
}

/// A run that was not begun.
void refuse(RunRow& row, const engine::Failure& failure, const std::vector<engine::Diagnostic>& told) {
    row.status = "refused";
    blame(row, failure.first_error ? *failure.first_error : engine::diagnostic_of(failure));
    if (row.cause.empty()) row.cause = failure.code;
    if (row.file.empty()) row.file = failure.file;
    row.findings = findings_text(told);
}

std::string extents_of(const engine::Report& report) {
    ordered_json extents = ordered_json::object();
    for (const engine::AxisRange& range : report.ranges)
        extents[std::string(1, range.letter)] = {range.min, range.max};
    return extents.dump();
}

/// The first thing that is wrong with a run.
void take_cause(RunRow& row, const engine::Report& report) {
    if (report.is_clean()) return;
    const auto first =
        std::find_if(report.diagnostics.begin(), report.diagnostics.end(),
                     [](const engine::Diagnostic& told) { return told.severity == engine::Severity::error; });
    if (first != report.diagnostics.end()) {
        blame(row, *first);
    } else if (report.alarm) {
        row.cause = report.alarm->code;
        row.message = report.alarm->message;
        row.file = report.alarm->place.file;
        row.line = report.alarm->place.line;
    } else {
        row.cause = row.status;
    }
}

void take_figures(RunRow& row, const engine::Report& report) {
    row.status = name(report.status);
    row.machine = report.machine;
    row.cycle_time_s = report.cycle_time_s;
    if (report.cycle_time_95) {
        row.least_s = report.cycle_time_95->least_s;
        row.most_s = report.cycle_time_95->most_s;
    }
    row.rapid_s = report.rapid_s;
    row.feed_s = report.feed_s;
    row.dwell_s = report.dwell_s;
    row.rapid_mm = report.rapid_mm;
    row.feed_mm = report.feed_mm;
    row.jet_on_mm = report.jet_on_mm;
    row.blocks = report.blocks;
    row.moves = report.moves;
    row.violations = report.violation_count;
    row.collisions = report.collisions.size();
    row.process_findings = report.process_findings;
    row.warnings = report.warnings.size();
    row.extents = extents_of(report);
    row.findings = findings_text(report.diagnostics);
}

/// What stands in the report as JSON alone.
void take_whole(RunRow& row, std::string text, bool keeps) {
    const json report = json::parse(text);
    if (const auto controller = report.find("controller");
        controller != report.end() && controller->is_string())
        row.controller = *controller;
    if (const auto efforts = report.find("efforts"); efforts != report.end() && efforts->is_object())
        row.energy_j = efforts->at("in_j").get<double>() - efforts->at("back_j").get<double>();
    if (keeps) row.report = std::move(text);
}

void run_request(RunRow& row, engine::Request request, bool keeps_report) {
    std::vector<engine::Diagnostic> told;
    auto run =
        engine::Run::open(std::move(request), [&](const engine::Diagnostic& each) { told.push_back(each); });
    if (!run) return refuse(row, run.error(), told);
    if (const auto prepared = run->prepare(); !prepared) return refuse(row, prepared.error(), told);
    const auto report = run->go();
    if (!report) return refuse(row, report.error(), told);
    take_figures(row, *report);
    take_cause(row, *report);
    take_whole(row, report->json(), keeps_report);
}

}  // namespace

JobRunner::JobRunner() : system_(engine::host_of_system()) {}

RunRow JobRunner::run(const Job& job) {
    try {
        return run_unguarded(job);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        RunRow row{.number = job.number};
        refuse(row, {.code = "internal", .message = error.what()}, {});
        return row;
    }
}

RunRow JobRunner::run_unguarded(const Job& job) {
    const double begun_s = cpu_now_s();
    RunRow row{.number = job.number};
    FilesOfRun files(files_);
    engine::Request request;
    request.program = job.program;
    request.machine = job.machine;
    request.shared_library = library_;
    request.host = host_with(system_, files);
    const auto ready = set_options(job, request).and_then([&] { return Edits(job, request, files).make(); });
    if (!ready) {
        refuse(row, {.code = "setting", .message = ready.error()}, {});
    } else {
        run_request(row, std::move(request), job.keeps_report);
    }
    row.files = files.asked();
    row.cpu_s = cpu_now_s() - begun_s;
    return row;
}

}  // namespace gsim::batch
