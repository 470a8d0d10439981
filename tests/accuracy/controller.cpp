#include "tests/accuracy/controller.h"

#include <algorithm>
#include <cmath>

namespace gsim::accuracy {

namespace {

// Recorded times have whole ms: an error of just that many shall not fail for its binary digits.
constexpr double kRounding_s = 1e-9;

std::string with_dashes(std::string name) {
    std::replace(name.begin(), name.end(), '_', '-');
    return name;
}

}  // namespace

std::string machine_of_grblhal(const TableRow& row) {
    return "grblhal-" + with_dashes(row.at("machine"));
}

std::string machine_of_klipper(const TableRow& row) {
    return "klipper-" + with_dashes(row.at("machine"));
}

std::string never_left_out(const TableRow&) {
    return {};
}

bool Tolerance::holds(double error_s, double recorded_s) const {
    return std::abs(error_s) <= std::max(percent / 100 * recorded_s, least_s) + kRounding_s;
}

}  // namespace gsim::accuracy
