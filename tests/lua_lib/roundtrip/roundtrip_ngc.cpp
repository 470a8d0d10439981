#include "tests/lua_lib/roundtrip/roundtrip_ngc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gsim::roundtrip {

NgcControl::NgcControl(const std::array<Point, 9>& systems) {
    for (std::size_t i = 0; i < systems.size(); ++i) systems_[i].origin = systems[i];
    return_to_r_ = true;
}

// In the order of docs/language.md, "Order of execution in a block".
void NgcControl::run(const ReadBlock& block) {
    select_feed_mode(block);
    set_feed(block);
    if (const auto t = block.word("T")) selected_ = static_cast<int>(*t);
    if (block.has("M6")) loaded_ = selected_;
    if (block.has("G4")) dwell(block.word("P").value());
    select_plane(block);
    select_units(block);
    set_tools(block);
    select_system(block);
    select_distance(block);
    if (block.has("G90.1")) arc_centre_is_point_ = true;
    if (block.has("G91.1")) arc_centre_is_point_ = false;
    if (block.has("G98")) return_to_r_ = false;
    if (block.has("G99")) return_to_r_ = true;
    if (block.has("G80")) motion_.clear();
    set_data(block);
    move(block);
}

std::optional<double> NgcControl::variable(int number) const {
    if (number < 5420 || number > 5428) return std::nullopt;
    const int axis = number - 5420;
    return program_point()[axis] / (is_rotary(at(axis)) ? 1 : unit_mm_);
}

// --- Position of the program's zero point: the G92 offset, then the rotation of the system, its origin, the
// tool ---

Control::Space NgcControl::turned(double degrees) {
    return Space(Eigen::AngleAxisd(degrees * kRadPerDeg, Eigen::Vector3d::UnitZ()));
}

Control::Space NgcControl::space() const {
    const System& system = systems_[system_];
    return Eigen::Translation3d(Eigen::Vector3d((system.origin + tool_offset_).head<3>())) *
           turned(system.turn_deg) * Eigen::Translation3d(Eigen::Vector3d(g92_.head<3>()));
}

Point NgcControl::other_offsets() const {
    return systems_[system_].origin + tool_offset_ + g92_;
}

void NgcControl::set_tools(const ReadBlock& block) {
    if (block.has("G49")) tool_offset_.setZero();
    if (block.has("G43")) {
        const int h = static_cast<int>(block.word("H").value_or(0));
        const auto tool = tools_.find(h == 0 ? loaded_ : h);
        tool_offset_ = tool == tools_.end() ? Point::Zero().eval() : tool->second;
    }
    if (block.has("G43.1"))
        each_axis(block, [&](std::size_t axis, double value) {
            tool_offset_[static_cast<Eigen::Index>(axis)] = value;
        });
}

void NgcControl::set_data(const ReadBlock& block) {
    if (block.has("G10")) set_g10(block);
    if (block.has("G52")) {
        each_axis(block,
                  [&](std::size_t axis, double value) { g92_[static_cast<Eigen::Index>(axis)] = value; });
        stored_g92_ = g92_;
    }
    if (block.has("G92")) set_g92(block);
    if (block.has("G92.1")) g92_ = stored_g92_ = Point::Zero();
    if (block.has("G92.2")) g92_.setZero();
    if (block.has("G92.3")) g92_ = stored_g92_;
}

void NgcControl::set_g10(const ReadBlock& block) {
    const int list = static_cast<int>(*block.word("L")), location = static_cast<int>(*block.word("P"));
    if (list == 1) {
        if (!tools_.contains(location)) tools_[location].setZero();
        each_axis(block, [&](std::size_t axis, double value) {
            tools_[location][static_cast<Eigen::Index>(axis)] = value;
        });
        return;
    }
    System& system = systems_[location == 0 ? system_ : static_cast<std::size_t>(location - 1)];
    if (list == 20) return set_origin_by_position(block, system);
    each_axis(block, [&](std::size_t axis, double value) {
        system.origin[static_cast<Eigen::Index>(axis)] = value;
    });
    system.turn_deg = block.word("R").value_or(system.turn_deg);
}

// The origin of a system moves so that the machine is at the given coordinates.
void NgcControl::set_origin_by_position(const ReadBlock& block, System& system) {
    const Point carriage = position_ - tool_offset_;
    Point seen = carriage - system.origin;
    seen.head<3>() = turned(-system.turn_deg) * Eigen::Vector3d(seen.head<3>());
    seen -= g92_;
    each_axis(block, [&](std::size_t axis, double value) { seen[static_cast<Eigen::Index>(axis)] = value; });
    seen += g92_;
    seen.head<3>() = turned(system.turn_deg) * Eigen::Vector3d(seen.head<3>());
    system.origin = carriage - seen;
}

void NgcControl::set_g92(const ReadBlock& block) {
    const Point current = program_point();
    each_axis(block, [&](std::size_t axis, double value) {
        const auto i = static_cast<Eigen::Index>(axis);
        g92_[i] += current[i] - value;
    });
    stored_g92_ = g92_;
}

// --- Motion ---

void NgcControl::move(const ReadBlock& block) {
    bool coded = false;
    for (const char* code : {"G0", "G1", "G2", "G3", "G81", "G82", "G83", "G85"}) {
        if (!block.has(code)) continue;
        motion_ = code;
        coded = true;
    }
    if (!coded && (block.has("G10") || block.has("G52") || block.has("G92") || block.has("G43.1"))) return;
    const bool is_cycle = motion_.size() == 3;
    if (!is_cycle) {
        in_series_ = false;
        last_cycle_.clear();
    }
    const bool is_arc = motion_ == "G2" || motion_ == "G3";
    if (!block.has_axis() && !(is_arc && (block.word("I") || block.word("J") || block.word("K")))) return;
    if (is_cycle) return drill(block);
    if (is_arc) return arc(motion_ == "G3", block);
    line(motion_ == "G0", block);
}

// --- Canned cycles ---

void NgcControl::to_level(bool rapid, double level) {
    Point target = program_point();
    target[kPlanes[at(plane_)][2]] = level;
    to(rapid, target);
}

// Words missing in the block are those of the cycle before, if it is the same. In increments R counts from
// the level at which the series began, the depth from R.
NgcControl::Hole NgcControl::read_levels(const ReadBlock& block) {
    if (motion_ != last_cycle_) sticky_ = {};
    last_cycle_ = motion_;
    const auto keep = [&](const std::string& letter, double factor, std::optional<double>& stored) {
        if (const auto value = block.word(letter)) stored = *value * factor;
    };
    keep("R", unit_mm_, sticky_.r);
    keep(std::string(1, kAxes[at(kPlanes[at(plane_)][2])]), unit_mm_, sticky_.depth);
    keep("Q", unit_mm_, sticky_.peck);
    keep("P", 1, sticky_.dwell_s);
    Hole hole;
    hole.r = *sticky_.r + (incremental_ ? initial_ : 0);
    hole.bottom = *sticky_.depth + (incremental_ ? hole.r : 0);
    hole.clear = return_to_r_ ? hole.r : std::max(hole.r, initial_);
    return hole;
}

// The path to the first hole is at the level of the tool if that is above R, else at the level of the
// retract.
void NgcControl::drill(const ReadBlock& block) {
    const auto [first, second, normal] = kPlanes[at(plane_)];
    if (!in_series_) initial_ = program_point()[normal];
    in_series_ = true;
    const Hole hole = read_levels(block);
    if (hole.r - initial_ > kNoMove_mm) to_level(true, hole.r);
    const int times = static_cast<int>(block.word("L").value_or(1));
    for (int pass = 0; pass < times; ++pass) {
        Point over = program_target(block);
        const double level = program_point()[normal];
        over[normal] = pass == 0 && level - hole.r > kNoMove_mm ? level : hole.clear;
        to(true, over);
        to_level(true, hole.r);
        strokes(hole);
    }
}

void NgcControl::strokes(const Hole& hole) {
    constexpr double kClearance_mm = 0.254;
    if (motion_ == "G83") {
        for (double depth = hole.r - *sticky_.peck; depth > hole.bottom + kNoMove_mm;
             depth -= *sticky_.peck) {
            to_level(false, depth);
            to_level(true, hole.r);
            to_level(true, depth + kClearance_mm);
        }
    }
    to_level(false, hole.bottom);
    if (motion_ == "G82") dwell(*sticky_.dwell_s);
    if (motion_ == "G85") to_level(false, hole.r);
    to_level(true, hole.clear);
}

}  // namespace gsim::roundtrip
