#include "cam/waterjet/job_report.h"

#include <cmath>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sample.h"

namespace gsim::waterjet::job_report_test {
namespace {

using testing::HasSubstr;

struct Reported {
    CuttingPlan plan = sample_plan("HY-80 steel", 25, 3);
    JobPrice price = price_job(plan, sample_materials().prices, {.cut_length_mm = 1234.5, .pierces = 3});
    AccuracyTimes accuracy = {};
    std::string currency = sample_materials().prices.currency;

    JobReport report() const { return {plan, price, accuracy, currency}; }
};

TEST(JobReport, TextStatesOriginOfValues) {
    const Reported job;
    const std::string text = job_report_text(job.report());
    EXPECT_THAT(text, HasSubstr("Cutting HY-80 steel, 25 mm\n"));
    EXPECT_THAT(text, HasSubstr("inferred from mild steel (assumed"));
    EXPECT_THAT(text, HasSubstr("inferred from 3 times the orifice"));
    EXPECT_THAT(text, HasSubstr("EUR\n"));
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 110U) << line;
}

}  // namespace
}  // namespace gsim::waterjet::job_report_test
