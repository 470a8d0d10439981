#pragma once

#include <optional>
#include <string>

#include "cam/waterjet/cutting_plan.h"
#include "cam/waterjet/job_price.h"

namespace gsim::waterjet {

/// What accuracy takes of the time of cutting.
struct AccuracyTimes {
    double slower_s = 0;                                   ///< In curves and corners.
    std::optional<double> straightening_s = std::nullopt;  ///< Leaning against taper; none: that is not done.
};

/// What a report is of.
struct JobReport {
    const CuttingPlan& plan;
    const JobPrice& price;
    AccuracyTimes accuracy;
    const std::string& currency;
};

/// A table for people (docs/waterjet.md), with each value's source. Ends with a line break.
std::string job_report_text(const JobReport& report);

}  // namespace gsim::waterjet
