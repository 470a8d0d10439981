#include "batch/pages/page_text.h"

#include <fmt/format.h>

#include "base/text/json.h"
#include "base/text/printable.h"
#include "base/text/xml_text.h"

namespace gsim::batch {

namespace {

using nlohmann::ordered_json;

constexpr std::string_view kDash = "\u2013";

/// Formats "2026-11-27T03:00:12Z" for people.
std::string format_utc(std::string_view utc) {
    if (utc.size() != 20) return std::string(utc);
    return fmt::format("{} {} UTC", utc.substr(0, 10), utc.substr(11, 5));
}

/// One style for all pages, without other files, so that a page can be sent alone.
constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; --text: #1f2328; --ground: #ffffff; --soft: #f3f4f6; --line: #d0d7de; --link: #0b57d0; --bad: #b3261e; --good: #1a7f37; }
@media (prefers-color-scheme: dark) { :root { --text: #e6e6e6; --ground: #16181c; --soft: #22262c; --line: #3a4049; --link: #8ab4f8; --bad: #ff8a80; --good: #6fcf8a; } }
* { box-sizing: border-box; }
body { font: 15px/1.5 system-ui, sans-serif; color: var(--text); background: var(--ground); max-width: 76rem; margin: 0 auto; padding: 1rem; }
h1, h2, h3 { line-height: 1.25; overflow-wrap: anywhere; }
h2 { margin-top: 2.2rem; border-bottom: 1px solid var(--line); padding-bottom: .25rem; }
h3 { margin-top: 1.6rem; }
a { color: var(--link); overflow-wrap: anywhere; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .15rem 1rem; margin: .8rem 0; }
dt { color: var(--text); opacity: .75; } dd { margin: 0; overflow-wrap: anywhere; }
.wide { overflow-x: auto; margin: .8rem 0; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { text-align: left; vertical-align: top; padding: .3rem .7rem .3rem 0; border-bottom: 1px solid var(--line); font-weight: normal; }
td { min-width: 4rem; max-width: 28rem; overflow-wrap: break-word; }
tbody th { min-width: 9rem; max-width: 22rem; overflow-wrap: break-word; }
table a { overflow-wrap: break-word; }
thead th { font-weight: 600; white-space: nowrap; }
pre { background: var(--soft); padding: .6rem .8rem; overflow-x: auto; }
code { font-size: .93em; overflow-wrap: anywhere; }
.bad { color: var(--bad); font-weight: 600; } .good { color: var(--good); } .soft { opacity: .75; }
img { max-width: 100%; background: #ffffff; }
svg { display: block; width: 100%; max-width: 46rem; background: var(--soft); }
svg polyline { fill: none; stroke: var(--link); stroke-width: 1.5; } svg circle { fill: var(--link); } svg path { stroke: var(--bad); stroke-width: 2; } svg text { fill: var(--text); font-size: 11px; }
)";

}  // namespace

std::string escape_html(std::string_view text) {
    return text::xml_text(text::printable(text));
}

std::string link(std::string_view address, std::string_view text) {
    return fmt::format("<a href=\"{}\">{}</a>", escape_html(address), escape_html(text));
}

std::string time_markup(std::string_view utc) {
    return fmt::format("<time datetime=\"{}\">{}</time>", escape_html(utc), escape_html(format_utc(utc)));
}

std::string seconds(double time_s) {
    return fmt::format("{:.3f}", time_s);
}

std::string time_text(const RunSummary& run) {
    return run.has_time() ? seconds(run.time_s) : std::string(kDash);
}

std::string difference(double before_s, double now_s) {
    const std::string difference_text = fmt::format("{:+.6g} s", now_s - before_s);
    return before_s > 0 ? fmt::format("{} ({:+.3g} %)", difference_text, 100 * (now_s - before_s) / before_s)
                        : difference_text;
}

std::string count_text(std::size_t count, std::string_view one, std::string_view many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string batch_label(const BatchSummary& batch) {
    return fmt::format("batch {} ({})", batch.id, time_markup(batch.started_at));
}

std::string plain_batch_label(const BatchSummary& batch) {
    return fmt::format("batch {} ({})", batch.id, format_utc(batch.started_at));
}

std::string outcome(const RunSummary& run) {
    if (run.is_clean()) return "<span class=\"good\">without errors</span>";
    const std::string status = fmt::format("<span class=\"bad\">{}</span>", escape_html(run.status));
    return run.cause.empty() || run.cause == run.status
               ? status
               : fmt::format("{}: {}", status, escape_html(run.cause));
}

std::string first_error(const RunSummary& run) {
    if (run.is_clean()) return {};
    std::string position = escape_html(run.file);
    if (!position.empty() && run.line > 0) position += fmt::format(":{}", run.line);
    if (position.empty()) return escape_html(run.message);
    return fmt::format("{} <span class=\"soft\">{}</span>", escape_html(run.message), position);
}

std::string machine_label(std::string_view machine) {
    return machine.empty() ? std::string("built-in machine") : escape_html(machine);
}

std::string settings_text(const std::string& settings) {
    const auto read = text::try_parse_json<ordered_json>(settings);
    if (!read.is_object()) return escape_html(settings);
    std::string text;
    for (const auto& [key, value] : read.items()) {
        const auto* word = value.get_ptr<const std::string*>();
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", escape_html(key),
                            escape_html(word == nullptr ? value.dump() : *word));
    }
    return text;
}

std::string case_address(const Case& of, std::string_view page) {
    return of.has_details ? fmt::format("{}#case-{}", page, of.position + 1) : std::string(page);
}

HtmlTable::HtmlTable(std::string_view label, const std::vector<std::string_view>& columns) {
    text_ = fmt::format(
        "<div class=\"wide\" role=\"region\" tabindex=\"0\" aria-label=\"{0}\"><table aria-label=\"{0}\">"
        "<thead><tr>",
        escape_html(label));
    for (const std::string_view column : columns)
        text_ += fmt::format("<th scope=\"col\">{}</th>", escape_html(column));
    text_ += "</tr></thead><tbody>\n";
}

void HtmlTable::add(const std::vector<std::string>& cells) {
    text_ += "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i)
        text_ += i == 0 ? fmt::format("<th scope=\"row\">{}</th>", cells[i])
                        : fmt::format("<td>{}</td>", cells[i]);
    text_ += "</tr>\n";
}

std::string definition_list(const std::vector<std::pair<std::string_view, std::string>>& entries) {
    std::string text = "<dl>\n";
    for (const auto& [name, value] : entries)
        text += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escape_html(name), value);
    return text + "</dl>\n";
}

std::string page_marker(std::string_view name) {
    return fmt::format("<meta name=\"generator\" content=\"gsim-batch --pages, {}\"/>", escape_html(name));
}

std::string full_page(std::string_view name, std::string_view title, std::string_view breadcrumbs,
                      std::string_view body) {
    // The policy blocks all fetches and scripts, whatever the names of files are.
    std::string page = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>{}\n<meta "
        "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
        "img-src data:\"/>"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>{}</title>"
        "<style>{}</style></head>\n<body>",
        page_marker(name), escape_html(title), kStyle);
    if (!breadcrumbs.empty()) page += fmt::format("<nav aria-label=\"Breadcrumb\">{}</nav>\n", breadcrumbs);
    return page + fmt::format("<main><h1>{}</h1>\n{}</main></body></html>\n", escape_html(title), body);
}

}  // namespace gsim::batch
