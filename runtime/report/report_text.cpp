#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "base/text/number.h"
#include "runtime/report/report.h"
#include "runtime/report/report_efforts.h"
#include "runtime/report/report_following.h"
#include "runtime/report/text_helpers.h"

namespace gsim::simulation {

namespace {

constexpr std::size_t kBarWidth = 24;
constexpr std::size_t kMaxDisplayedEvents = 8;
constexpr std::size_t kMaxDisplayedWarnings = 20;
constexpr std::size_t kMaxDisplayedCollisions = 20;
constexpr std::size_t kMaxDisplayedClearances = 8;
constexpr std::size_t kMaxDisplayedViolations = 20;

std::string clock_text(double time_s) {
    if (!(time_s >= 0 && time_s < 1e9)) return "-";
    const auto total_s = std::llround(time_s);
    return fmt::format("{}:{:02}:{:02}", total_s / 3600, total_s / 60 % 60, total_s % 60);
}

class Text {
  public:
    template <typename... Args>
    void line(fmt::format_string<Args...> format, Args&&... args) {
        std::string text = fmt::format(format, std::forward<Args>(args)...);
        text.erase(text.find_last_not_of(' ') + 1);
        text_ += text + '\n';
    }
    void blank() { text_ += '\n'; }
    /// Adds lines that are made elsewhere.
    void lines(std::string_view text) { text_ += text; }

    /// Adds a long text in lines of at most kLineWidth, broken at spaces if it has any.
    void write_wrapped(std::string_view first_prefix, std::string_view text) {
        std::string remainder = sanitized(text);
        std::string prefix(first_prefix);
        const std::size_t width = kLineWidth - prefix.size();
        while (remainder.size() > width) {
            std::size_t end = remainder.rfind(' ', width);
            if (end == std::string::npos || end == 0) end = width;
            line("{}{}", prefix, remainder.substr(0, end));
            remainder.erase(0, remainder[end] == ' ' ? end + 1 : end);
            prefix.assign(prefix.size(), ' ');
        }
        line("{}{}", prefix, remainder);
    }

    std::string release() { return std::move(text_); }

  private:
    std::string text_;
};

void add_deviation(Text& out, const Report& report, std::string_view moves, const Deviation& deviation) {
    if (deviation.deviation_mm <= 0) return;
    out.line("{:<12}max deviation {:.4f} mm, at {}", moves, deviation.deviation_mm,
             location_text(report, deviation.location));
}

void add_blends(Text& out, const Report& report) {
    const Blends& blends = report.blends;
    if (!blends.measured || blends.count == 0) return;
    out.line("{:<12}{} corner{}", "rounded", blends.count, blends.count == 1 ? "" : "s");
    add_deviation(out, report, "  feed", blends.feed);
    add_deviation(out, report, "  rapid", blends.rapid);
}

void add_passes(Text& out, const Report& report) {
    if (!report.passes) return;
    out.line("{:<12}{}", "passes", to_text(*report.passes));
    out.line("{:<12}{}", "  jump at", location_text(report, report.passes->location, kLineWidth - 12));
}

void add_overrides(Text& out, const Report& report) {
    if (!report.overrides) return;
    constexpr std::size_t kMaxDisplayedOverrideChanges = 10;
    const std::vector<motion::OverrideChange>& changes = report.overrides->changes;
    for (std::size_t i = 0; i < std::min(changes.size(), kMaxDisplayedOverrideChanges); ++i) {
        const motion::Overrides& to = changes[i].to;
        out.line("{:<12}feed {:g} %, rapid {:g} %, spindle {:g} % from {:.3f} s on",
                 i == 0 ? "overrides" : "", to.feed * 100, to.rapid * 100, to.spindle * 100, changes[i].at_s);
    }
    if (changes.size() > kMaxDisplayedOverrideChanges)
        out.line("{:<12}and {} more changes", "", changes.size() - kMaxDisplayedOverrideChanges);
    for (const auto& [name, locked_s] : {std::pair{"feed", report.overrides->feed_locked_s},
                                         {"rapid", report.overrides->rapid_locked_s},
                                         {"spindle", report.overrides->spindle_locked_s}}) {
        if (locked_s > 0)
            out.line("{:<12}{:.3f} s moved without the {} override", "  locked", locked_s, name);
    }
}

void add_header(Text& out, const Report& report) {
    out.line("{:<12}{}", "program", truncated(report.source.program, kLineWidth - 12));
    if (!report.source.machine.empty()) {
        out.line("{:<12}{}", "machine", truncated(report.source.machine, kLineWidth - 12));
        const std::string controller =
            report.source.controller.empty() ? "a module" : report.source.controller;
        out.line("{:<12}{}", "controller", truncated(controller, kLineWidth - 12));
    }
    out.line("{:<12}{}", "status", name(report.status));
    if (report.alarm) {
        out.line("{:<12}{}", "  at", location_text(report, report.alarm->location, kLineWidth - 12));
        for (const OpenCall& call : report.alarm->calls) {
            out.line("{:<12}{} at {}", "  called", call.program,
                     location_text(report, call.location, kLineWidth - 12 - 4 - call.program.size()));
        }
        out.write_wrapped("  because   ", report.alarm->message);
    }
    out.line("{:<12}{:.3f} s  ({}){}", "cycle time", report.cycle_time_s, clock_text(report.cycle_time_s),
             report.times.interval ? fmt::format(", {:.3f} to {:.3f} s (95 %)", report.times.interval->min_s,
                                                 report.times.interval->max_s)
                                   : "");
    if (const auto valid_s = report.violations.valid_until_s())
        out.line("{:<12}not valid from {:.3f} s on, because the machine exceeds a limit there", "", *valid_s);
    add_passes(out, report);
    add_overrides(out, report);
    out.line("{:<12}{} executed, {} moves", "blocks", report.counts.blocks, report.counts.moves);
    add_blends(out, report);
}

void add_violations(Text& out, const Report& report) {
    const std::vector<Violation>& list = report.violations.list;
    if (list.empty()) return;
    out.blank();
    out.line("{:<12}{}", "violations", report.violations.count);
    for (std::size_t i = 0; i < std::min(list.size(), kMaxDisplayedViolations); ++i) {
        out.line("{:>12.3f} s  {}", list[i].t_s, location_text(report, list[i].location, kLineWidth - 16));
        out.write_wrapped(std::string(16, ' '), list[i].message);
    }
    if (report.violations.count > std::min(list.size(), kMaxDisplayedViolations)) out.line("{:>18}", "...");
    if (const std::string suggested_fix = suggested_fix_text(report.violations); !suggested_fix.empty())
        out.write_wrapped("", suggested_fix);
}

double percent(const Report& report, double time_s) {
    return report.cycle_time_s > 0 ? 100 * time_s / report.cycle_time_s : 0.0;
}

void add_times(Text& out, const Report& report) {
    out.blank();
    out.line("{:<10}{:>14}{:>10}{:>16}", "", "time (s)", "share", "length (mm)");
    const auto row = [&](std::string_view what, double time_s, double length_mm) {
        out.line("{:<10}{:>14.3f}{:>8.1f} %{:>16.3f}", what, time_s, percent(report, time_s), length_mm);
    };
    row("rapid", report.times.rapid_s, report.distances.rapid_mm);
    row("feed", report.times.feed_s, report.distances.feed_mm);
    out.line("{:<12}{:>12}{:>10}{:>16.3f}", fmt::format(" {} on", report.source.process), "", "",
             report.distances.process_on_mm);
    const auto remainder = [&](std::string_view what, double time_s) {
        out.line("{:<10}{:>14.3f}{:>8.1f} %", what, time_s, percent(report, time_s));
    };
    remainder("dwell", report.times.dwell_s);
    if (report.times.words_s > 0) remainder(" of words", report.times.words_s);
}

void add_explanation(Text& out, const Report& report) {
    if (!report.explanation) return;
    out.blank();
    out.line("{:<24}{:>12}{:>10}", "time by cause", "time (s)", "share");
    for (const LimitTime& limit : report.explanation->time_by_limit) {
        out.line("{:<24}{:>12.3f}{:>8.1f} %", limit.limited_by, limit.time_s, percent(report, limit.time_s));
    }
    if (!report.explanation->lower_bound_s) return;
    const double bound_s = *report.explanation->lower_bound_s;
    const std::string times =
        bound_s > 0 ? fmt::format("  (the program takes {:.2f} times this)", report.cycle_time_s / bound_s)
                    : "";
    out.line("lower bound  {:.3f} s{}", bound_s, times);
}

// Returns the axis's range as a bar, the part that was reached as '='.
std::string travel_bar(const AxisBounds& axis) {
    const double range = axis.limit_max - axis.limit_min;
    if (!(range > 0) || !std::isfinite(range)) return "";
    const auto cell = [&](double value) {
        const double share = std::clamp((value - axis.limit_min) / range, 0.0, 1.0);
        return std::min(static_cast<std::size_t>(share * kBarWidth), kBarWidth - 1);
    };
    std::string cells(kBarWidth, '.');
    const std::size_t first = cell(axis.min);
    std::fill_n(cells.begin() + static_cast<std::ptrdiff_t>(first), cell(axis.max) - first + 1, '=');
    const double percent = 100 * (axis.max - axis.min) / range;
    return fmt::format("[{}] {:>5.1f} %", cells, std::min(percent, 999.9));
}

// Returns at most eleven characters.
std::string bound_text(double value) {
    if (!std::isfinite(value)) return "none";
    return std::abs(value) < 1e6 ? text::fixed(value, 3) : fmt::format("{:.4g}", value);
}

void add_bounds(Text& out, const Report& report) {
    if (report.bounds.empty()) return;
    out.blank();
    out.line("{:<9}{:>12}{:>12}{:>13}{:>12}   {}", "axis", "min", "max", "limit min", "limit max",
             "used range");
    for (const AxisBounds& axis : report.bounds) {
        const bool outside = axis.min < axis.limit_min || axis.max > axis.limit_max;
        out.line("{} {:<7}{:>12}{:>12}{:>13}{:>12}   {}{}", axis.letter, axis.rotary ? "deg" : "mm",
                 bound_text(axis.min), bound_text(axis.max), bound_text(axis.limit_min),
                 bound_text(axis.limit_max), travel_bar(axis), outside ? " !" : "");
    }
}

void add_events(Text& out, const Report& report) {
    if (report.events.empty()) return;
    std::map<std::string, std::size_t> counts;
    for (const Event& event : report.events) ++counts[event.kind];
    std::string summary;
    for (const auto& [kind, count] : counts) {
        summary += fmt::format("{}{} {}", summary.empty() ? "" : ", ", count, kind);
    }
    out.blank();
    out.write_wrapped("events    ", summary);
    for (std::size_t i = 0; i < std::min(report.events.size(), kMaxDisplayedEvents); ++i) {
        const Event& event = report.events[i];
        const std::string what =
            sanitized(event.kind) + (event.detail.empty() ? "" : ": " + sanitized(event.detail));
        out.line("{:>12.3f} s  {:<30}  {}", event.t_s, location_text(report, event.location, 30),
                 what.substr(0, kLineWidth - 48));
    }
    if (report.events.size() > kMaxDisplayedEvents) out.line("{:>14}", "...");
}

void add_slowest(Text& out, const Report& report) {
    if (report.slowest.empty()) return;
    out.blank();
    out.line("{:<40}  {:<8}{:>12}{:>14}  {}", "slowest blocks", "kind", "time (s)", "length (mm)",
             "limited by");
    for (const SlowBlock& block : report.slowest) {
        out.line("{:<40}  {:<8}{:>12.3f}{:>14.3f}  {}", location_text(report, block.location),
                 name(block.kind), block.duration_s, block.length_mm, block.limited_by);
    }
}

std::string pair_text(std::string_view first, std::string_view second) {
    return fmt::format("{} and {}", truncated(first, 22), truncated(second, 22));
}

std::string count_text(std::size_t count, std::string_view one, std::string_view more) {
    return fmt::format("{} {}", count, count == 1 ? one : more);
}

void add_checked_bodies(Text& out, const CheckedBodies& bodies) {
    std::string of = count_text(bodies.machine_shapes, "body of the machine", "bodies of the machine");
    if (bodies.jets > 0) of += ", " + count_text(bodies.jets, "jet", "jets");
    if (bodies.objects > 0) of += ", " + count_text(bodies.objects, "object", "objects");
    std::string pairs = count_text(bodies.pairs, "pair", "pairs");
    if (bodies.allowed_pairs > 0)
        pairs += fmt::format(", except for {} that may be in contact", bodies.allowed_pairs);
    if (bodies.robot_pairs > 0)
        pairs += fmt::format("; {} with other robots", count_text(bodies.robot_pairs, "pair", "pairs"));
    out.line("{:<12}checked: {}; {}", "", of, pairs);
    if (bodies.replaced > 0)
        out.line("{:<12}replaces {} of the machine file", "", count_text(bodies.replaced, "shape", "shapes"));
}

void add_collisions(Text& out, const Report& report) {
    const std::vector<Collision>& collisions = report.cell->collisions;
    out.blank();
    out.line("{:<12}{} in {}", "collisions", collisions.empty() ? "none" : std::to_string(collisions.size()),
             truncated(report.cell->name, 60));
    add_checked_bodies(out, report.cell->checked_bodies);
    for (std::size_t i = 0; i < std::min(collisions.size(), kMaxDisplayedCollisions); ++i) {
        const Collision& collision = collisions[i];
        const auto [x, y, z] = collision.point_mm;
        out.line("{:>12.3f} s  {:<30}  {}", collision.t_s, location_text(report, collision.location, 30),
                 pair_text(collision.first, collision.second));
        out.line("{:>14}{:<30}  {} at x {} y {} z {}", "", "",
                 collision.penetrating ? "penetrating" : "touching", text::fixed(x, 3), text::fixed(y, 3),
                 text::fixed(z, 3));
    }
    if (collisions.size() > kMaxDisplayedCollisions) out.line("{:>14}", "...");
}

// Adds the smallest first.
void add_clearances(Text& out, const Report& report) {
    std::vector<const BlockClearance*> blocks;
    blocks.reserve(report.cell->clearances.size());
    for (const BlockClearance& block : report.cell->clearances) blocks.push_back(&block);
    if (blocks.empty()) return;
    std::stable_sort(blocks.begin(), blocks.end(), [](const BlockClearance* a, const BlockClearance* b) {
        return a->clearance_mm < b->clearance_mm;
    });
    out.line("{} blocks are nearer than {:.10g} mm, the nearest first:", blocks.size(),
             report.cell->clearance_mm);
    for (std::size_t i = 0; i < std::min(blocks.size(), kMaxDisplayedClearances); ++i) {
        out.line("{:>11.3f} mm  {:<30}  {}", blocks[i]->clearance_mm,
                 location_text(report, blocks[i]->location, 30),
                 pair_text(blocks[i]->first, blocks[i]->second));
    }
    if (blocks.size() > kMaxDisplayedClearances) out.line("{:>14}", "...");
}

void add_cell(Text& out, const Report& report) {
    if (!report.cell) return;
    add_collisions(out, report);
    add_clearances(out, report);
}

void add_zone_uses(Text& out, const Report& report) {
    if (report.concurrency.zone_uses.empty()) return;
    out.blank();
    out.line("{:<24}  {:<16}  {:<20}{:>12}{:>12}{:>12}", "zones", "process", "request at", "request (s)",
             "from (s)", "to (s)");
    const auto of = [](std::optional<double> t_s) { return t_s ? text::fixed(*t_s, 3) : std::string("-"); };
    for (std::size_t i = 0; i < std::min(report.concurrency.zone_uses.size(), kMaxDisplayedEvents); ++i) {
        const ZoneUse& use = report.concurrency.zone_uses[i];
        out.line("{:<24}  {:<16}  {:<20}{:>12.3f}{:>12}{:>12}", truncated(use.zone, 24),
                 truncated(use.process, 16), location_text(report, use.location, 20), use.requested_s,
                 of(use.from_s), of(use.to_s));
    }
    if (report.concurrency.zone_uses.size() > kMaxDisplayedEvents) out.line("{:>14}", "...");
}

void add_processes(Text& out, const Report& report) {
    if (report.concurrency.processes.empty()) return;
    out.blank();
    out.line("{:<24}  {:<16}  {:<8}{:>12}{:>12}{:>12}", "processes", "robot", "state", "start (s)", "end (s)",
             "idle (s)");
    for (const ProcessSummary& process : report.concurrency.processes) {
        out.line("{:<24}  {:<16}  {:<8}{:>12.3f}{:>12.3f}{:>12.3f}", truncated(process.name, 24),
                 truncated(process.robot, 16), process.state, process.start_s, process.end_s, process.idle_s);
    }
    add_zone_uses(out, report);
    if (report.concurrency.signals.empty()) return;
    out.blank();
    out.line("signals changed {} times", report.concurrency.signals.size());
    for (std::size_t i = 0; i < std::min(report.concurrency.signals.size(), kMaxDisplayedEvents); ++i) {
        const SignalChange& change = report.concurrency.signals[i];
        const std::string what = sanitized(fmt::format("{} = {}", change.signal, change.value));
        out.line("{:>12.3f} s  {:<30}  {}", change.t_s, location_text(report, change.location, 30),
                 what.substr(0, kLineWidth - 48));
    }
    if (report.concurrency.signals.size() > kMaxDisplayedEvents) out.line("{:>14}", "...");
}

void add_findings(Text& out, const Report& report) {
    const std::vector<ProcessFinding>& list = report.findings.list;
    if (list.empty()) return;
    out.blank();
    const std::size_t visible_count = std::min(list.size(), kMaxDisplayedWarnings);
    for (std::size_t i = 0; i < visible_count; ++i) {
        out.write_wrapped(
            "warning: ",
            fmt::format("{}: {}", location_text(report, list[i].location, kLineWidth / 2), list[i].message));
    }
    if (report.findings.count > visible_count)
        out.line("and {} more violations", report.findings.count - visible_count);
}

void add_warnings(Text& out, const Report& report) {
    if (report.messages.warnings.empty()) return;
    out.blank();
    const std::size_t visible_count = std::min(report.messages.warnings.size(), kMaxDisplayedWarnings);
    for (std::size_t i = 0; i < visible_count; ++i)
        out.write_wrapped("warning: ", report.messages.warnings[i]);
    if (report.messages.warnings.size() > visible_count)
        out.line("and {} more warnings", report.messages.warnings.size() - visible_count);
}

}  // namespace

std::string to_text(const Passes& passes) {
    return fmt::format("{} of the main program, which jumps back to {}; --passes runs more", passes.count,
                       passes.to_block ? fmt::format("N{}", *passes.to_block) : "its start");
}

std::string to_text(const Report& report) {
    Text out;
    add_header(out, report);
    add_violations(out, report);
    if (!report.source.machine.empty()) add_times(out, report);
    add_explanation(out, report);
    add_bounds(out, report);
    add_cell(out, report);
    if (report.drives.efforts) out.lines(efforts_text(report));
    if (report.drives.following) out.lines(following_text(report));
    add_slowest(out, report);
    add_events(out, report);
    add_processes(out, report);
    add_findings(out, report);
    add_warnings(out, report);
    return out.release();
}

}  // namespace gsim::simulation
