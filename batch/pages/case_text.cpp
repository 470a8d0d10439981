#include "batch/pages/case_text.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/text/base64.h"
#include "base/text/json.h"
#include "batch/pages/history_text.h"
#include "batch/pages/page_text.h"

namespace gsim::batch {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t kMaxFiles = 100;  // of those that a run has read

std::string time_with_interval(const Case& of, const RunDetails& run) {
    if (!of.now->has_time()) return fmt::format("{} s, but it ended early", seconds(of.now->time_s));
    std::string text = seconds(of.now->time_s) + " s";
    if (run.times.min_s && run.times.max_s)
        text += fmt::format(" (95 %: {} to {} s)", seconds(*run.times.min_s), seconds(*run.times.max_s));
    return text;
}

std::string extents_text(const std::string& extents) {
    const auto read = text::try_parse_json<ordered_json>(extents);
    std::string text;
    for (const auto& [axis, range] : read.items()) {
        if (!range.is_array() || range.size() != 2 || !range[0].is_number() || !range[1].is_number())
            continue;
        text += fmt::format("{}{} {:.3f} to {:.3f}", text.empty() ? "" : ", ", escape_html(axis),
                            range[0].get<double>(), range[1].get<double>());
    }
    return text.empty() ? text : text + " (mm, degrees)";
}

std::string metrics_list(const CaseDetails& details) {
    const RunSummary& facts = *details.of->now;
    const RunDetails& run = details.now;
    std::vector<std::pair<std::string_view, std::string>> all{{"Outcome", outcome(facts)}};
    if (!facts.is_clean()) all.emplace_back("First error", first_error(facts));
    all.emplace_back("Cycle time", time_with_interval(*details.of, run));
    all.emplace_back("of which",
                     fmt::format("{} s in rapid, {} s at feed, {} s dwelling", seconds(run.times.rapid_s),
                                 seconds(run.times.feed_s), seconds(run.times.dwell_s)));
    all.emplace_back("Distance",
                     fmt::format("{:.1f} mm in rapid, {:.1f} mm at feed, {:.1f} mm with the process on",
                                 run.distances.rapid_mm, run.distances.feed_mm, run.distances.process_on_mm));
    all.emplace_back("Blocks, moves", fmt::format("{}, {}", run.counts.blocks, run.counts.moves));
    if (std::string extents = extents_text(run.extents); !extents.empty())
        all.emplace_back("Extents", std::move(extents));
    if (run.energy_j)
        all.emplace_back("Energy of the motors", fmt::format("{:.6g} kJ", *run.energy_j / 1000));
    all.emplace_back("Findings",
                     fmt::format("{} limit violations, {} collisions, {} process errors; {} warnings",
                                 facts.violations, facts.collisions, facts.process_findings, facts.warnings));
    if (!run.machine_name.empty()) all.emplace_back("Machine", escape_html(run.machine_name));
    if (!run.controller.empty()) all.emplace_back("Controller", escape_html(run.controller));
    if (run.options != "{}") all.emplace_back("Options", settings_text(run.options));
    all.emplace_back("Run", fmt::format("{} by gsim {}{}", time_markup(run.run_at), escape_html(run.version),
                                        details.of->is_reused ? "; reused since" : ""));
    return definition_list(all);
}

std::string text_at(const ordered_json& finding, const char* key) {
    const auto found = finding.find(key);
    return found != finding.end() && found->is_string() ? escape_html(found->get<std::string>())
                                                        : std::string();
}

std::string finding_text(const ordered_json& finding) {
    const std::string severity = text_at(finding, "severity"), file = text_at(finding, "file");
    const auto line = finding.find("line");
    const bool has_line = line != finding.end() && line->is_number_integer();
    const std::string position = has_line ? fmt::format("{}:{}", file, line->get<std::int64_t>()) : file;
    const std::string hint = text_at(finding, "hint");
    return fmt::format(
        "<li><code>{}</code> <span class=\"{}\">{}</span>: {} <span class=\"soft\">[{}]</span>{}</li>\n",
        position, severity == "error" ? "bad" : "soft", severity, text_at(finding, "text"),
        text_at(finding, "code"), hint.empty() ? hint : " " + hint);
}

std::string findings_section(const RunSummary& facts, const RunDetails& run) {
    std::string items;
    std::int64_t count = 0;
    for (const ordered_json& finding : text::try_parse_json<ordered_json>(run.findings)) {
        if (finding.is_object()) items += finding_text(finding);
        count += finding.is_object() ? 1 : 0;
    }
    if (count == 0) return {};
    std::string text = fmt::format("<h3>Findings</h3>\n<ol>\n{}</ol>\n", items);
    const std::int64_t all = facts.findings() + facts.warnings;
    if (all > count) text += fmt::format("<p class=\"soft\">The first {} of {}.</p>\n", count, all);
    return text;
}

std::string change_text(const NightlyReport& report, const CaseDetails& details) {
    const Case& of = *details.of;
    if (!report.before) return {};
    if (of.before == nullptr) return fmt::format("<p>New since {}.</p>\n", batch_label(*report.before));
    if (of.before == of.now)
        return fmt::format("<p>The same run as in {}.</p>\n", batch_label(*report.before));
    std::string text = fmt::format("<p>In {}: {}", batch_label(*report.before), outcome(*of.before));
    if (of.before->has_time()) text += fmt::format(", {} s", seconds(of.before->time_s));
    if (of.before->has_time() && of.now->has_time())
        text += fmt::format("; now {}", difference(of.before->time_s, of.now->time_s));
    return text + fmt::format(".<br/>Reason for the new run: {}.</p>\n", reasons_text(details.rerun_reasons));
}

std::string files_text(const RunDetails& run) {
    if (run.files.empty()) return "<p>The files that the run read are unknown.</p>\n";
    HtmlTable table("Files that the run read", {"File", "SHA-256"});
    for (std::size_t i = 0; i < std::min(run.files.size(), kMaxFiles); ++i)
        table.add({escape_html(run.files[i].name),
                   run.files[i].sha256.empty()
                       ? std::string("not found by the run")
                       : fmt::format("<code>{}</code>", escape_html(run.files[i].sha256))});
    std::string text = table.text();
    if (run.files.size() > kMaxFiles)
        text += fmt::format("<p>{} more are not shown here.</p>\n", run.files.size() - kMaxFiles);
    return text;
}

std::string command_text(std::string_view what, const ViewCommand& command) {
    if (command.words.empty()) return {};
    std::string text = fmt::format("<p>{}</p>\n<pre tabindex=\"0\"><code>{}</code></pre>\n", what,
                                   escape_html(shell_line(command.words)));
    if (command.left_out.empty()) return text;
    std::string names;
    for (const std::string& name : command.left_out) names += (names.empty() ? "" : ", ") + escape_html(name);
    return text + fmt::format("<p class=\"soft\">It has no option for {}, so that run differs.</p>\n", names);
}

/// Embeds the picture as a separate document, because its names and styles must stay separate, too.
std::string picture_text(const RunDetails& run) {
    if (run.picture_svg.empty()) return {};
    std::string bytes;
    text::Base64 base64;
    base64.add(run.picture_svg, bytes);
    base64.end(bytes);
    return fmt::format(
        "<p><img alt=\"Path, speed and acceleration\" src=\"data:image/svg+xml;base64,{}\"/></p>\n", bytes);
}

std::string view_commands(const CaseDetails& details) {
    std::string text = "<h3>View the run</h3>\n";
    if (!details.view.empty()) text += fmt::format("<p>{}</p>\n", link(details.view, "The finished run"));
    if (!details.view_error.empty())
        text += fmt::format("<p class=\"soft\">The page of the finished run is not available: {}.</p>\n",
                            escape_html(details.view_error));
    return text +
           command_text("In the Studio, from the folder in which the batch was run:",
                        studio_command(run_inputs(details.now))) +
           command_text("As a standalone page:", view_command(run_inputs(details.now)));
}

}  // namespace

std::string reasons_text(const std::vector<std::string>& reasons) {
    if (reasons.empty()) return "unknown";
    std::string text;
    for (const std::string& reason : reasons) text += (text.empty() ? "" : ", ") + escape_html(reason);
    return text;
}

std::string case_text(const NightlyReport& report, const CaseDetails& details) {
    const Case& of = *details.of;
    std::string title = machine_label(of.machine);
    if (const std::string settings = settings_text(of.settings); !settings.empty()) title += ", " + settings;
    return fmt::format("<section id=\"case-{}\"><h2>{}</h2>\n", of.position + 1, title) +
           metrics_list(details) + picture_text(details.now) + change_text(report, details) +
           findings_section(*of.now, details.now) + "<h3>History</h3>\n" + history_text(report, of) +
           view_commands(details) + "<h3>Files that the run read</h3>\n" + files_text(details.now) +
           "</section>\n";
}

}  // namespace gsim::batch
