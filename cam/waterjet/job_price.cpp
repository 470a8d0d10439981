#include "cam/waterjet/job_price.h"

#include "base/units.h"

namespace gsim::waterjet {

namespace {

constexpr double kSecondsPerHour = 3600;

void add_times(JobPrice& price, const CuttingPlan& plan, const JobQuantities& job) {
    price.cut_length_mm = job.cut_length_mm;
    price.pierces = job.pierces;
    price.cut_time_s =
        job.cut_time_s.value_or(job.cut_length_mm / plan.cutting_speed_mm_min * kSecondsPerMinute);
    price.pierce_time_s =
        static_cast<double>(job.pierces - job.dynamic_pierces) * plan.pierce_s +
        static_cast<double>(job.dynamic_pierces) * plan.dynamic_pierce_s.value_or(plan.pierce_s);
    price.jet_time_s = price.cut_time_s + price.pierce_time_s;
    price.machine_time_s = price.jet_time_s + job.other_time_s;
}

void add_consumption(JobPrice& price, const CuttingPlan& plan, const PriceRule& prices) {
    const double jet_time_min = price.jet_time_s / kSecondsPerMinute;
    const double jet_time_h = price.jet_time_s / kSecondsPerHour;
    price.water_l = plan.water_l_min * jet_time_min;
    price.abrasive_kg = plan.jet.abrasive_g_min * jet_time_min / kGramsPerKg;
    price.recycled_abrasive_kg = prices.recycled_share * price.abrasive_kg;
    price.orifice_wear = jet_time_h / prices.orifice_life_h;
    price.mixing_tube_wear = jet_time_h / prices.mixing_tube_life_h;
}

}  // namespace

JobPrice price_job(const CuttingPlan& plan, const PriceRule& prices, const JobQuantities& job) {
    JobPrice price;
    add_times(price, plan, job);
    add_consumption(price, plan, prices);
    price.items = {
        {"machine", price.machine_time_s / kSecondsPerHour, "h", prices.machine_per_h},
        {"water", price.water_l / 1000, "m3", prices.water_per_m3},
        {"new abrasive", price.abrasive_kg - price.recycled_abrasive_kg, "kg", prices.abrasive_per_kg},
        {"recycled abrasive", price.recycled_abrasive_kg, "kg", prices.recycled_per_kg},
        {"orifice", price.orifice_wear, "pieces", prices.orifice_price},
        {"mixing tube", price.mixing_tube_wear, "pieces", prices.mixing_tube_price},
    };
    for (const PriceItem& item : price.items) price.total += item.cost();
    return price;
}

}  // namespace gsim::waterjet
