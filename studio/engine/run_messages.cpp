#include "studio/engine/run_messages.h"

#include <fmt/format.h>

#include "base/text/json.h"
#include "studio/engine/message.h"
#include "studio/engine/run_series.h"

namespace gsim::studio {

namespace {

using engine::Run;
using VoidResult = tl::expected<void, engine::Error>;
using Json = nlohmann::ordered_json;

/// Bodies do not change, so their surfaces are sent once.
enum class Meshes { with, without };

const char* severity_name(engine::Severity severity) {
    switch (severity) {
        case engine::Severity::error: return "error";
        case engine::Severity::warning: return "warning";
        case engine::Severity::note: return "note";
    }
    return "";
}

/// Sends the scene, and returns the data sent.
tl::expected<Json, engine::Error> send_scene(const Run& run, std::size_t robot, Meshes meshes,
                                             const Post& post) {
    const auto scene = run.scene(robot);
    if (!scene) return tl::unexpected(scene.error());
    Message message("scene");
    message.header()["robot"] = robot;
    message.header()["name"] = run.robots()[robot];
    Json reported = text::parse_json<Json>(scene->json);
    message.header()["scene"] = reported;
    message.header()["files"] = run.files(robot);
    for (std::size_t i = 0; meshes == Meshes::with && i < scene->meshes_mm.size(); ++i)
        message.add(fmt::format("mesh{}", i).c_str(), scene->meshes_mm[i]);
    post(message.bytes());
    return reported;
}

void send_columns(const engine::SegmentColumns& columns, std::size_t robot, const Post& post) {
    Message message("segments");
    message.header()["robot"] = robot;
    message.header()["first"] = columns.first;
    message.add("start_s", columns.start_s);
    message.add("duration_s", columns.duration_s);
    message.add("length_mm", columns.length_mm);
    message.add("feed_per_min", columns.feed_per_min);
    message.add("deviation_mm", columns.deviation_mm);
    message.add("values", columns.values);
    message.add("line", columns.line);
    message.add("file", columns.file);
    message.add("flags", columns.flags);
    message.add("tip", columns.tcp);
    message.add("record", columns.record);
    message.add("vertex_mm", columns.vertex_mm);
    message.add("vertex_s", columns.vertex_s);
    message.add("vertex_segment", columns.vertex_segment);
    post(message.bytes());
}

}  // namespace

void send_diagnostic(const engine::Diagnostic& reported, const Post& post) {
    Message message("diagnostic");
    message.header().update({{"severity", severity_name(reported.severity)},
                             {"code", reported.code},
                             {"file", reported.file},
                             {"line", reported.line},
                             {"column", reported.column},
                             {"end_column", reported.end_column},
                             {"text", reported.text},
                             {"hint", reported.hint}});
    post(message.bytes());
}

VoidResult send_run(Run& run, RunSeries& series, const Post& post) {
    for (std::size_t robot = 0; robot < run.robots().size(); ++robot) {
        const auto scene = send_scene(run, robot, Meshes::with, post);
        if (!scene) return tl::unexpected(scene.error());
        series.add_run(run, robot, *scene);
        run.on_columns(
            [robot, &post](const engine::SegmentColumns& columns) { send_columns(columns, robot, post); },
            robot);
    }
    return {};
}

VoidResult send_end(const Run& run, const RunSeries& series, const engine::Report& report, const Post& post) {
    for (std::size_t robot = 0; robot < run.robots().size(); ++robot) {
        const auto scene = send_scene(run, robot, Meshes::without, post);
        if (!scene) return tl::unexpected(scene.error());
    }
    series.post(post);
    send_report(report, post);
    return {};
}

void send_report(const engine::Report& report, const Post& post) {
    Message message("report");
    message.header()["report"] = text::parse_json<nlohmann::ordered_json>(report.json());
    message.header()["text"] = report.text();
    post(message.bytes());
}

}  // namespace gsim::studio
