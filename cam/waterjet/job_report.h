#pragma once

#include <optional>
#include <string>

#include "cam/waterjet/cutting_plan.h"
#include "cam/waterjet/job_price.h"

namespace gsim::waterjet {

/// Share of the cutting time that accuracy requires.
struct AccuracyTimes {
    double slowdown_s = 0;                                      ///< In curves and corners.
    std::optional<double> taper_compensation_s = std::nullopt;  ///< Taper compensation; none: it is not done.
};

/// The contents of a report.
struct JobReport {
    const CuttingPlan& plan;
    const JobPrice& price;
    AccuracyTimes accuracy;
    const std::string& currency;
};

/// Returns a table for people (docs/waterjet.md), with each value's source. It ends with a line break.
std::string job_report_text(const JobReport& report);

}  // namespace gsim::waterjet
