#include "tests/lua_lib/roundtrip/roundtrip_ab9.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace gsim::roundtrip {

// In the order of docs/language.md, "Order of execution in a block".
void Ab9Control::run(const ReadBlock& block) {
    select_plane(block);
    select_units(block);
    set_tool_length(block);
    if (block.has("G98")) return_to_r_ = false;
    if (block.has("G99")) return_to_r_ = true;
    if (block.has("G80") && series_) {
        motion_ = series_->before;
        series_.reset();
    }
    select_distance(block);
    select_system(block);
    select_feed_mode(block);
    set_feed(block);
    if (block.has("G4")) {
        for (const char* letter : {"P", "X", "U"})
            if (const auto seconds = block.word(letter)) return dwell(*seconds);
        return;
    }
    set_transformations(block);
    set_data(block);
    if (block.has("G16")) polar_ = true;
    if (block.has("G15")) {
        polar_ = false;
        polar_angle_deg_ = polar_radius_ = {};
    }
    move(block);
}

std::optional<double> Ab9Control::variable(int number) const {
    const auto axis_value = [&](const Point& point, int first) {
        const auto axis = static_cast<std::size_t>(number - first);
        return point[number - first] / (is_rotary(axis) ? 1 : unit_mm_);
    };
    if (number >= 5001 && number < 5010) return axis_value(program_point(), 5001);
    if (number >= 5021 && number < 5030) return axis_value(position_, 5021);
    for (int system = 0; system < 9; ++system) {
        const int first = 5221 + 20 * system;
        if (number >= first && number < first + 9)
            return axis_value(systems_[static_cast<std::size_t>(system)], first);
    }
    return std::nullopt;
}

// --- Position of the program's zero point ---

Point Ab9Control::offsets() const {
    Point sum = systems_[system_] + external_ + local_ + shift_;
    sum[2] += length_mm_;
    return sum;
}

// The mirror first, then the scale, then the rotation; a centre is a point of the program, on which acts what
// comes before.
Control::Space Ab9Control::space() const {
    Space map = Space::Identity();
    for (Eigen::Index i = 0; i < 3; ++i) {
        if (!mirror_[at(i)]) continue;
        map.matrix()(i, i) = -1;
        map.matrix()(i, 3) = 2 * *mirror_[at(i)];
    }
    if (scale_) {
        const Corner centre = map * scale_->centre;
        map = Eigen::Translation3d(centre) * Eigen::Scaling(scale_->factor) * Eigen::Translation3d(-centre) *
              map;
    }
    if (rotates()) {
        const Corner centre = map * rotation_->centre;
        const Corner axis = Corner::Unit(kPlanes[at(rotation_->plane)][2]);
        const Eigen::AngleAxisd turn(rotation_->angle_deg * kRadPerDeg, axis);
        map = Eigen::Translation3d(centre) * turn * Eigen::Translation3d(-centre) * map;
    }
    return Eigen::Translation3d(Corner(offsets().head<3>())) * map;
}

void Ab9Control::set_transformations(const ReadBlock& block) {
    if (block.has("G51.1")) each_axis(block, [&](std::size_t axis, double value) { mirror_[axis] = value; });
    if (block.has("G50.1")) {
        if (!block.has_axis()) mirror_ = {};
        each_axis(block, [&](std::size_t axis, double) { mirror_[axis].reset(); });
    }
    if (block.has("G14") || block.has("G14.1")) set_scale(block);
    if (block.has("G68")) set_rotation(block);
    if (block.has("G69")) rotation_.reset();
}

// Bare, both codes end it.
void Ab9Control::set_scale(const ReadBlock& block) {
    scale_.reset();
    if (block.words.empty()) return;
    Scale scale;
    const double common = block.word("P").value_or(1);
    scale.factor = {block.word("I").value_or(common), block.word("J").value_or(common),
                    block.word("K").value_or(common)};
    each_axis(block,
              [&](std::size_t axis, double value) { scale.centre[static_cast<Eigen::Index>(axis)] = value; });
    scale_ = scale;
}

// The rotation is in the active plane; increments add to a rotation that is active there. Its centre is kept
// if the block gives none.
void Ab9Control::set_rotation(const ReadBlock& block) {
    Rotation rotation;
    const bool continues = rotates() && rotation_->plane == plane_;
    if (continues) rotation.centre = rotation_->centre;
    rotation.plane = plane_;
    rotation.system = system_;
    rotation.angle_deg = *block.word("R") + (continues && incremental_ ? rotation_->angle_deg : 0);
    each_axis(block, [&](std::size_t axis, double value) {
        rotation.centre[static_cast<Eigen::Index>(axis)] = value;
    });
    rotation_ = rotation;
}

void Ab9Control::set_tool_length(const ReadBlock& block) {
    if (const auto h = block.word("H")) length_number_ = static_cast<int>(*h);
    if (block.has("G43")) length_sign_ = 1;
    if (block.has("G44")) length_sign_ = -1;
    if (block.has("G49")) length_sign_ = 0;
    if (block.word("H") || block.has("G43") || block.has("G44") || block.has("G49")) {
        const Tool& tool = tools_[length_number_];
        length_mm_ = length_sign_ * (tool.length_mm + tool.wear_mm);
    }
}

void Ab9Control::set_data(const ReadBlock& block) {
    if (block.has("G10")) set_table(block);
    if (block.has("G52"))
        each_axis(block,
                  [&](std::size_t axis, double value) { local_[static_cast<Eigen::Index>(axis)] = value; });
    if (block.has("G92")) shift_to(block);
    if (block.has("G92.1")) shift_.setZero();
}

void Ab9Control::set_table(const ReadBlock& block) {
    const auto set = [this](double& stored, double value) { stored = incremental_ ? stored + value : value; };
    const int list = static_cast<int>(*block.word("L")), location = static_cast<int>(*block.word("P"));
    if (list == 2) {
        Point& table = location == 0 ? external_ : systems_[static_cast<std::size_t>(location - 1)];
        each_axis(block, [&](std::size_t axis, double value) {
            set(table[static_cast<Eigen::Index>(axis)], value);
        });
    } else {
        Tool& tool = tools_[location];
        set(list == 10 ? tool.length_mm : tool.wear_mm, *block.word("R") * unit_mm_);
    }
}

// G92: the machine's current point gets the given coordinates, and keeps the others.
void Ab9Control::shift_to(const ReadBlock& block) {
    Point expected_value = program_point();
    each_axis(block, [&](std::size_t axis, double value) {
        expected_value[static_cast<Eigen::Index>(axis)] = value;
    });
    shift_ += position_ - to_machine(expected_value);
}

// --- Motion ---

void Ab9Control::move(const ReadBlock& block) {
    for (const char* code : {"G0", "G1", "G2", "G3", "G81", "G82", "G83", "G85"}) {
        if (!block.has(code)) continue;
        const bool is_cycle = std::string(code).size() == 3;
        if (is_cycle && !series_) {
            Series series;
            series.before = motion_;
            series.initial = program_point()[kPlanes[at(plane_)][2]];
            series_ = std::move(series);
        }
        if (!is_cycle) series_.reset();
        motion_ = code;
    }
    for (const char* taker : {"G10", "G52", "G92", "G14", "G14.1", "G68", "G51.1", "G50.1"})
        if (block.has(taker)) return;
    if (series_) return drill(block);
    const bool is_arc = motion_ == "G2" || motion_ == "G3";
    if (!block.has_axis() && !(is_arc && (block.word("I") || block.word("J") || block.word("K")))) return;
    if (is_arc) return arc(motion_ == "G3", without_polar(block));
    line(motion_ == "G0", without_polar(block));
}

// The first axis of the plane is a radius, the second an angle about the zero point. What is left out stays.
// In increments the angle adds up, and the radius is a step in its direction.
ReadBlock Ab9Control::without_polar(const ReadBlock& block) {
    const auto [first, second, normal] = kPlanes[at(plane_)];
    const std::string first_letter(1, kAxes[at(first)]), second_letter(1, kAxes[at(second)]);
    const auto radius = block.word(first_letter), angle = block.word(second_letter);
    if (!polar_ || (!radius && !angle)) return block;
    double& held_angle = polar_angle_deg_[at(plane_)];
    double& held_radius = polar_radius_[at(plane_)];
    double reach = radius.value_or(0);
    if (incremental_) {
        held_angle += angle.value_or(0);
    } else {
        held_angle = angle.value_or(held_angle);
        reach = held_radius = radius.value_or(held_radius);
    }
    ReadBlock plain = block;
    plain.words[first_letter] = reach * std::cos(held_angle * kRadPerDeg);
    plain.words[second_letter] = reach * std::sin(held_angle * kRadPerDeg);
    return plain;
}

// --- Canned cycles ---

void Ab9Control::read_levels(const ReadBlock& block) {
    const auto normal = kPlanes[at(plane_)][2];
    const auto depth = block.word(std::string(1, kAxes[at(normal)]));
    if (const auto r = block.word("R")) series_->r = *r * unit_mm_ + (incremental_ ? series_->initial : 0);
    if (depth) series_->bottom = *depth * unit_mm_ + (incremental_ ? *series_->r : 0);
    if (const auto q = block.word("Q")) series_->peck = *q * unit_mm_;
    if (const auto p = block.word("P")) series_->dwell_s = *p;
}

void Ab9Control::drill(const ReadBlock& block) {
    read_levels(block);
    if (!block.has_axis() && !block.word("R")) return;
    const auto normal = kPlanes[at(plane_)][2];
    ReadBlock location = block;
    location.words.erase(std::string(1, kAxes[at(normal)]));
    const int times = static_cast<int>(block.word("L").value_or(1));
    for (int pass = 0; pass < times; ++pass) {
        go(true, to_machine(program_target(location)));
        drill_here(motion_);
    }
}

void Ab9Control::to_level(bool rapid, double level) {
    Point target = program_point();
    target[kPlanes[at(plane_)][2]] = level;
    go(rapid, to_machine(target));
}

void Ab9Control::peck() {
    constexpr double kClearance_mm = 1;
    const Series& s = *series_;
    const double up = *s.bottom <= *s.r ? 1 : -1;
    for (double depth = *s.peck; depth < up * (*s.r - *s.bottom) - kNoMove_mm; depth += *s.peck) {
        to_level(false, *s.r - up * depth);
        to_level(true, *s.r);
        if (depth > kClearance_mm) to_level(true, *s.r - up * (depth - kClearance_mm));
    }
}

void Ab9Control::drill_here(const std::string& cycle) {
    const Series& s = *series_;
    to_level(true, *s.r);
    if (cycle == "G83") peck();
    to_level(false, *s.bottom);
    if ((cycle == "G82" || cycle == "G83") && s.dwell_s.value_or(0) > 0) dwell(*s.dwell_s);
    if (cycle == "G85") to_level(false, *s.r);
    to_level(true, return_to_r_ ? *s.r : s.initial);
}

}  // namespace gsim::roundtrip
