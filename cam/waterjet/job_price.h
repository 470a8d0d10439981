#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "cam/waterjet/cutting_plan.h"

namespace gsim::waterjet {

/// Quantities of a job.
struct JobQuantities {
    double cut_length_mm = 0;
    std::size_t pierces = 0;
    std::size_t dynamic_pierces = 0;  ///< Part of pierces.
    /// If missing: the length at the cutting speed of straight lines.
    std::optional<double> cut_time_s = std::nullopt;
    double other_time_s = 0;  ///< Machine time with the jet off: rapid moves, dwells.
};

/// One line of the bill.
struct PriceItem {
    std::string_view name;
    double quantity = 0;
    std::string_view unit;
    double unit_price = 0;

    double cost() const { return quantity * unit_price; }
};

/// Consumption and price of a job.
struct JobPrice {
    double cut_length_mm = 0;
    std::size_t pierces = 0;
    double cut_time_s = 0;
    double pierce_time_s = 0;
    double jet_time_s = 0;      ///< Cutting and piercing: water and abrasive flow.
    double machine_time_s = 0;  ///< And with the jet off.
    double water_l = 0;
    double abrasive_kg = 0;           ///< Through the nozzle; new and recycled.
    double recycled_abrasive_kg = 0;  ///< Part of it.
    double orifice_wear = 0;          ///< Share of an orifice that is used up.
    double mixing_tube_wear = 0;      ///< Share of a mixing tube that is used up.
    std::vector<PriceItem> items;
    double total = 0;
};

/// Returns the price of a job that is cut by the plan. Quantities must be finite and >= 0.
JobPrice price_job(const CuttingPlan& plan, const PriceRule& prices, const JobQuantities& job);

}  // namespace gsim::waterjet
