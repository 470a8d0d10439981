#include "batch/work/run_job.h"

#include <algorithm>
#include <ctime>
#include <exception>
#include <new>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/text/json.h"
#include "batch/work/files_of_run.h"
#include "batch/work/job_edits.h"
#include "batch/work/path_job.h"
#include "engine/findings.h"
#include "engine/system/host_of_system.h"
#include "engine/system/picture.h"

namespace gsim::batch {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using Fault = tl::unexpected<std::string>;

constexpr std::size_t kMostFindings = 20;  // of a row

double cpu_now_s() {
    std::timespec now{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) / 1e9;
}

std::string findings_text(const std::vector<engine::Diagnostic>& diagnostics) {
    if (diagnostics.empty()) return "[]";
    const std::size_t count = std::min(diagnostics.size(), kMostFindings);
    return text::parse_json<json>(engine::findings_json(std::span(diagnostics).first(count)))
        .at("diagnostics")
        .dump();
}

void blame(RunRow& row, const engine::Diagnostic& told) {
    row.cause = told.code;
    row.message = told.text;
    row.file = told.file;
    row.line = told.line;
}

/// Fills the row of a run that was not begun.
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

/// Stores the first error of a run.
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

std::optional<double> number_in(const json& report, const char* key) {
    const auto found = report.find(key);
    return found != report.end() && found->is_number() ? std::optional(found->get<double>()) : std::nullopt;
}

/// Returns the smallest distance of bodies, or the checked distance if none comes nearer.
std::optional<double> clearance_in(const json& report) {
    const auto cell = report.find("cell");
    if (cell == report.end() || !cell->is_object()) return std::nullopt;
    double least_mm = cell->at("clearance_mm");
    for (const json& block : report.at("clearances"))
        least_mm = std::min(least_mm, block.at("clearance_mm").get<double>());
    return report.at("collisions").empty() ? least_mm : 0;
}

/// Stores the values that only the JSON report has.
void take_whole(RunRow& row, std::string text, bool keeps) {
    const json report = text::parse_json<json>(text);
    if (const auto controller = report.find("controller");
        controller != report.end() && controller->is_string())
        row.controller = *controller;
    if (const auto efforts = report.find("efforts"); efforts != report.end() && efforts->is_object())
        row.energy_j = efforts->at("in_j").get<double>() - efforts->at("back_j").get<double>();
    row.clearance_mm = clearance_in(report);
    if (const auto blends = report.find("blends"); blends != report.end() && blends->is_object())
        row.deviation_mm = number_in(blends->at("feed"), "max_deviation_mm");
    row.lower_bound_s = number_in(report, "lower_bound_s");
    if (keeps) row.report = std::move(text);
}

/// Monitors the joint speeds of all robots.
void watch_joint_speeds(RunRow& row, engine::Run& run) {
    row.joint_speed_share = 0;
    for (std::size_t robot = 0; robot < run.robots().size(); ++robot) {
        run.take_segments(
            [&](std::span<const engine::Segment> segments) {
                for (const engine::Segment& segment : segments)
                    row.joint_speed_share = std::max(*row.joint_speed_share, segment.peak_axis_speed_share());
            },
            robot);
    }
}

/// Draws the picture, with several robots that of the first one.
void draw(RunRow& row, const std::string& script) {
    auto picture = engine::drawn(script);
    (picture ? row.picture : row.picture_fault) = picture ? *std::move(picture) : picture.error();
}

void run_request(RunRow& row, JobRequest request, Kept keeps) {
    std::vector<engine::Diagnostic> told;
    auto run = engine::Run::open(std::move(request.run),
                                 [&](const engine::Diagnostic& each) { told.push_back(each); });
    if (!run) return refuse(row, run.error(), told);
    if (const auto prepared = run->prepare(); !prepared) return refuse(row, prepared.error(), told);
    std::string script;
    if (keeps.picture) {
        const auto sink = [&](std::string_view text) { return script.append(text), true; };
        if (const auto asked = run->write(engine::Document::plot, sink); !asked)
            row.picture_fault = asked.error().message;
    }
    if (request.joint_speeds) watch_joint_speeds(row, *run);
    const auto report = run->go();
    if (!report) return refuse(row, report.error(), told);
    take_figures(row, *report);
    take_cause(row, *report);
    take_whole(row, report->json(), keeps.report);
    if (!script.empty()) draw(row, script);
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

tl::expected<JobRequest, engine::Failure> JobRunner::prepare(const Job& job, FilesOfRun& files) const {
    JobRequest request;
    request.run.program = job.program;
    request.run.machine = job.machine;
    request.run.shared_library = library_;
    request.run.host = host_with(system_, files);
    return set_options(job, request)
        .and_then([&] { return make_edits(job, request.run, files); })
        .map_error(
            [](std::string why) { return engine::Failure{.code = "setting", .message = std::move(why)}; })
        .map([&] { return std::move(request); });
}

tl::expected<JobTexts, engine::Failure> JobRunner::texts_of(const Job& job) {
    FilesOfRun files(files_);
    auto request = prepare(job, files);
    if (!request) return tl::unexpected(request.error());
    auto program = write_path(job, *request, host_as_it_is(system_, files));
    if (!program) return tl::unexpected(program.error());
    const engine::Request& run = request->run;
    return JobTexts{run.machine, run.machine_data, run.cell,
                    run.robots,  files.replaced(), *std::move(program)};
}

RunRow JobRunner::run_unguarded(const Job& job) {
    const double begun_s = cpu_now_s();
    RunRow row{.number = job.number};
    FilesOfRun files(files_);
    auto request = prepare(job, files);
    auto written = request.and_then(
        [&](const JobRequest& ready) { return write_path(job, ready, host_as_it_is(system_, files)); });
    if (!written) {
        refuse(row, written.error(), {});
    } else {
        if (*written) {
            request->run.program = job.program + ".nc";
            request->run.text = engine::Text(**std::move(written), request->run.program);
        }
        run_request(row, *std::move(request), job.keeps);
    }
    row.files = files.asked();
    row.cpu_s = cpu_now_s() - begun_s;
    return row;
}

}  // namespace gsim::batch
