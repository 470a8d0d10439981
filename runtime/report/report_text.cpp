#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "base/text/number.h"
#include "runtime/report/report.h"
#include "runtime/report/report_efforts.h"
#include "runtime/report/report_following.h"
#include "runtime/report/report_words.h"

namespace gsim::simulation {

namespace {

constexpr std::size_t kBarWidth = 24;
constexpr std::size_t kShownEvents = 8;
constexpr std::size_t kShownWarnings = 20;
constexpr std::size_t kShownCollisions = 20;
constexpr std::size_t kShownClearances = 8;
constexpr std::size_t kShownViolations = 20;

std::string clock_text(double time_s) {
    if (!(time_s >= 0 && time_s < 1e9)) return "-";
    const auto whole = std::llround(time_s);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
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
    void wrapped(std::string_view first_prefix, std::string_view text) {
        std::string rest = clean(text);
        std::string prefix(first_prefix);
        const std::size_t width = kLineWidth - prefix.size();
        while (rest.size() > width) {
            std::size_t end = rest.rfind(' ', width);
            if (end == std::string::npos || end == 0) end = width;
            line("{}{}", prefix, rest.substr(0, end));
            rest.erase(0, rest[end] == ' ' ? end + 1 : end);
            prefix.assign(prefix.size(), ' ');
        }
        line("{}{}", prefix, rest);
    }

    std::string take() { return std::move(text_); }

  private:
    std::string text_;
};

void add_deviation(Text& out, const Report& report, std::string_view moves, const Deviation& deviation) {
    if (deviation.deviation_mm <= 0) return;
    out.line("{:<12}at most {:.4f} mm off, at {}", moves, deviation.deviation_mm,
             place_text(report, deviation.place));
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
    out.line("{:<12}{}", "  back at", place_text(report, report.passes->place, kLineWidth - 12));
}

void add_overrides(Text& out, const Report& report) {
    if (!report.overrides) return;
    constexpr std::size_t kListed = 10;
    const std::vector<motion::OverrideChange>& changes = report.overrides->changes;
    for (std::size_t i = 0; i < std::min(changes.size(), kListed); ++i) {
        const motion::Overrides& to = changes[i].to;
        out.line("{:<12}feed {:g} %, rapid {:g} %, spindle {:g} % from {:.3f} s on",
                 i == 0 ? "overrides" : "", to.feed * 100, to.rapid * 100, to.spindle * 100, changes[i].at_s);
    }
    if (changes.size() > kListed) out.line("{:<12}and {} more changes", "", changes.size() - kListed);
    for (const auto& [name, locked_s] : {std::pair{"feed", report.overrides->feed_locked_s},
                                         {"rapid", report.overrides->rapid_locked_s},
                                         {"spindle", report.overrides->spindle_locked_s}}) {
        if (locked_s > 0)
            out.line("{:<12}{:.3f} s moved without the {} override", "  locked", locked_s, name);
    }
}

void add_head(Text& out, const Report& report) {
    out.line("{:<12}{}", "program", shortened(report.program, kLineWidth - 12));
    if (!report.machine.empty()) {
        out.line("{:<12}{}", "machine", shortened(report.machine, kLineWidth - 12));
        const std::string controller = report.controller.empty() ? "a module" : report.controller;
        out.line("{:<12}{}", "controller", shortened(controller, kLineWidth - 12));
    }
    out.line("{:<12}{}", "status", name(report.status));
    if (report.alarm) {
        out.line("{:<12}{}", "  at", place_text(report, report.alarm->place, kLineWidth - 12));
        for (const OpenCall& call : report.alarm->calls) {
            out.line("{:<12}{} at {}", "  called", call.program,
                     place_text(report, call.place, kLineWidth - 12 - 4 - call.program.size()));
        }
        out.wrapped("  because   ", report.alarm->message);
    }
    out.line("{:<12}{:.3f} s  ({}){}", "cycle time", report.cycle_time_s, clock_text(report.cycle_time_s),
             report.interval ? fmt::format(", {:.3f} to {:.3f} s (95 %)", report.interval->least_s,
                                           report.interval->most_s)
                             : "");
    if (const auto valid_s = report.violations.valid_until_s())
        out.line("{:<12}not valid from {:.3f} s on, where the machine is first past a limit", "", *valid_s);
    add_passes(out, report);
    add_overrides(out, report);
    out.line("{:<12}{} executed, {} moves", "blocks", report.blocks, report.moves);
    add_blends(out, report);
}

void add_violations(Text& out, const Report& report) {
    const std::vector<Violation>& list = report.violations.list;
    if (list.empty()) return;
    out.blank();
    out.line("{:<12}{}", "violations", report.violations.count);
    for (std::size_t i = 0; i < std::min(list.size(), kShownViolations); ++i) {
        out.line("{:>12.3f} s  {}", list[i].t_s, place_text(report, list[i].place, kLineWidth - 16));
        out.wrapped(std::string(16, ' '), list[i].message);
    }
    if (report.violations.count > std::min(list.size(), kShownViolations)) out.line("{:>18}", "...");
    if (const std::string remedy = remedy_text(report.violations); !remedy.empty()) out.wrapped("", remedy);
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
    row("rapid", report.rapid_s, report.rapid_mm);
    row("feed", report.feed_s, report.feed_mm);
    out.line("{:<12}{:>12}{:>10}{:>16.3f}", fmt::format(" {} on", report.process), "", "", report.jet_on_mm);
    const auto rest = [&](std::string_view what, double time_s) {
        out.line("{:<10}{:>14.3f}{:>8.1f} %", what, time_s, percent(report, time_s));
    };
    rest("dwell", report.dwell_s);
    if (report.words_s > 0) rest(" of words", report.words_s);
}

void add_explanation(Text& out, const Report& report) {
    if (!report.explanation) return;
    out.blank();
    out.line("{:<24}{:>12}{:>10}", "where the time goes", "time (s)", "share");
    for (const LimitTime& limit : report.explanation->time_by_limit) {
        out.line("{:<24}{:>12.3f}{:>8.1f} %", limit.limited_by, limit.time_s, percent(report, limit.time_s));
    }
    if (!report.explanation->lower_bound_s) return;
    const double bound_s = *report.explanation->lower_bound_s;
    const std::string times =
        bound_s > 0 ? fmt::format("  (the program takes {:.2f} times as long)", report.cycle_time_s / bound_s)
                    : "";
    out.line("lower bound  {:.3f} s{}", bound_s, times);
}

// Returns the axis's range as a bar, the part that was reached as '='.
std::string bar(const AxisBounds& axis) {
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
             "reached of range");
    for (const AxisBounds& axis : report.bounds) {
        const bool outside = axis.min < axis.limit_min || axis.max > axis.limit_max;
        out.line("{} {:<7}{:>12}{:>12}{:>13}{:>12}   {}{}", axis.letter, axis.rotary ? "deg" : "mm",
                 bound_text(axis.min), bound_text(axis.max), bound_text(axis.limit_min),
                 bound_text(axis.limit_max), bar(axis), outside ? " !" : "");
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
    out.wrapped("events    ", summary);
    for (std::size_t i = 0; i < std::min(report.events.size(), kShownEvents); ++i) {
        const Event& event = report.events[i];
        const std::string what = clean(event.kind) + (event.detail.empty() ? "" : ": " + clean(event.detail));
        out.line("{:>12.3f} s  {:<30}  {}", event.t_s, place_text(report, event.place, 30),
                 what.substr(0, kLineWidth - 48));
    }
    if (report.events.size() > kShownEvents) out.line("{:>14}", "...");
}

void add_slowest(Text& out, const Report& report) {
    if (report.slowest.empty()) return;
    out.blank();
    out.line("{:<40}  {:<8}{:>12}{:>14}  {}", "slowest blocks", "kind", "time (s)", "length (mm)",
             "limited by");
    for (const SlowBlock& block : report.slowest) {
        out.line("{:<40}  {:<8}{:>12.3f}{:>14.3f}  {}", place_text(report, block.place), name(block.kind),
                 block.duration_s, block.length_mm, block.limited_by);
    }
}

std::string pair_text(std::string_view first, std::string_view second) {
    return fmt::format("{} and {}", shortened(first, 22), shortened(second, 22));
}

std::string counted(std::size_t count, std::string_view one, std::string_view more) {
    return fmt::format("{} {}", count, count == 1 ? one : more);
}

void add_looked_at(Text& out, const LookedAt& looked) {
    std::string of = counted(looked.of_machine, "body of the machine", "bodies of the machine");
    if (looked.jets > 0) of += ", " + counted(looked.jets, "jet", "jets");
    if (looked.objects > 0) of += ", " + counted(looked.objects, "object", "objects");
    std::string pairs = counted(looked.pairs, "pair", "pairs");
    if (looked.may_touch > 0) pairs += fmt::format(", but for {} that may touch", looked.may_touch);
    if (looked.with_robots > 0)
        pairs += fmt::format("; {} with other robots", counted(looked.with_robots, "pair", "pairs"));
    out.line("{:<12}looked at: {}; {}", "", of, pairs);
    if (looked.replaced > 0)
        out.line("{:<12}in place of {} of the machine file", "", counted(looked.replaced, "shape", "shapes"));
}

void add_collisions(Text& out, const Report& report) {
    const std::vector<Collision>& collisions = report.cell->collisions;
    out.blank();
    out.line("{:<12}{} in {}", "collisions", collisions.empty() ? "none" : std::to_string(collisions.size()),
             shortened(report.cell->name, 60));
    add_looked_at(out, report.cell->looked_at);
    for (std::size_t i = 0; i < std::min(collisions.size(), kShownCollisions); ++i) {
        const Collision& collision = collisions[i];
        const auto [x, y, z] = collision.point_mm;
        out.line("{:>12.3f} s  {:<30}  {}", collision.t_s, place_text(report, collision.place, 30),
                 pair_text(collision.first, collision.second));
        out.line("{:>14}{:<30}  {} at x {} y {} z {}", "", "",
                 collision.penetrating ? "penetrating" : "touching", text::fixed(x, 3), text::fixed(y, 3),
                 text::fixed(z, 3));
    }
    if (collisions.size() > kShownCollisions) out.line("{:>14}", "...");
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
    out.line("{} blocks come nearer than {:.10g} mm, the nearest first:", blocks.size(),
             report.cell->clearance_mm);
    for (std::size_t i = 0; i < std::min(blocks.size(), kShownClearances); ++i) {
        out.line("{:>11.3f} mm  {:<30}  {}", blocks[i]->clearance_mm,
                 place_text(report, blocks[i]->place, 30), pair_text(blocks[i]->first, blocks[i]->second));
    }
    if (blocks.size() > kShownClearances) out.line("{:>14}", "...");
}

void add_cell(Text& out, const Report& report) {
    if (!report.cell) return;
    add_collisions(out, report);
    add_clearances(out, report);
}

void add_zone_uses(Text& out, const Report& report) {
    if (report.zone_uses.empty()) return;
    out.blank();
    out.line("{:<24}  {:<16}  {:<20}{:>12}{:>12}{:>12}", "zones", "process", "asked at", "asked (s)",
             "from (s)", "to (s)");
    const auto of = [](std::optional<double> t_s) { return t_s ? text::fixed(*t_s, 3) : std::string("-"); };
    for (std::size_t i = 0; i < std::min(report.zone_uses.size(), kShownEvents); ++i) {
        const ZoneUse& use = report.zone_uses[i];
        out.line("{:<24}  {:<16}  {:<20}{:>12.3f}{:>12}{:>12}", shortened(use.zone, 24),
                 shortened(use.process, 16), place_text(report, use.place, 20), use.asked_s, of(use.from_s),
                 of(use.to_s));
    }
    if (report.zone_uses.size() > kShownEvents) out.line("{:>14}", "...");
}

void add_processes(Text& out, const Report& report) {
    if (report.processes.empty()) return;
    out.blank();
    out.line("{:<24}  {:<16}  {:<8}{:>12}{:>12}{:>12}", "processes", "robot", "state", "start (s)", "end (s)",
             "idle (s)");
    for (const ProcessSummary& process : report.processes) {
        out.line("{:<24}  {:<16}  {:<8}{:>12.3f}{:>12.3f}{:>12.3f}", shortened(process.name, 24),
                 shortened(process.robot, 16), process.state, process.start_s, process.end_s, process.idle_s);
    }
    add_zone_uses(out, report);
    if (report.signals.empty()) return;
    out.blank();
    out.line("signals changed {} times", report.signals.size());
    for (std::size_t i = 0; i < std::min(report.signals.size(), kShownEvents); ++i) {
        const SignalChange& change = report.signals[i];
        const std::string what = clean(fmt::format("{} = {}", change.signal, change.value));
        out.line("{:>12.3f} s  {:<30}  {}", change.t_s, place_text(report, change.place, 30),
                 what.substr(0, kLineWidth - 48));
    }
    if (report.signals.size() > kShownEvents) out.line("{:>14}", "...");
}

void add_findings(Text& out, const Report& report) {
    const std::vector<ProcessFinding>& list = report.findings.list;
    if (list.empty()) return;
    out.blank();
    const std::size_t shown = std::min(list.size(), kShownWarnings);
    for (std::size_t i = 0; i < shown; ++i) {
        out.wrapped("warning: ", fmt::format("{}: {}", place_text(report, list[i].place, kLineWidth / 2),
                                             list[i].message));
    }
    if (report.findings.count > shown) out.line("and {} more findings", report.findings.count - shown);
}

void add_warnings(Text& out, const Report& report) {
    if (report.warnings.empty()) return;
    out.blank();
    const std::size_t shown = std::min(report.warnings.size(), kShownWarnings);
    for (std::size_t i = 0; i < shown; ++i) out.wrapped("warning: ", report.warnings[i]);
    if (report.warnings.size() > shown) out.line("and {} more warnings", report.warnings.size() - shown);
}

}  // namespace

std::string to_text(const Passes& passes) {
    return fmt::format("{} of the main program, which leads back to {}; --passes runs more", passes.count,
                       passes.to_block ? fmt::format("N{}", *passes.to_block) : "its start");
}

std::string to_text(const Report& report) {
    Text out;
    add_head(out, report);
    add_violations(out, report);
    if (!report.machine.empty()) add_times(out, report);
    add_explanation(out, report);
    add_bounds(out, report);
    add_cell(out, report);
    if (report.efforts) out.lines(efforts_text(report));
    if (report.following) out.lines(following_text(report));
    add_slowest(out, report);
    add_events(out, report);
    add_processes(out, report);
    add_findings(out, report);
    add_warnings(out, report);
    return out.take();
}

}  // namespace gsim::simulation
