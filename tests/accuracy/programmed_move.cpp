#include "tests/accuracy/programmed_move.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <exception>
#include <istream>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "base/text/json.h"

namespace gsim::accuracy {

namespace {

using nlohmann::json;
using Position = std::map<char, double>;

constexpr double kSweepTolerance = 1e-9;
constexpr double kTurn_rad = 2 * std::numbers::pi;

Position parse_pose(const json& object) {
    Position place;
    for (const auto& [letter, value] : object.items()) place[letter.at(0)] = value.get<double>();
    return place;
}

Eigen::Vector3d tcp_position(const Position& place) {
    const auto value = [&](char letter) {
        const auto found = place.find(letter);
        return found == place.end() ? 0.0 : found->second;
    };
    return {value('X'), value('Y'), value('Z')};
}

Eigen::Vector3d vector_in(const json& object) {
    return tcp_position(parse_pose(object));
}

bool is_arc(const std::string& kind) {
    return kind.starts_with("arc");
}

/// Sets length, radius and directions of an arc about `center` from one position to the other.
void set_arc(const json& line, const Eigen::Vector3d& from, const Eigen::Vector3d& to, ProgrammedMove& move) {
    const Eigen::Vector3d normal = vector_in(line.at("normal"));
    const double sense = line.at("kind") == "arc_ccw" ? 1 : -1;
    const auto flat = [&](const Eigen::Vector3d& v) { return Eigen::Vector3d(v - v.dot(normal) * normal); };
    const Eigen::Vector3d center = vector_in(line.at("center"));
    const Eigen::Vector3d a = flat(from - center), b = flat(to - center);
    double sweep = std::atan2(sense * a.cross(b).dot(normal), a.dot(b));
    if (sweep <= kSweepTolerance) sweep += kTurn_rad;
    sweep += kTurn_rad * (line.value("turns", 1) - 1);
    move.radius_mm = a.norm();
    const double ascent = (to - from).dot(normal);
    move.sweep_rad = sweep;
    move.climb_mm = ascent;
    move.sense = sense;
    move.normal = normal;
    move.length_mm = std::hypot(move.radius_mm * sweep, ascent);
    const auto tangent = [&](const Eigen::Vector3d& spoke) {
        const Eigen::Vector3d round = sense * normal.cross(spoke) * sweep;
        return Eigen::Vector3d((round + ascent * normal).normalized());
    };
    move.enters = tangent(a);
    move.leaves = tangent(b);
}

void set_line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, ProgrammedMove& move) {
    move.length_mm = (to - from).norm();
    if (move.length_mm > kSweepTolerance) move.enters = move.leaves = (to - from) / move.length_mm;
}

void limit_along_path(const machine::Machine& machine, ProgrammedMove& move) {
    const machine::PathLimits& path = machine.path;
    move.speed_limit = std::min(move.speed_limit, move.rapid ? path.max_rapid_mm_s : path.max_feed_mm_s);
    move.acceleration = std::min(
        move.acceleration, move.rapid ? path.max_rapid_acceleration_mm_s2 : path.max_acceleration_mm_s2);
}

/// Sets the limits of the axes and of the path along a move. On an arc each axis moves in all directions of
/// its plane.
void set_limits(const machine::Machine& machine, const Position& from, const Position& to,
                ProgrammedMove& move) {
    double turn = 0, other = 0;
    for (const machine::Axis& axis : machine.axes) {
        const double change = std::abs(to.at(axis.letter) - from.at(axis.letter));
        if (axis.kind == machine::AxisKind::rotary) turn = std::hypot(turn, change);
        if (axis.kind == machine::AxisKind::linear &&
            std::string("XYZ").find(axis.letter) == std::string::npos)
            other = std::hypot(other, change);
    }
    move.all_axes = std::hypot(move.length_mm, turn, other);
    move.length = move.length_mm > kSweepTolerance ? move.length_mm : std::hypot(turn, other);
    move.speed_limit = move.acceleration = std::numeric_limits<double>::infinity();
    if (move.length <= kSweepTolerance) return;
    for (const machine::Axis& axis : machine.axes) {
        double share = std::abs(to.at(axis.letter) - from.at(axis.letter)) / move.length;
        const std::size_t at = std::string("XYZ").find(axis.letter);
        if (move.radius_mm > 0 && at < 3) {
            const auto index = static_cast<Eigen::Index>(at);
            share = std::max(std::abs(move.enters[index]), std::abs(move.leaves[index]));
        }
        if (axis.letter == 'E') move.extruded = (to.at('E') - from.at('E')) / move.length;
        if (share <= kSweepTolerance) continue;
        move.speed_limit = std::min(move.speed_limit, axis.max_speed / share);
        move.acceleration = std::min(move.acceleration, axis.max_acceleration / share);
    }
    if (move.length_mm > kSweepTolerance) limit_along_path(machine, move);
}

ProgrammedMove move_in(const json& line, const machine::Machine& machine, Position& at) {
    ProgrammedMove move;
    const std::string kind = line.at("kind").get<std::string>();
    if (kind == "dwell") {
        move.wait_s = line.at("end_s").get<double>() - line.at("start_s").get<double>();
        return move;
    }
    move.rapid = kind == "rapid";
    const Position to = parse_pose(line.at("to"));
    if (is_arc(kind)) {
        set_arc(line, tcp_position(at), tcp_position(to), move);
    } else {
        set_line(tcp_position(at), tcp_position(to), move);
    }
    set_limits(machine, at, to, move);
    if (line.at("feed").is_number()) move.feed_s = line.at("feed").get<double>() / 60;
    at = to;
    return move;
}

}  // namespace

Result<std::vector<ProgrammedMove>> read_programmed_moves(std::istream& moves,
                                                          const machine::Machine& machine) {
    Position at;
    for (const machine::Axis& axis : machine.axes) at[axis.letter] = axis.home;
    std::vector<ProgrammedMove> read;
    std::string line;
    for (int number = 1; std::getline(moves, line); ++number) {
        try {
            read.push_back(move_in(text::parse_json<json>(line), machine, at));
        } catch (const std::exception& error) {  // nlohmann's and the maps'
            return Unexpected(fmt::format("line {} of the moves: {}", number, error.what()));
        }
    }
    return read;
}

}  // namespace gsim::accuracy
