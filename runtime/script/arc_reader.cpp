#include "runtime/script/arc_reader.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "runtime/script/arc_solution.h"

namespace gsim::script {

using Eigen::Vector2d;
using simulation::ArcMove;
using simulation::AxisVector;
using simulation::Plane;

namespace {

constexpr double kRounding = 1e-9;  // relative, of the directions of a matrix

/// Axes of a plane in the order in which its angles are counted, and the normal: 0 x, 1 y, 2 z.
struct PlaneAxes {
    int first, second, normal;
};

PlaneAxes axes_of(Plane plane) {
    static constexpr std::array<PlaneAxes, 3> kAxes{{{0, 1, 2}, {2, 0, 1}, {1, 2, 0}}};
    return kAxes[static_cast<std::size_t>(plane)];
}

constexpr std::array kAxisWords{"x", "y", "z"};
constexpr std::array kCenterWords{"i", "j", "k"};

const char* axis_word(int axis) {
    return kAxisWords[static_cast<std::size_t>(axis)];
}
const char* center_word(int axis) {
    return kCenterWords[static_cast<std::size_t>(axis)];
}
char upper(const char* word) {
    return static_cast<char>(word[0] - 'a' + 'A');
}

bool has_word(lua_State* state, int index, const char* name) {
    const bool has = lua_getfield(state, index, name) != LUA_TNIL;
    lua_pop(state, 1);
    return has;
}

/// The words of an arc besides those of its end.
struct ArcWords final : OtherWords {
    std::array<std::optional<double>, 3> center;  // I, J, K
    std::optional<double> radius, angle, turns;

    std::optional<double>* find(std::string_view name) {
        if (name == "ar") return &angle;
        if (name.size() != 1) return nullptr;
        switch (name[0]) {
            case 'i': return center.data();
            case 'j': return &center[1];
            case 'k': return &center[2];
            case 'r': return &radius;
            case 'p': return &turns;
            default: return nullptr;
        }
    }
    bool take(std::string_view name, double value) override {
        std::optional<double>* word = find(name);
        if (word != nullptr) *word = value;
        return word != nullptr;
    }
};

/// The arc while it is read: what its words say, and where it starts.
class ArcReader {
  public:
    ArcReader(lua_State* state, Controller& controller, int index)
        : state_(state), controller_(controller), index_(index), plane_(axes_of(controller.modal().plane)) {}

    ArcMove read(bool ccw);

  private:
    [[noreturn]] void alarm(const std::string& message) { controller_.alarm(state_, message); }
    template <typename Value>
    Value value_of(tl::expected<Value, std::string> result) {
        if (!result) alarm(result.error());
        return *result;
    }

    const std::optional<double>& center_on(int axis) const {
        return words_.center[static_cast<std::size_t>(axis)];
    }
    bool has_center() const { return center_on(plane_.first) || center_on(plane_.second); }
    void check_words();
    int machine_axis(int axis);
    Vector2d in_plane(const AxisVector& point) {
        return {point[machine_axis(plane_.first)], point[machine_axis(plane_.second)]};
    }
    Eigen::Vector3d direction(int axis) const;
    void map_plane();
    Vector2d center(const Vector2d& start);
    Vector2d absolute_center(const Vector2d& center);
    ArcSolution solve(ArcEnds& ends, bool moved);
    ArcSolution by_center(ArcEnds& ends);

    lua_State* state_;
    Controller& controller_;
    int index_;
    PlaneAxes plane_;
    ArcWords words_;
    double scale_ = 1;        // of lengths in the plane, by the matrix in force
    bool same_sense_ = true;  // which it keeps
};

/// The words that say how the arc is given must not contradict each other.
void ArcReader::check_words() {
    const char first = upper(center_word(plane_.first));
    const char second = upper(center_word(plane_.second));
    if (words_.radius && (has_center() || words_.angle))
        alarm("an arc is given by its radius R, or by its centre or its angle, not by both");
    if (center_on(plane_.normal)) {
        alarm(fmt::format("{} is no centre word of the plane in force; it takes {} and {}",
                          upper(center_word(plane_.normal)), first, second));
    }
    if (!words_.radius && !words_.angle && !has_center()) {
        alarm(fmt::format("an arc needs its centre ({}, {}), its radius (R) or its angle (AR=)", first,
                          second));
    }
}

int ArcReader::machine_axis(int axis) {
    const int index = controller_.axis(axis_word(axis)[0]);
    if (index < 0) {
        alarm(fmt::format("an arc in this plane moves the axis {}, and the machine '{}' has none",
                          upper(axis_word(axis)), controller_.simulator().machine().name));
    }
    return index;
}

/// The direction of a program axis in the machine; with scaling its length is the factor.
Eigen::Vector3d ArcReader::direction(int axis) const {
    return controller_.frame().direction(Eigen::Vector3d::Unit(axis));
}

/// Rotation, scaling and mirror image: the factor of the plane's lengths, and the sense of turning.
void ArcReader::map_plane() {
    const auto [first, second, normal] = plane_;
    const Eigen::Vector3d a = direction(first);
    const Eigen::Vector3d b = direction(second);
    scale_ = std::sqrt(a[first] * a[first] + a[second] * a[second]);
    const double other = std::sqrt(b[first] * b[first] + b[second] * b[second]);
    const double determinant = a[first] * b[second] - a[second] * b[first];
    if (std::abs(a[normal]) > kRounding || std::abs(b[normal]) > kRounding) {
        alarm(
            "an arc in this plane is turned out of it by the rotation in force; cut it in the plane of the "
            "rotation");
    }
    if (std::abs(std::abs(determinant) - scale_ * scale_) > kRounding * scale_ * scale_ ||
        std::abs(scale_ - other) > kRounding * scale_) {
        alarm("an arc becomes an ellipse where its two axes are scaled differently");
    }
    same_sense_ = determinant > 0;
}

Vector2d ArcReader::absolute_center(const Vector2d& center) {
    if (!center_on(plane_.first) || !center_on(plane_.second)) {
        alarm(fmt::format("an absolute arc centre (G90.1) needs both {} and {}",
                          upper(center_word(plane_.first)), upper(center_word(plane_.second))));
    }
    const ProgramFrame& frame = controller_.frame();
    AxisVector point = frame.to_program(controller_.programmed());
    point[machine_axis(plane_.first)] = center.x();
    point[machine_axis(plane_.second)] = center.y();
    return in_plane(frame.to_machine(point));
}

/// The centre by I, J, K: a vector from the start, or where the program says so a point.
Vector2d ArcReader::center(const Vector2d& start) {
    const double unit_mm = controller_.modal().unit_mm;
    const Vector2d words{center_on(plane_.first).value_or(0) * unit_mm,
                         center_on(plane_.second).value_or(0) * unit_mm};
    if (controller_.modal().absolute_arc_centers) return absolute_center(words);
    if (!controller_.frame().has_matrix()) return {start.x() + words.x(), start.y() + words.y()};
    const Eigen::Vector3d a = direction(plane_.first);
    const Eigen::Vector3d b = direction(plane_.second);
    return {start.x() + words.x() * a[plane_.first] + words.y() * b[plane_.first],
            start.y() + words.x() * a[plane_.second] + words.y() * b[plane_.second]};
}

ArcSolution ArcReader::by_center(ArcEnds& ends) {
    const ModalState& modal = controller_.modal();
    const Vector2d about = center(ends.start);
    if (!words_.angle) return value_of(arc_by_center(ends, about, modal.arc_rules, modal.unit_mm != 1));
    if (has_word(state_, index_, axis_word(plane_.first)) ||
        has_word(state_, index_, axis_word(plane_.second))) {
        alarm("an arc by its angle AR= takes its end or its centre, not both");
    }
    const double sweep_rad = value_of(arc_angle_rad(*words_.angle));
    ends.end = end_by_angle(ends, about, sweep_rad);
    return {about, sweep_rad};
}

ArcSolution ArcReader::solve(ArcEnds& ends, bool moved) {
    if (has_center()) return by_center(ends);
    if (!words_.radius) return value_of(arc_by_angle(ends, value_of(arc_angle_rad(*words_.angle))));
    if (!moved) alarm("an arc by its radius needs its end");
    const double radius_mm = *words_.radius * controller_.modal().unit_mm * scale_;
    return value_of(arc_by_radius(ends, radius_mm, controller_.modal().arc_rules));
}

ArcMove ArcReader::read(bool ccw) {
    ArcMove move;
    const bool moved = controller_.read_target(state_, index_, &words_, move.target);
    check_words();
    ArcEnds ends{in_plane(controller_.programmed()), in_plane(move.target), ccw};
    if (controller_.frame().has_matrix()) {
        map_plane();
        ends.ccw = ccw == same_sense_;
    }
    const ArcSolution solution = solve(ends, moved);
    move.plane = controller_.modal().plane;
    move.kind = ends.ccw ? simulation::MoveKind::arc_ccw : simulation::MoveKind::arc_cw;
    move.center_first_mm = solution.center.x();
    move.center_second_mm = solution.center.y();
    move.sweep_rad = solution.sweep_rad;
    if (words_.turns)
        move.sweep_rad += value_of(further_turns_rad(*words_.turns, controller_.modal().arc_rules));
    move.target[machine_axis(plane_.first)] = ends.end.x();
    move.target[machine_axis(plane_.second)] = ends.end.y();
    return move;
}

}  // namespace

ArcMove read_arc(lua_State* state, Controller& controller, bool ccw, int index) {
    return ArcReader(state, controller, index).read(ccw);
}

}  // namespace gsim::script
