#include "tests/accuracy/report.h"

#include <algorithm>

#include <fmt/format.h>

#include "tests/accuracy/table.h"

namespace gsim::accuracy {

namespace {

constexpr std::size_t kNoteWidth = 40;

std::string heading(std::string_view title, Format format) {
    return format == Format::markdown ? fmt::format("### {}\n\n", title) : fmt::format("{}\n", title);
}

std::string table(const std::vector<Column>& columns, const std::vector<Row>& rows, Format format) {
    return (format == Format::markdown ? markdown_table(columns, rows) : plain_table(columns, rows)) + '\n';
}

// A paragraph in either format: no line of it may run into the next one.
std::string remark(const std::string& text, Format format) {
    return fmt::format("{}{}\n", format == Format::markdown ? "- " : "  ", text);
}

std::string shortened(const std::string& note) {
    if (note.size() <= kNoteWidth) return note;
    std::size_t length = kNoteWidth - 3;
    while (length > 0 && (static_cast<unsigned char>(note[length]) & 0xC0U) == 0x80U) --length;  // UTF-8
    return note.substr(0, length) + "...";
}

Row row(const TimeOutcome& outcome, const Controller& controller) {
    Row cells{outcome.name, shortened(outcome.note)};
    if (outcome.found_s) {
        cells.push_back(fmt::format("{:.4f}", *outcome.found_s));
        cells.push_back(fmt::format("{:.4f}", outcome.recorded_s));
        cells.push_back(fmt::format("{:+.1f}", 1000 * outcome.error_s()));
        cells.push_back(fmt::format("{:+.3f}", outcome.error_percent()));
    } else {
        cells.insert(cells.end(), {"-", fmt::format("{:.4f}", outcome.recorded_s), "-", "-"});
    }
    cells.emplace_back(name(mark(outcome, controller)));
    return cells;
}

std::string remarks(const TimeOutcome& outcome, Format format) {
    std::string text;
    if (!outcome.found_s)
        text += remark(fmt::format("{}: refused: {}", outcome.name, outcome.found_s.error().message), format);
    if (!outcome.known.empty())
        text += remark(fmt::format("{}: known: {}", outcome.name, outcome.known), format);
    return text;
}

std::string within(const Tolerance& tolerance) {
    return fmt::format("within {} % or {} ms", tolerance.percent, 1000 * tolerance.min_s);
}

std::string summary_text(const Summary& summary, const Controller& controller) {
    std::string text =
        fmt::format("{} of {} {}; {} of {} {}", summary.close, summary.counted, within(controller.close),
                    summary.fair, summary.counted, within(controller.fair));
    if (!summary.largest) return text;
    const TimeOutcome& largest = *summary.largest;
    return text + fmt::format("; largest {:+.3f} % ({:+.1f} ms, {})", largest.error_percent(),
                              1000 * largest.error_s(), largest.name);
}

std::string with_gap(std::string text) {
    if (!text.empty()) text += '\n';
    return text;
}

Row row(const PathOutcome& outcome) {
    const std::string mark = outcome.good() ? "good" : "OFF";
    if (!outcome.distance) return {outcome.name, "-", "-", "-", mark};
    return {outcome.name, fmt::format("{:.3f}", outcome.distance->mm),
            fmt::format("{}", outcome.distance->line), fmt::format("{:.3f}", outcome.distance->into_block_s),
            mark};
}

std::string remarks(const PathOutcome& outcome, Format format) {
    std::string text;
    if (!outcome.distance)
        text += remark(fmt::format("{}: {}", outcome.name, outcome.distance.error().message), format);
    if (!outcome.known.empty())
        text += remark(fmt::format("{}: known: {}", outcome.name, outcome.known), format);
    return text;
}

}  // namespace

std::string time_report(std::span<const TimeOutcome> outcomes, const Controller& controller, Format format) {
    const std::vector<Column> columns{{"program", Align::left},   {"note", Align::left},
                                      {"gsim s", Align::right},   {"recorded s", Align::right},
                                      {"error ms", Align::right}, {"error %", Align::right},
                                      {"mark", Align::left}};
    std::vector<Row> rows;
    std::string all_remarks;
    for (const TimeOutcome& outcome : outcomes) {
        rows.push_back(row(outcome, controller));
        all_remarks += remarks(outcome, format);
    }
    return heading(fmt::format("Cycle times, {}", controller.name), format) + table(columns, rows, format) +
           with_gap(all_remarks) + summary_text(summarize(outcomes, controller), controller) + "\n\n";
}

std::string path_report(std::span<const PathOutcome> outcomes, const Controller& controller, Format format) {
    if (outcomes.empty()) return {};
    const std::vector<Column> columns{{"program", Align::left},
                                      {"largest mm", Align::right},
                                      {"in line", Align::right},
                                      {"s into it", Align::right},
                                      {"mark", Align::left}};
    std::vector<Row> rows;
    std::string all_remarks;
    for (const PathOutcome& outcome : outcomes) {
        rows.push_back(row(outcome));
        all_remarks += remarks(outcome, format);
    }
    const auto good = std::count_if(outcomes.begin(), outcomes.end(), [](const auto& o) { return o.good(); });
    return heading(fmt::format("Positions, {}, block by block", controller.name), format) +
           table(columns, rows, format) + with_gap(all_remarks) +
           fmt::format("{} of {} within {} mm\n\n", good, outcomes.size(), kGoodDistance_mm);
}

}  // namespace gsim::accuracy
