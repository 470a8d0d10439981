#include <cmath>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/units.h"
#include "cam/waterjet/job_report.h"

namespace gsim::waterjet {

namespace {

std::string clock_text(double time_s) {
    constexpr double kMaxShown_s = 1e9;
    if (!(time_s < kMaxShown_s)) return "-";
    const auto total_s = std::llround(time_s);
    return fmt::format("{}:{:02}:{:02}", total_s / 3600, total_s / 60 % 60, total_s % 60);
}

std::string source_text(const ResolvedValue& value) {
    switch (value.origin) {
        case Origin::from_request: return "given";
        case Origin::from_file:
            return value.basis.empty() ? "the file" : fmt::format("the file: {}", value.basis);
        case Origin::inferred: return fmt::format("inferred from {}", value.basis);
    }
    return {};
}

void append_plan(std::string& out, const CuttingPlan& plan) {
    text::append_format(out, "Cutting {}, {} mm\n", plan.material, plan.thickness_mm);
    for (const ResolvedValue& value : plan.values) {
        text::append_format(out, "  {:<18}{:>12.5g} {:<7}{}\n", value.name, value.value, value.unit,
                            source_text(value));
    }
    for (const std::string& warning : plan.warnings) text::append_format(out, "  warning: {}\n", warning);
}

void append_quantities(std::string& out, const JobPrice& price) {
    text::append_format(out, "\nJob\n  {:<18}{:>12.1f} mm\n", "cut length", price.cut_length_mm);
    text::append_format(out, "  {:<18}{:>12}\n", "pierces", price.pierces);
    text::append_format(out, "  {:<18}{:>12} of which piercing {}\n", "jet time",
                        clock_text(price.jet_time_s), clock_text(price.pierce_time_s));
    text::append_format(out, "  {:<18}{:>12}\n", "machine time", clock_text(price.machine_time_s));
    text::append_format(out, "  {:<18}{:>12.1f} l\n", "water", price.water_l);
    text::append_format(out, "  {:<18}{:>12.2f} kg, of which recycled {:.2f} kg\n", "abrasive",
                        price.abrasive_kg, price.recycled_abrasive_kg);
}

/// Returns a time with the jet on, and the flow during it.
std::string jet_text(const CuttingPlan& plan, double time_s) {
    return fmt::format("{:>12.1f} s   {:.3f} kg of abrasive", time_s,
                       time_s / kSecondsPerMinute * plan.jet.abrasive_g_min / kGramsPerKg);
}

void append_accuracy(std::string& out, const JobReport& report) {
    const CuttingPlan& plan = report.plan;
    text::append_format(out, "\nTime for accuracy\n  {:<18}{}\n", "curves, corners",
                        jet_text(plan, report.accuracy.slowdown_s));
    if (report.accuracy.taper_compensation_s) {
        text::append_format(out, "  {:<18}{}, tilted {:.3g} deg at the cutting speed\n", "straight walls",
                            jet_text(plan, *report.accuracy.taper_compensation_s),
                            taper_compensation_deg(plan, plan.cutting_speed_mm_min));
    } else {
        text::append_format(
            out, "  {:<18}{:>12} s   not requested: walls deviate by {:.3g} mm (--taper-compensation)\n",
            "straight walls", 0, plan.taper_mm);
    }
    if (plan.dynamic_pierce_s) {
        text::append_format(out, "  {:<18}{}\n", "dynamic pierces",
                            jet_text(plan, report.price.pierce_time_s -
                                               plan.pierce_s * static_cast<double>(report.price.pierces)));
    }
}

void append_price_items(std::string& out, const JobReport& report) {
    text::append_format(out, "\nPrice\n");
    for (const PriceItem& item : report.price.items) {
        text::append_format(out, "  {:<18}{:>12.4f} {:<7}at {:>9.2f}{:>12.2f}\n", item.name, item.quantity,
                            item.unit, item.unit_price, item.cost());
    }
    text::append_format(out, "  {:<50}{:>12.2f} {}\n", "total", report.price.total, report.currency);
}

}  // namespace

std::string job_report_text(const JobReport& report) {
    std::string out;
    append_plan(out, report.plan);
    append_quantities(out, report.price);
    append_accuracy(out, report);
    append_price_items(out, report);
    return out;
}

}  // namespace gsim::waterjet
