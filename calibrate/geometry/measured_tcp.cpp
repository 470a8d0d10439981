#include "calibrate/geometry/measured_tcp.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "base/units.h"
#include "calibrate/text/list.h"
#include "motion/kinematics/pose.h"

namespace gsim::calibrate {

namespace {

constexpr std::size_t kNoColumn = static_cast<std::size_t>(-1);
constexpr std::array<std::string_view, 3> kPositionColumns{"x_mm", "y_mm", "z_mm"};
constexpr std::array<std::string_view, 3> kOrientationColumns{"roll_deg", "pitch_deg", "yaw_deg"};

/// Columns of a list.
struct TcpColumns {
    std::vector<std::size_t> axes;
    std::array<std::size_t, 3> position{}, angles{};
    std::size_t sigma_mm = kNoColumn, sigma_deg = kNoColumn;
};

Result<TcpColumns> find_columns(const Cells& heading, const machine::Machine& machine) {
    const auto at = [&](std::string_view name) { return find_column(heading, name).value_or(kNoColumn); };
    TcpColumns columns;
    for (const machine::Axis& axis : machine.axes) columns.axes.push_back(at({&axis.letter, 1}));
    for (std::size_t i = 0; i < 3; ++i) {
        columns.position[i] = at(kPositionColumns[i]);
        columns.angles[i] = at(kOrientationColumns[i]);
        if (columns.position[i] == kNoColumn)
            return Unexpected(
                fmt::format("line 1: it must name the columns, '{}' among them", kPositionColumns[i]));
        if ((columns.angles[i] == kNoColumn) != (columns.angles[0] == kNoColumn))
            return Unexpected(
                "line 1: an orientation requires all of the columns 'roll_deg', 'pitch_deg' and 'yaw_deg'");
    }
    columns.sigma_mm = at("sigma_mm");
    columns.sigma_deg = at("sigma_deg");
    return columns;
}

/// Reader of the cells of one line; it keeps the first error.
class TcpRow {
  public:
    explicit TcpRow(const Cells& cells) : cells_(cells) {}

    bool has(std::size_t column) const { return column < cells_.size() && !cells_[column].empty(); }
    double number(std::size_t column) {
        if (!has(column)) {
            if (error_.empty()) error_ = "a column is missing or empty";
            return 0;
        }
        const auto value = parse_number(cells_[column]);
        if (!value && error_.empty()) error_ = fmt::format("'{}' must be a number", cells_[column]);
        return value.value_or(0);
    }
    std::optional<double> sigma(std::size_t column) {
        if (!has(column)) return std::nullopt;
        const double value = number(column);
        if (!(value > 0) && error_.empty())
            error_ = fmt::format("'{}' must be a standard deviation greater than 0", cells_[column]);
        return value;
    }
    Result<MeasuredTcp> or_error(const MeasuredTcp& tcp) const {
        if (!error_.empty()) return tl::unexpected(error_);
        return tcp;
    }

  private:
    const Cells& cells_;
    std::string error_;
};

bool is_measured(const TcpRow& line, const TcpColumns& columns) {
    return std::any_of(columns.position.begin(), columns.position.end(),
                       [&](std::size_t column) { return line.has(column); });
}

Result<MeasuredTcp> parse_tcp_row(TcpRow& line, const TcpColumns& columns, const machine::Machine& machine) {
    MeasuredTcp tcp;
    for (std::size_t i = 0; i < columns.axes.size(); ++i)
        tcp.readings.push_back(columns.axes[i] == kNoColumn ? machine.axes[i].home
                                                            : line.number(columns.axes[i]));
    if (!is_measured(line, columns)) return line.or_error(tcp);
    kinematics::Rpy pose{.x_mm = line.number(columns.position[0]),
                         .y_mm = line.number(columns.position[1]),
                         .z_mm = line.number(columns.position[2])};
    tcp.has_orientation = line.has(columns.angles[0]);
    if (tcp.has_orientation) {
        pose.roll_rad = line.number(columns.angles[0]) * kRadPerDeg;
        pose.pitch_rad = line.number(columns.angles[1]) * kRadPerDeg;
        pose.yaw_rad = line.number(columns.angles[2]) * kRadPerDeg;
    }
    tcp.tcp = kinematics::pose_from_rpy(pose);
    tcp.sigma_mm = line.sigma(columns.sigma_mm);
    tcp.sigma_deg = line.sigma(columns.sigma_deg);
    return line.or_error(tcp);
}

}  // namespace

Result<TcpList> read_tcps(std::string_view list, const machine::Machine& machine) {
    TcpList found;
    TcpColumns columns;
    const auto heading = [&](const Cells& cells) {
        return find_columns(cells, machine).map([&](TcpColumns named) { columns = std::move(named); });
    };
    const auto row = [&](const Cells& cells) {
        TcpRow reader(cells);
        return parse_tcp_row(reader, columns, machine).map([&](MeasuredTcp tcp) {
            (is_measured(reader, columns) ? found.tcps : found.unmeasured).push_back(std::move(tcp));
        });
    };
    return read_list(list, heading, row).map([&] { return std::move(found); });
}

std::string print_tcps(const std::vector<MeasuredTcp>& tcps, const machine::Machine& machine,
                       bool orientation, bool measured) {
    std::string text;
    for (const machine::Axis& axis : machine.axes) text += fmt::format("{},", axis.letter);
    text += orientation ? "x_mm,y_mm,z_mm,roll_deg,pitch_deg,yaw_deg\n" : "x_mm,y_mm,z_mm\n";
    for (const MeasuredTcp& tcp : tcps) {
        for (const double reading_options : tcp.readings) text += fmt::format("{:.10g},", reading_options);
        if (measured) {
            const kinematics::Rpy pose = kinematics::rpy_from_pose(tcp.tcp);
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
