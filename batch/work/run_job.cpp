#include "batch/work/run_job.h"

#include <algorithm>
#include <ctime>
#include <exception>
#include <new>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/text/json.h"
#include "batch/work/job_edits.h"
#include "batch/work/path_job.h"
#include "batch/work/run_files.h"
#include "engine/findings.h"
#include "engine/system/picture.h"
#include "engine/system/system_host.h"

namespace gsim::batch {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::size_t kMaxFindings = 20;  // of a row

double cpu_time_s() {
    std::timespec now{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) / 1e9;
}

std::string findings_text(const std::vector<engine::Diagnostic>& diagnostics) {
    if (diagnostics.empty()) return "[]";
    const std::size_t count = std::min(diagnostics.size(), kMaxFindings);
    return text::parse_json<json>(engine::findings_json(std::span(diagnostics).first(count)))
        .at("diagnostics")
        .dump();
}

void record_error(RunRow& row, const engine::Diagnostic& reported) {
    row.outcome.cause = reported.code;
    row.outcome.message = reported.text;
    row.outcome.file = reported.file;
    row.outcome.line = reported.line;
}

/// Fills the row of a run that was not begun.
void mark_refused(RunRow& row, const engine::Error& error, const std::vector<engine::Diagnostic>& reported) {
    row.outcome.status = "refused";
    record_error(row, error.first_error ? *error.first_error : engine::to_diagnostic(error));
    if (row.outcome.cause.empty()) row.outcome.cause = error.code;
    if (row.outcome.file.empty()) row.outcome.file = error.file;
    row.findings = findings_text(reported);
}

std::string extents_json(const engine::Report& report) {
    ordered_json extents = ordered_json::object();
    for (const engine::AxisRange& range : report.ranges)
        extents[std::string(1, range.letter)] = {range.min, range.max};
    return extents.dump();
}

/// Stores the first error of a run.
void set_cause(RunRow& row, const engine::Report& report) {
    if (report.is_clean()) return;
    const auto first = std::find_if(
        report.diagnostics.begin(), report.diagnostics.end(),
        [](const engine::Diagnostic& reported) { return reported.severity == engine::Severity::error; });
    if (first != report.diagnostics.end()) {
        record_error(row, *first);
    } else if (report.alarm) {
        row.outcome.cause = report.alarm->code;
        row.outcome.message = report.alarm->message;
        row.outcome.file = report.alarm->location.file;
        row.outcome.line = report.alarm->location.line;
    } else {
        row.outcome.cause = row.outcome.status;
    }
}

void set_metrics(RunRow& row, const engine::Report& report) {
    row.outcome.status = name(report.status);
    row.machine = report.machine;
    row.times.cycle_s = report.cycle_time_s;
    if (report.cycle_time_95) {
        row.times.min_s = report.cycle_time_95->min_s;
        row.times.max_s = report.cycle_time_95->max_s;
    }
    row.times.rapid_s = report.times.rapid_s;
    row.times.feed_s = report.times.feed_s;
    row.times.dwell_s = report.times.dwell_s;
    row.distances.rapid_mm = report.distances.rapid_mm;
    row.distances.feed_mm = report.distances.feed_mm;
    row.distances.process_on_mm = report.distances.process_on_mm;
    row.counts.blocks = report.counts.blocks;
    row.counts.moves = report.counts.moves;
    row.counts.violations = report.violation_count;
    row.counts.collisions = report.collisions.size();
    row.counts.process_findings = report.process_findings;
    row.counts.warnings = report.warnings.size();
    row.extents = extents_json(report);
    row.findings = findings_text(report.diagnostics);
}

std::optional<double> json_number(const json& report, const char* key) {
    const auto found = report.find(key);
    return found != report.end() && found->is_number() ? std::optional(found->get<double>()) : std::nullopt;
}

/// Returns the smallest distance of bodies, or the checked distance if none comes nearer.
std::optional<double> min_clearance_mm(const json& report) {
    const auto cell = report.find("cell");
    if (cell == report.end() || !cell->is_object()) return std::nullopt;
    double min_mm = cell->at("clearance_mm");
    for (const json& block : report.at("clearances"))
        min_mm = std::min(min_mm, block.at("clearance_mm").get<double>());
    return report.at("collisions").empty() ? min_mm : 0;
}

/// Stores the values that only the JSON report has.
void set_json_values(RunRow& row, std::string text, bool stored_documents) {
    const json report = text::parse_json<json>(text);
    if (const auto controller = report.find("controller");
        controller != report.end() && controller->is_string())
        row.controller = *controller;
    if (const auto efforts = report.find("efforts"); efforts != report.end() && efforts->is_object())
        row.energy_j = efforts->at("in_j").get<double>() - efforts->at("back_j").get<double>();
    row.clearance_mm = min_clearance_mm(report);
    if (const auto blends = report.find("blends"); blends != report.end() && blends->is_object())
        row.deviation_mm = json_number(blends->at("feed"), "max_deviation_mm");
    row.times.lower_bound_s = json_number(report, "lower_bound_s");
    if (stored_documents) row.documents.report = std::move(text);
}

/// Monitors the joint speeds of all robots.
void monitor_joint_speeds(RunRow& row, engine::Run& run) {
    row.joint_speed_share = 0;
    for (std::size_t robot = 0; robot < run.robots().size(); ++robot) {
        run.on_segments(
            [&](std::span<const engine::Segment> segments) {
                for (const engine::Segment& segment : segments)
                    row.joint_speed_share = std::max(*row.joint_speed_share, segment.peak_axis_speed_share());
            },
            robot);
    }
}

/// Draws the picture, with several robots that of the first one.
void draw(RunRow& row, const std::string& script) {
    auto picture = engine::draw_picture(script);
    (picture ? row.documents.picture : row.documents.picture_error) =
        picture ? *std::move(picture) : picture.error().message;
}

void run_request(RunRow& row, JobRequest request, StoredDocuments stored_documents) {
    std::vector<engine::Diagnostic> reported;
    auto run = engine::Run::open(std::move(request.run),
                                 [&](const engine::Diagnostic& each) { reported.push_back(each); });
    if (!run) return mark_refused(row, run.error(), reported);
    if (const auto prepared = run->prepare(); !prepared) return mark_refused(row, prepared.error(), reported);
    std::string script;
    if (stored_documents.picture) {
        const auto sink = [&](std::string_view text) { return script.append(text), true; };
        if (const auto files_read = run->write(engine::OutputKind::plot, sink); !files_read)
            row.documents.picture_error = files_read.error().message;
    }
    if (request.joint_speeds) monitor_joint_speeds(row, *run);
    const auto report = run->go();
    if (!report) return mark_refused(row, report.error(), reported);
    set_metrics(row, *report);
    set_cause(row, *report);
    set_json_values(row, report->json(), stored_documents.report);
    if (!script.empty()) draw(row, script);
}

}  // namespace

JobRunner::JobRunner() : system_(engine::make_system_host()) {}

RunRow JobRunner::run(const Job& job) {
    try {
        return run_unguarded(job);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        RunRow row{.number = job.number};
        mark_refused(row, {.code = "internal", .message = error.what()}, {});
        return row;
    }
}

tl::expected<JobRequest, engine::Error> JobRunner::prepare(const Job& job, RunFiles& files) const {
    JobRequest request;
    request.run.program = job.program;
    request.run.machine = job.machine;
    request.run.compiled_lua_library = library_;
    request.run.host = host_with_replacements(system_, files);
    return set_options(job, request)
        .and_then([&] { return make_edits(job, request.run, files); })
        .map_error(
            [](const Error& error) { return engine::Error{.code = "setting", .message = error.message}; })
        .map([&] { return std::move(request); });
}

tl::expected<JobTexts, engine::Error> JobRunner::job_texts(const Job& job) {
    RunFiles files(files_);
    auto request = prepare(job, files);
    if (!request) return tl::unexpected(request.error());
    auto program = write_path(job, *request, host_with_originals(system_, files));
    if (!program) return tl::unexpected(program.error());
    const engine::Request& run = request->run;
    return JobTexts{run.machine, run.machine_data, run.cell,
                    run.robots,  files.replaced(), *std::move(program)};
}

RunRow JobRunner::run_unguarded(const Job& job) {
    const double start_s = cpu_time_s();
    RunRow row{.number = job.number};
    RunFiles files(files_);
    auto request = prepare(job, files);
    auto written = request.and_then(
        [&](const JobRequest& ready) { return write_path(job, ready, host_with_originals(system_, files)); });
    if (!written) {
        mark_refused(row, written.error(), {});
    } else {
        if (*written) {
            request->run.program = job.program + ".nc";
            request->run.text = engine::Text(**std::move(written), request->run.program);
        }
        run_request(row, *std::move(request), job.stored_documents);
    }
    row.files = files.files_read();
    row.cpu_s = cpu_time_s() - start_s;
    return row;
}

}  // namespace gsim::batch
