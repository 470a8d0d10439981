#include "tests/toolpath/random_path.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "toolpath/model/arc_shape.h"

namespace gsim::path {

namespace {

using Eigen::Vector3d;

class Generator {
  public:
    Generator(std::mt19937& random, const RandomPathOptions& options) : random_(random), options_(options) {}

    Program program() {
        Program path_program;
        path_program.name = "random";
        for (int i = 0; i <= options_.sub_paths; ++i) {
            path_program.paths.push_back({fmt::format("path {}", i), {}});
            fill(path_program.paths.back().targets, static_cast<std::size_t>(i));
        }
        path_program.root = path_program.paths.size() - 1;
        return path_program;
    }

  private:
    double number(double low, double high) {
        // Three decimals, as programs have them.
        return std::round(std::uniform_real_distribution<double>(low, high)(random_) * 1000) / 1000;
    }
    int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(random_); }
    bool chance(int percent) { return below(100) < percent; }
    Vector somewhere() { return {number(100, 400), number(100, 400), number(100, 400)}; }

    void fill(std::vector<Target>& targets, std::size_t users_index) {
        targets.push_back(first_point());
        for (int count = 2 + below(8); count > 0; --count) {
            if (options_.machine_points && chance(15)) {
                targets.push_back(machine_point());
                Point behind = first_point();
                behind.motion = MotionType::rapid;
                targets.push_back(behind);
            } else if (users_index > 0 && chance(25)) {
                targets.push_back(
                    SubPath{static_cast<std::size_t>(below(static_cast<int>(users_index))), 1 + below(3)});
                targets.push_back(first_point());
            } else {
                targets.push_back(next_point());
            }
        }
    }

    Point first_point() {
        Point point;
        point.motion = chance(50) ? MotionType::rapid : MotionType::linear;
        point.position_mm = last_position_mm_ = somewhere();
        point.feed_mm_min = number(100, 5000);
        if (options_.orientations) point.orientation = turned();
        return point;
    }

    MachinePoint machine_point() {
        MachinePoint point;
        point.kind = chance(50) ? MachinePoint::Kind::fixed : MachinePoint::Kind::reference;
        const bool is_reference = point.kind == MachinePoint::Kind::reference;
        if (chance(50)) {
            point.number = 1 + below(is_reference ? kReferencePointCount : kMaxFixedPoint);
        } else {
            point.alias = fmt::format("P{}_x", below(100));
        }
        if (chance(30)) point.name = fmt::format("P \"{}\" \u00e4", below(100));
        if (chance(30)) point.dwell_s = number(0.1, 2);
        if (chance(30)) point.actions = {"clamp (left)", "waterjet_off"};
        return point;
    }

    RotaryAxes turned() { return {{'B', number(-170, 170)}, {'C', number(-80, 80)}}; }

    Point next_point() {
        Point point;
        point.position_mm = somewhere();
        if (chance(40)) {
            make_arc(point);
        } else {
            point.motion = chance(20) ? MotionType::rapid : MotionType::linear;
        }
        if (options_.orientations && chance(50)) point.orientation = turned();
        if (chance(20)) point.feed_mm_min = number(100, 5000);
        if (options_.extras) add_extras(point);
        last_position_mm_ = point.position_mm;
        return point;
    }

    void make_arc(Point& point) {
        point.motion = MotionType::circular;
        if (options_.tilted_arcs && chance(40)) {
            point.arc = ViaPoint{somewhere()};
            return;
        }
        CenterArc arc;
        const std::array<Vector, 6> normals{Vector{0, 0, 1},  Vector{0, 0, -1}, Vector{0, 1, 0},
                                            Vector{0, -1, 0}, Vector{1, 0, 0},  Vector{-1, 0, 0}};
        arc.normal = normals[static_cast<std::size_t>(below(6))];
        const Vector3d start = to_eigen(last_position_mm_);
        const Vector3d normal = to_eigen(arc.normal);
        Vector3d radius = to_eigen({number(-60, 60), number(-60, 60), number(-60, 60)});
        radius -= normal * normal.dot(radius);
        if (radius.norm() < 5) radius = normal.unitOrthogonal() * 20;
        arc.turn_deg = chance(20) ? 360.0 * (1 + below(2)) : number(5, 700);
        const double angle = arc.turn_deg * std::numbers::pi / 180;
        const Vector3d center = start - radius;
        const Vector3d end = center + Eigen::AngleAxisd(angle, normal) * radius +
                             normal * (chance(50) ? number(-20, 20) : 0.0);
        arc.center_mm = {center.x(), center.y(), center.z()};
        point.position_mm = {end.x(), end.y(), end.z()};
        point.arc = arc;
    }

    void add_extras(Point& point) {
        if (chance(10)) point.name = fmt::format("P \"{}\" \u00e4", below(100));
        if (chance(10)) point.dwell_s = number(0.1, 2);
        if (chance(10)) point.actions = {"waterjet_on"};
        if (chance(10)) point.actions = {"abrasive_off", "waterjet_off", "clamp (left)"};
        if (chance(5)) point.acceleration_mm_s2 = number(100, 500);
        if (chance(5)) point.duration_s = number(1, 20);
    }

    std::mt19937& random_;
    const RandomPathOptions& options_;
    Vector last_position_mm_{};
};

}  // namespace

Program random_program(std::mt19937& random, const RandomPathOptions& options) {
    return Generator(random, options).program();
}

}  // namespace gsim::path
