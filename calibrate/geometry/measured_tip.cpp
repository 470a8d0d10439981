#include "calibrate/geometry/measured_tip.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "base/units.h"
#include "calibrate/text/list.h"
#include "motion/kinematics/pose.h"

namespace gsim::calibrate {

namespace {

constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);
constexpr std::array<std::string_view, 3> kPlace{"x_mm", "y_mm", "z_mm"};
constexpr std::array<std::string_view, 3> kTurn{"roll_deg", "pitch_deg", "yaw_deg"};

/// Columns of a list.
struct TipColumns {
    std::vector<std::size_t> axes;
    std::array<std::size_t, 3> place{}, turn{};
    std::size_t sigma_mm = kNowhere, sigma_deg = kNowhere;
};

tl::expected<TipColumns, std::string> find_columns(const Cells& heading, const machine::Machine& machine) {
    const auto at = [&](std::string_view name) { return column_of(heading, name).value_or(kNowhere); };
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

/// Reader of the cells of one line; it keeps the first error.
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
        if (!value && error_.empty()) error_ = fmt::format("'{}' should be a number", cells_[column]);
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
    TipColumns columns;
    const auto heading = [&](const Cells& cells) {
        return find_columns(cells, machine).map([&](TipColumns named) { columns = std::move(named); });
    };
    const auto row = [&](const Cells& cells) {
        TipLine reader(cells);
        return tip_in(reader, columns, machine).map([&](MeasuredTip tip) {
            (is_measured(reader, columns) ? found.tips : found.unmeasured).push_back(std::move(tip));
        });
    };
    return read_list(list, heading, row).map([&] { return std::move(found); });
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
