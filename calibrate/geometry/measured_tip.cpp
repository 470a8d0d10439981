#include "calibrate/geometry/measured_tip.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include "base/units.h"
#include "runtime/kinematics/pose.h"

namespace gsim::calibrate {

namespace {

using Cells = std::vector<std::string_view>;

constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);
constexpr std::array<std::string_view, 3> kPlace{"x_mm", "y_mm", "z_mm"};
constexpr std::array<std::string_view, 3> kTurn{"roll_deg", "pitch_deg", "yaw_deg"};

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlank = " \"\r";
    while (!text.empty() && kBlank.find(text.front()) != std::string_view::npos) text.remove_prefix(1);
    while (!text.empty() && kBlank.find(text.back()) != std::string_view::npos) text.remove_suffix(1);
    return text;
}

Cells split(std::string_view line, char between) {
    Cells cells;
    while (true) {
        const std::size_t end = line.find(between);
        cells.push_back(trimmed(line.substr(0, end)));
        if (end == std::string_view::npos) return cells;
        line.remove_prefix(end + 1);
    }
}

tl::expected<double, std::string> number_in(std::string_view cell) {
    double value = 0;
    const auto read = fast_float::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (read.ec != std::errc() || read.ptr != cell.data() + cell.size() || !std::isfinite(value))
        return tl::unexpected(fmt::format("'{}' should be a number", cell));
    return value;
}

/// Where a list has what.
struct TipColumns {
    std::vector<std::size_t> axes;
    std::array<std::size_t, 3> place{}, turn{};
    std::size_t sigma_mm = kNowhere, sigma_deg = kNowhere;
};

tl::expected<TipColumns, std::string> find_columns(const Cells& heading, const machine::Machine& machine) {
    const auto at = [&](std::string_view name) {
        const auto found = std::find(heading.begin(), heading.end(), name);
        return found == heading.end() ? kNowhere : static_cast<std::size_t>(found - heading.begin());
    };
    TipColumns columns;
    for (const machine::Axis& axis : machine.axes) columns.axes.push_back(at({&axis.letter, 1}));
    for (std::size_t i = 0; i < 3; ++i) {
        columns.place[i] = at(kPlace[i]);
        columns.turn[i] = at(kTurn[i]);
        if (columns.place[i] == kNowhere)
            return tl::unexpected(
                fmt::format("line 1: it should name the columns, '{}' among them", kPlace[i]));
        if ((columns.turn[i] == kNowhere) != (columns.turn[0] == kNowhere))
            return tl::unexpected<std::string>(
                "line 1: an orientation has all of the columns 'roll_deg', 'pitch_deg' and 'yaw_deg'");
    }
    columns.sigma_mm = at("sigma_mm");
    columns.sigma_deg = at("sigma_deg");
    return columns;
}

/// Reads the cells of one line; keeps the first error.
class TipLine {
  public:
    explicit TipLine(const Cells& cells) : cells_(cells) {}

    bool has(std::size_t column) const { return column < cells_.size() && !cells_[column].empty(); }
    double number(std::size_t column) {
        if (!has(column)) {
            if (error_.empty()) error_ = "a column is missing or empty";
            return 0;
        }
        const auto value = number_in(cells_[column]);
        if (!value && error_.empty()) error_ = value.error();
        return value.value_or(0);
    }
    std::optional<double> sigma(std::size_t column) {
        if (!has(column)) return std::nullopt;
        const double value = number(column);
        if (!(value > 0) && error_.empty())
            error_ = fmt::format("'{}' should be a standard deviation above 0", cells_[column]);
        return value;
    }
    tl::expected<MeasuredTip, std::string> or_error(const MeasuredTip& tip) const {
        if (!error_.empty()) return tl::unexpected(error_);
        return tip;
    }

  private:
    const Cells& cells_;
    std::string error_;
};

bool is_measured(const TipLine& line, const TipColumns& columns) {
    return std::any_of(columns.place.begin(), columns.place.end(),
                       [&](std::size_t column) { return line.has(column); });
}

tl::expected<MeasuredTip, std::string> tip_in(TipLine& line, const TipColumns& columns,
                                              const machine::Machine& machine) {
    MeasuredTip tip;
    for (std::size_t i = 0; i < columns.axes.size(); ++i)
        tip.readings.push_back(columns.axes[i] == kNowhere ? machine.axes[i].home
                                                           : line.number(columns.axes[i]));
    if (!is_measured(line, columns)) return line.or_error(tip);
    kinematics::Rpy pose{.x_mm = line.number(columns.place[0]),
                         .y_mm = line.number(columns.place[1]),
                         .z_mm = line.number(columns.place[2])};
    tip.has_orientation = line.has(columns.turn[0]);
    if (tip.has_orientation) {
        pose.roll_rad = line.number(columns.turn[0]) * kRadPerDeg;
        pose.pitch_rad = line.number(columns.turn[1]) * kRadPerDeg;
        pose.yaw_rad = line.number(columns.turn[2]) * kRadPerDeg;
    }
    tip.tip = kinematics::pose_from_rpy(pose);
    tip.sigma_mm = line.sigma(columns.sigma_mm);
    tip.sigma_deg = line.sigma(columns.sigma_deg);
    return line.or_error(tip);
}

}  // namespace

tl::expected<TipList, std::string> read_tips(std::string_view list, const machine::Machine& machine) {
    TipList found;
    std::optional<TipColumns> columns;
    char between = ',';
    for (int number = 1; !list.empty(); ++number) {
        const std::size_t end = std::min(list.find('\n'), list.size());
        const std::string_view line = trimmed(list.substr(0, end));
        list.remove_prefix(std::min(end + 1, list.size()));
        if (!columns) {
            if (line.find('\t') != std::string_view::npos) between = '\t';
            auto named = find_columns(split(line, between), machine);
            if (!named) return tl::unexpected(named.error());
            columns = *std::move(named);
            continue;
        }
        if (line.empty()) continue;
        const Cells cells = split(line, between);
        TipLine reader(cells);
        auto tip = tip_in(reader, *columns, machine);
        if (!tip) return tl::unexpected(fmt::format("line {}: {}", number, tip.error()));
        (is_measured(reader, *columns) ? found.tips : found.unmeasured).push_back(*std::move(tip));
    }
    if (!columns) return tl::unexpected<std::string>("it is empty");
    return found;
}

std::string print_tips(const std::vector<MeasuredTip>& tips, const machine::Machine& machine,
                       bool orientation, bool measured) {
    std::string text;
    for (const machine::Axis& axis : machine.axes) text += fmt::format("{},", axis.letter);
    text += orientation ? "x_mm,y_mm,z_mm,roll_deg,pitch_deg,yaw_deg\n" : "x_mm,y_mm,z_mm\n";
    for (const MeasuredTip& tip : tips) {
        for (const double reading : tip.readings) text += fmt::format("{:.10g},", reading);
        if (measured) {
            const kinematics::Rpy pose = kinematics::rpy_from_pose(tip.tip);
            text += fmt::format("{:.6f},{:.6f},{:.6f}", pose.x_mm, pose.y_mm, pose.z_mm);
            if (orientation)
                text += fmt::format(",{:.8f},{:.8f},{:.8f}", pose.roll_rad / kRadPerDeg,
                                    pose.pitch_rad / kRadPerDeg, pose.yaw_rad / kRadPerDeg);
        } else {
            text += orientation ? ",,,,," : ",,";
        }
        text += "\n";
    }
    return text;
}

}  // namespace gsim::calibrate
