#include "tests/accuracy/controller.h"

#include <algorithm>
#include <cmath>

namespace gsim::accuracy {

namespace {

// Recorded times are full ms: a deviation of exactly the permitted ms must not fail because of binary
// rounding.
constexpr double kRounding_s = 1e-9;

std::string with_dashes(std::string name) {
    std::replace(name.begin(), name.end(), '_', '-');
    return name;
}

}  // namespace

std::string text_in(const TableRow& row, std::string_view column) {
    const auto found = row.find(column);
    return found == row.end() ? std::string() : found->second;
}

std::string machine_of_grblhal(const TableRow& row) {
    return "grblhal-" + with_dashes(row.at("machine"));
}

std::string machine_of_klipper(const TableRow& row) {
    return "klipper-" + with_dashes(row.at("machine"));
}

std::string planner_of_linuxcnc_2_10(const TableRow& row) {
    const std::string jerk = text_in(row, "jerk");
    if (text_in(row, "planner_type") != "1") return "pt0";
    return "pt1-j" + (jerk == "1000000000" ? "def" : jerk);
}

std::string machine_of_linuxcnc_2_10(const TableRow& row) {
    return "linuxcnc-2.10-" + with_dashes(text_in(row, "machine")) + "-" + planner_of_linuxcnc_2_10(row);
}

std::string fault_of_linuxcnc_2_10(const TableRow& row) {
    const std::string flag = text_in(row, "flag");
    for (const std::string error : {"acc_step", "trapezoidal_fallback"})
        if (flag.find(error) != std::string::npos) return error;
    return {};
}

bool Tolerance::is_within(double error_s, double recorded_s) const {
    return std::abs(error_s) <= std::max(percent / 100 * recorded_s, min_s) + kRounding_s;
}

}  // namespace gsim::accuracy
