#include "machine/file/calibration_section.h"

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "base/dense/symmetric.h"
#include "machine/file/number_list.h"
#include "machine/model/machine_parameter.h"

namespace gsim::machine {

namespace {

using base::FirstError;
using base::NumberRule;
using base::TomlSection;
using base::TomlWriter;

constexpr std::array<std::string_view, 2> kCalibrationKeys{"runs", "residual_percent"};
constexpr std::array<std::string_view, 3> kCalibratedKeys{"of", "key", "covariance_percent2"};

/// Returns the key of a parameter, which may also be given by its name of before.
std::string read_key(FirstError& error, TomlSection& section, std::string_view of) {
    std::string key = section.text("key");
    const auto new_name = base::renamed_key(fmt::format("[{}]", of), key);
    if (!new_name) return key;
    error.warn(section.where("key"), base::deprecated_key_text(key, *new_name));
    return std::string(*new_name);
}

void read_calibrated(FirstError& error, const toml::table& table, std::size_t count, const Machine& machine,
                     Calibration& calibration) {
    TomlSection section(error, table, "[[calibrated]]", kCalibratedKeys);
    CalibratedParameter parameter_id;
    parameter_id.of = section.text("of");
    parameter_id.key = read_key(error, section, parameter_id.of);
    section.require("covariance_percent2");
    const auto row = read_numbers(section, table, "covariance_percent2",
                                  "a list, one number for each [[calibrated]]", {count});
    if (section.has("of") && section.has("key") && !parameter_value(parameter_id, machine)) {
        section.fail("key", fmt::format("{} cannot be calibrated: 'of' must be axis letters, \"path\", "
                                        "\"controller\" or \"times\", and 'key' one of their keys",
                                        parameter_name(parameter_id)));
    }
    calibration.parameters.push_back(std::move(parameter_id));
    calibration.covariance_percent2.push_back(row.value_or(std::vector<double>(count)));
}

/// A covariance is symmetric, and no combination of the parameters has a negative spread.
bool is_covariance(const std::vector<std::vector<double>>& rows) {
    const auto count = static_cast<Eigen::Index>(rows.size());
    Eigen::MatrixXd matrix(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index k = 0; k < count; ++k)
            matrix(i, k) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
    }
    constexpr double kRounding = 1e-6;
    const double max = matrix.cwiseAbs().maxCoeff();
    if ((matrix - matrix.transpose()).cwiseAbs().maxCoeff() > kRounding * max) return false;
    matrix.diagonal().array() += kRounding * max;
    return max == 0 || base::is_positive_definite(matrix);
}

}  // namespace

void read_calibration(FirstError& error, TomlSection& file, Machine& machine) {
    const auto section = file.section("calibration", "[calibration]", kCalibrationKeys);
    if (!section) {
        if (file.has("calibrated"))
            file.fail("calibrated",
                      "[[calibrated]] describes a fit of parameters, but [calibration] is missing");
        return;
    }
    Calibration calibration;
    calibration.runs = static_cast<int>(TomlSection(*section).number("runs", 1, NumberRule::count));
    calibration.residual_percent =
        TomlSection(*section).number("residual_percent", 0, NumberRule::not_negative);
    const auto parameters =
        file.has("calibrated") ? file.tables("calibrated") : std::vector<const toml::table*>();
    for (const toml::table* parameter_id : parameters)
        read_calibrated(error, *parameter_id, parameters.size(), machine, calibration);
    if (error.text()) return;
    if (!parameters.empty() && !is_covariance(calibration.covariance_percent2))
        file.fail("calibrated",
                  "the rows 'covariance_percent2' are not a covariance: they must be symmetric and positive "
                  "semidefinite");
    machine.calibration = std::move(calibration);
}

void print_calibration(TomlWriter& out, const Calibration& calibration) {
    out.section("[calibration]");
    out.line("runs", std::to_string(calibration.runs));
    out.number("residual_percent", calibration.residual_percent);
    for (std::size_t i = 0; i < calibration.parameters.size(); ++i) {
        out.section("[[calibrated]]");
        out.line("of", base::toml_string(calibration.parameters[i].of));
        out.line("key", base::toml_string(calibration.parameters[i].key));
        out.line("covariance_percent2", number_list(calibration.covariance_percent2[i]));
    }
}

std::vector<TableSchema> calibration_schema() {
    return {
        {.at = {"calibration"},
         .meaning = "fit of parameters to recorded runs, and its quality",
         .keys = {number_key("runs", {.min = 1, .max = 100000, .integer_only = true}, "1",
                             "number of runs that were used for the fit"),
                  number_key("residual_percent", kNotNegative, "0.0",
                             "remaining error of the run times after the fit, as a standard deviation")}},
        {.at = {"calibrated"},
         .many = true,
         .meaning = "a parameter that was fitted",
         .keys = {required(text_key("of", "", "axis letters, path, controller or times")),
                  required(text_key("key", "", "the key of the parameter")),
                  required(list_key(
                      "covariance_percent2", KeyKind::number, 0,
                      "covariance of the logarithms of this parameter and each other one, in percent"))}}};
}

}  // namespace gsim::machine
