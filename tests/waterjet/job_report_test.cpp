#include "runtime/waterjet/job_report.h"

#include <cmath>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sample.h"

namespace gsim::waterjet::job_report_test {
namespace {

using testing::HasSubstr;

struct Reported {
    CuttingPlan plan = sample_plan("HY-80 steel", 25, 3);
    JobPrice price = price_job(plan, sample_materials().prices, {.cut_length_mm = 1234.5, .pierces = 3});
    std::string currency = sample_materials().prices.currency;

    JobReport report() const { return {plan, price, currency}; }
};

TEST(JobReport, TextSaysFromWhatAValueIs) {
    const Reported job;
    const std::string text = job_report_text(job.report());
    EXPECT_THAT(text, HasSubstr("Cutting HY-80 steel, 25 mm\n"));
    EXPECT_THAT(text, HasSubstr("inferred from mild steel (assumed"));
    EXPECT_THAT(text, HasSubstr("inferred from 3 times the orifice"));
    EXPECT_THAT(text, HasSubstr("EUR\n"));
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 110U) << line;
}

TEST(JobReport, JsonHasEveryValueAndItsItemsAddUp) {
    const Reported job;
    const auto json = nlohmann::json::parse(job_report_json(job.report()));
    EXPECT_EQ(json["values"].size(), job.plan.values.size());
    for (const auto& value : json["values"]) {
        const bool is_inferred = value["origin"] == "inferred";
        EXPECT_TRUE(!is_inferred || !value["basis"].get<std::string>().empty()) << value["name"];
    }
    double sum = 0;
    for (const auto& item : json["price"]["items"]) sum += item["cost"].get<double>();
    EXPECT_NEAR(json["price"]["total"].get<double>(), sum, 1e-6);
    EXPECT_EQ(json["job"]["pierces"], 3);
    EXPECT_NEAR(json["job"]["cut_length_mm"].get<double>(), 1234.5, 1e-9);
}

}  // namespace
}  // namespace gsim::waterjet::job_report_test
