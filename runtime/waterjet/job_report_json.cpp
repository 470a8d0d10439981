#include <cmath>

#include <nlohmann/json.hpp>

#include "runtime/waterjet/job_report.h"

namespace gsim::waterjet {

namespace {

using Json = nlohmann::ordered_json;

// What does not depend on the last bits.
Json number(double value) {
    constexpr double kGrains = 1e9;
    if (!std::isfinite(value)) return nullptr;
    const double rounded = std::round(value * kGrains) / kGrains;
    return std::isfinite(rounded) ? rounded + 0.0 : value;
}

Json values(const CuttingPlan& plan) {
    Json list = Json::array();
    for (const SettledValue& value : plan.values) {
        list.push_back({{"name", value.name},
                        {"value", number(value.value)},
                        {"unit", value.unit},
                        {"origin", origin_name(value.origin)},
                        {"basis", value.basis}});
    }
    return list;
}

Json quantities(const JobPrice& price) {
    return {{"cut_length_mm", number(price.cut_length_mm)},
            {"pierces", price.pierces},
            {"cut_time_s", number(price.cut_time_s)},
            {"pierce_time_s", number(price.pierce_time_s)},
            {"jet_time_s", number(price.jet_time_s)},
            {"machine_time_s", number(price.machine_time_s)},
            {"water_l", number(price.water_l)},
            {"abrasive_kg", number(price.abrasive_kg)},
            {"recycled_abrasive_kg", number(price.recycled_abrasive_kg)},
            {"orifice_wear", number(price.orifice_wear)},
            {"mixing_tube_wear", number(price.mixing_tube_wear)}};
}

Json bill(const JobReport& report) {
    Json list = Json::array();
    for (const PriceItem& item : report.price.items) {
        list.push_back({{"name", item.name},
                        {"quantity", number(item.quantity)},
                        {"unit", item.unit},
                        {"unit_price", number(item.unit_price)},
                        {"cost", number(item.cost())}});
    }
    return {{"currency", report.currency}, {"items", list}, {"total", number(report.price.total)}};
}

}  // namespace

std::string job_report_json(const JobReport& report) {
    const Json json = {{"material", report.plan.material}, {"thickness_mm", number(report.plan.thickness_mm)},
                       {"values", values(report.plan)},    {"warnings", report.plan.warnings},
                       {"job", quantities(report.price)},  {"price", bill(report)}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace gsim::waterjet
