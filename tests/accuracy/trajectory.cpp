#include "tests/accuracy/trajectory.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <istream>
#include <optional>
#include <string_view>

#include <fmt/format.h>

namespace gsim::accuracy {

namespace {

std::vector<std::string_view> cells(std::string_view line) {
    if (line.ends_with('\r')) line.remove_suffix(1);
    std::vector<std::string_view> found;
    while (true) {
        const std::size_t comma = line.find(',');
        found.push_back(line.substr(0, comma));
        if (comma == std::string_view::npos) return found;
        line.remove_prefix(comma + 1);
    }
}

// Indexes of the cells with the time and X, Y and Z.
using Columns = std::array<std::size_t, 4>;

std::optional<Columns> find_columns(std::string_view header) {
    constexpr std::array<std::array<std::string_view, 2>, 4> kNames{
        {{"t", "t_s"}, {"x", "x_mm"}, {"y", "y_mm"}, {"z", "z_mm"}}};
    const std::vector<std::string_view> names = cells(header);
    Columns columns{};
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const auto found = std::find_first_of(names.begin(), names.end(), kNames[i].begin(), kNames[i].end());
        if (found == names.end()) return std::nullopt;
        columns[i] = static_cast<std::size_t>(found - names.begin());
    }
    return columns;
}

std::optional<double> number(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::optional<Sample> read_sample(std::string_view line, const Columns& columns) {
    const std::vector<std::string_view> values = cells(line);
    std::array<double, 4> read{};
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (columns[i] >= values.size()) return std::nullopt;
        const auto value = number(values[columns[i]]);
        if (!value) return std::nullopt;
        read[i] = *value;
    }
    return Sample{read[0], {read[1], read[2], read[3]}};
}

}  // namespace

Result<Trajectory> read_trajectory(std::istream& csv) {
    std::string line;
    std::getline(csv, line);
    const auto columns = find_columns(line);
    if (!columns) return Unexpected("the trajectory lacks a column for time, X, Y or Z");
    Trajectory trajectory;
    for (long number = 2; std::getline(csv, line); ++number) {
        if (line.empty()) continue;
        const auto sample = read_sample(line, *columns);
        if (!sample || (!trajectory.empty() && sample->t_s < trajectory.back().t_s)) {
            return Unexpected(fmt::format("line {} of the trajectory cannot be understood", number));
        }
        trajectory.push_back(*sample);
    }
    if (trajectory.empty()) return Unexpected("the trajectory is empty");
    return trajectory;
}

std::array<double, 3> place_at_mm(const Trajectory& trajectory, double t_s) {
    const auto later = std::lower_bound(trajectory.begin(), trajectory.end(), t_s,
                                        [](const Sample& sample, double time) { return sample.t_s < time; });
    if (later == trajectory.begin()) return trajectory.front().at_mm;
    if (later == trajectory.end()) return trajectory.back().at_mm;
    const auto earlier = std::prev(later);
    const double part = (t_s - earlier->t_s) / (later->t_s - earlier->t_s);
    std::array<double, 3> position_mm{};
    for (std::size_t axis = 0; axis < position_mm.size(); ++axis) {
        position_mm[axis] = std::lerp(earlier->at_mm[axis], later->at_mm[axis], part);
    }
    return position_mm;
}

}  // namespace gsim::accuracy
