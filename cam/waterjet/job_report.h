#pragma once

#include <string>

#include "cam/waterjet/cutting_plan.h"
#include "cam/waterjet/job_price.h"

namespace gsim::waterjet {

/// What a report is of.
struct JobReport {
    const CuttingPlan& plan;
    const JobPrice& price;
    const std::string& currency;
};

/// A table for people (docs/cutting.md), with each value's source. Ends with a line break.
std::string job_report_text(const JobReport& report);

}  // namespace gsim::waterjet
