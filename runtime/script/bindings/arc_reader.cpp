#include "runtime/script/bindings/arc_reader.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "runtime/script/lua/check_option.h"
#include "runtime/script/lua/lua_state.h"
#include "runtime/script/words/arc_solution.h"

namespace gsim::script {

using text::DiagnosticKind;

using Eigen::Vector2d;
using Eigen::Vector3d;
using simulation::ArcMove;
using simulation::AxisVector;

namespace {

constexpr double kRounding = 1e-9;  // relative, of the directions of a matrix
constexpr double kMinShare = 1e-9;  // of an axis in a unit vector

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

/// Words of an arc other than those of its end.
struct ArcWords final : NonAxisWords {
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
    std::vector<std::string_view> names() const override { return {"i", "j", "k", "r", "p", "ar"}; }
    bool accept_word(std::string_view name, double value) override {
        std::optional<double>* word = find(name);
        if (word != nullptr) *word = value;
        return word != nullptr;
    }
};

/// Arc while it is read: its words, and its start.
class ArcReader {
  public:
    ArcReader(lua_State* state, Interpreter& interpreter, int index)
        : state_(state),
          interpreter_(interpreter),
          index_(index),
          plane_(plane_axes(interpreter.modal().plane)),
          normal_(Vector3d::Unit(plane_.normal)),
          first_(Vector3d::Unit(plane_.first)),
          second_(Vector3d::Unit(plane_.second)) {}

    ArcMove read(bool ccw);

  private:
    [[noreturn]] void alarm(DiagnosticKind kind, const std::string& message) {
        interpreter_.alarm(state_, kind, message);
    }
    template <typename Value>
    Value unwrap(Result<Value> result) {
        if (!result) alarm(DiagnosticKind::arc, result.error().message);
        return *result;
    }

    const std::optional<double>& center_offset(int axis) const {
        return words_.center[static_cast<std::size_t>(axis)];
    }
    bool has_center() const { return center_offset(plane_.first) || center_offset(plane_.second); }
    void check_words();
    void check_axes();
    int machine_axis(int axis);
    Vector2d in_plane(const AxisVector& point) const;
    void set_in_plane(AxisVector& point, const Vector2d& to) const;
    Vector2d in_plane(const Vector3d& vector) const { return {first_.dot(vector), second_.dot(vector)}; }
    Vector3d direction(int axis) const;
    void map_plane();
    Vector2d center(const Vector2d& start);
    Vector2d absolute_center(const Vector2d& center);
    ArcSolution solve(ArcEnds& ends, bool moved);
    ArcSolution solve_by_center(ArcEnds& ends);

    lua_State* state_;
    Interpreter& interpreter_;
    int index_;
    PlaneAxes plane_;  // of the program
    ArcWords words_;
    // The plane in the machine:
    Vector3d normal_, first_, second_;
    std::array<int, 3> axes_{};    // of X, Y and Z; -1 if the machine has none
    double scale_ = 1;             // of lengths in the plane, by the matrix in force
    bool preserves_sense_ = true;  // which it keeps
};

/// Checks that the words that give the arc do not contradict each other.
void ArcReader::check_words() {
    const char first = upper(center_word(plane_.first));
    const char second = upper(center_word(plane_.second));
    if (words_.radius && (has_center() || words_.angle))
        alarm(DiagnosticKind::code_conflict,
              "an arc must be given by its radius R, or by its centre or angle, not by both");
    if (center_offset(plane_.normal)) {
        alarm(DiagnosticKind::word_out_of_place,
              fmt::format("{} is not a centre word of the active plane; it accepts {} and {}",
                          upper(center_word(plane_.normal)), first, second));
    }
    if (!words_.radius && !words_.angle && !has_center()) {
        alarm(DiagnosticKind::word_missing,
              fmt::format("an arc needs its centre ({}, {}), its radius (R) or its angle (AR=)", first,
                          second));
    }
}

int ArcReader::machine_axis(int axis) {
    const int index = interpreter_.axis(axis_word(axis)[0]);
    if (index < 0) {
        alarm(DiagnosticKind::axis,
              fmt::format("an arc in this plane moves axis {}, which the machine '{}' does not have",
                          upper(axis_word(axis)), interpreter_.simulator().machine().name));
    }
    return index;
}

/// Checks that the axes that the arc moves exist.
void ArcReader::check_axes() {
    for (int axis = 0; axis < 3; ++axis) {
        const bool moves = std::max(std::abs(first_[axis]), std::abs(second_[axis])) > kMinShare;
        axes_[static_cast<std::size_t>(axis)] =
            moves ? machine_axis(axis) : interpreter_.axis(axis_word(axis)[0]);
    }
}

Vector2d ArcReader::in_plane(const AxisVector& point) const {
    Vector2d at = Vector2d::Zero();
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const int index = axes_[static_cast<std::size_t>(axis)];
        if (index >= 0) at += point[index] * Vector2d(first_[axis], second_[axis]);
    }
    return at;
}

void ArcReader::set_in_plane(AxisVector& point, const Vector2d& to) const {
    const Vector2d by = to - in_plane(point);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const int index = axes_[static_cast<std::size_t>(axis)];
        if (index >= 0) point[index] += by[0] * first_[axis] + by[1] * second_[axis];
    }
}

/// Returns the direction of a program axis in the machine; with scaling its length is the factor.
Vector3d ArcReader::direction(int axis) const {
    return interpreter_.frame().direction(Vector3d::Unit(axis));
}

/// Applies rotation, scaling and mirror image: the resulting plane, the factor of its lengths, and the sense
/// of turning.
void ArcReader::map_plane() {
    const Vector3d a = direction(plane_.first);
    const Vector3d b = direction(plane_.second);
    scale_ = a.norm();
    if (std::abs(a.dot(b)) > kRounding * scale_ * scale_ || std::abs(scale_ - b.norm()) > kRounding * scale_)
        alarm(DiagnosticKind::arc, "an arc becomes an ellipse if its two axes are scaled differently");
    const Vector3d turned = a.cross(b) / (scale_ * scale_);
    normal_ = simulation::canonical_normal(turned);
    preserves_sense_ = normal_.dot(turned) > 0;
    const ArcBasis basis = arc_basis(normal_);
    first_ = basis.first;
    second_ = basis.second;
}

Vector2d ArcReader::absolute_center(const Vector2d& center) {
    if (!center_offset(plane_.first) || !center_offset(plane_.second)) {
        alarm(DiagnosticKind::word_missing,
              fmt::format("an absolute arc centre (G90.1) needs both {} and {}",
                          upper(center_word(plane_.first)), upper(center_word(plane_.second))));
    }
    const ProgramFrame& frame = interpreter_.frame();
    AxisVector point = frame.to_program(interpreter_.programmed());
    point[machine_axis(plane_.first)] = center.x();
    point[machine_axis(plane_.second)] = center.y();
    return in_plane(AxisVector(frame.to_machine(point)));
}

/// Returns the centre by I, J, K: a vector from the start, or a point if the program says so.
Vector2d ArcReader::center(const Vector2d& start) {
    const double unit_mm = interpreter_.unit_mm();
    const Vector2d words{center_offset(plane_.first).value_or(0) * unit_mm,
                         center_offset(plane_.second).value_or(0) * unit_mm};
    if (interpreter_.modal().absolute_arc_centers) return absolute_center(words);
    if (!interpreter_.frame().has_matrix()) return {start.x() + words.x(), start.y() + words.y()};
    return start + words.x() * in_plane(direction(plane_.first)) +
           words.y() * in_plane(direction(plane_.second));
}

ArcSolution ArcReader::solve_by_center(ArcEnds& ends) {
    const ModalState& modal = interpreter_.modal();
    const Vector2d about = center(ends.start);
    if (!words_.angle)
        return unwrap(arc_by_center(ends, about, modal.arc_rules, interpreter_.unit_mm() != 1));
    if (has_word(state_, index_, axis_word(plane_.first)) ||
        has_word(state_, index_, axis_word(plane_.second))) {
        alarm(DiagnosticKind::code_conflict,
              "an arc given by its angle AR= needs its end or its centre, not both");
    }
    const double sweep_rad = unwrap(arc_angle_rad(*words_.angle));
    ends.end = end_by_angle(ends, about, sweep_rad);
    return {about, sweep_rad};
}

ArcSolution ArcReader::solve(ArcEnds& ends, bool moved) {
    if (has_center()) return solve_by_center(ends);
    if (!words_.radius) return unwrap(arc_by_angle(ends, unwrap(arc_angle_rad(*words_.angle))));
    if (!moved) alarm(DiagnosticKind::word_missing, "an arc given by its radius needs its end");
    const double radius_mm = *words_.radius * interpreter_.unit_mm() * scale_;
    return unwrap(arc_by_radius(ends, radius_mm, interpreter_.modal().arc_rules));
}

ArcMove ArcReader::read(bool ccw) {
    ArcMove move;
    const bool moved = interpreter_.read_target(state_, index_, &words_, move.target);
    check_words();
    if (interpreter_.frame().has_matrix()) map_plane();
    check_axes();
    ArcEnds ends{in_plane(interpreter_.programmed()), in_plane(move.target), ccw == preserves_sense_};
    const ArcSolution solution = solve(ends, moved);
    move.normal = normal_;
    move.kind = ends.ccw ? simulation::MoveKind::arc_ccw : simulation::MoveKind::arc_cw;
    move.center_mm = solution.center.x() * first_ + solution.center.y() * second_;
    move.sweep_rad = solution.sweep_rad;
    if (words_.turns)
        move.sweep_rad += unwrap(additional_turns_rad(*words_.turns, interpreter_.modal().arc_rules));
    if (words_.angle && has_center()) set_in_plane(move.target, ends.end);
    return move;
}

void push_vector(lua_State* state, const Vector3d& vector) {
    lua_createtable(state, 0, 3);
    for (int axis = 0; axis < 3; ++axis) {
        lua_pushnumber(state, vector[axis]);
        lua_setfield(state, -2, axis_word(axis));
    }
}

constexpr std::array<const char*, 4> kPlanes{"xy", "zx", "yz", nullptr};

Vector3d check_vector_field(lua_State* state, int index, const char* name) {
    lua_getfield(state, index, name);
    luaL_argcheck(state, lua_type(state, -1) == LUA_TTABLE, index,
                  "a plane must be a name, or { first = {x=, y=, z=}, second = {...} }");
    Vector3d vector;
    for (int axis = 0; axis < 3; ++axis) vector[axis] = number_field(state, -1, axis_word(axis));
    lua_pop(state, 1);
    return vector;
}

}  // namespace

Plane check_plane(lua_State* state, int argument) {
    return static_cast<Plane>(check_option(state, argument, nullptr, kPlanes));
}

void push_plane(lua_State* state, Plane plane) {
    lua_pushstring(state, kPlanes[static_cast<std::size_t>(plane)]);
}

ArcBasis arc_basis(const Vector3d& normal) {
    if (const auto plane = simulation::main_plane(normal)) {
        const PlaneAxes axes = plane_axes(*plane);
        return {Vector3d::Unit(axes.first), Vector3d::Unit(axes.second)};
    }
    const Vector3d first = normal.unitOrthogonal();
    return {first, normal.cross(first)};
}

ArcBasis check_arc_plane(lua_State* state, int argument) {
    if (lua_type(state, argument) != LUA_TTABLE)
        return arc_basis(simulation::plane_normal(check_plane(state, argument)));
    return {check_vector_field(state, argument, "first"), check_vector_field(state, argument, "second")};
}

void push_arc_plane(lua_State* state, const Vector3d& normal) {
    if (const auto plane = simulation::main_plane(normal)) {
        const std::string_view name = gsim::name(*plane);
        lua_pushlstring(state, name.data(), name.size());
        return;
    }
    const ArcBasis basis = arc_basis(normal);
    lua_createtable(state, 0, 2);
    push_vector(state, basis.first);
    lua_setfield(state, -2, "first");
    push_vector(state, basis.second);
    lua_setfield(state, -2, "second");
}

ArcMove read_arc(lua_State* state, Interpreter& interpreter, bool ccw, int index) {
    return ArcReader(state, interpreter, index).read(ccw);
}

}  // namespace gsim::script
