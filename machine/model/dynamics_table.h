#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace gsim::machine {

/// What moves an axis, seen at the axis: N and kg of a linear one, Nm and kg m2 of a rotary one. Forces and
/// torques count in the sense of its value.
struct Drive {
    double coulomb = 0;        ///< Friction whatever the speed.
    double viscous = 0;        ///< Friction for each mm/s (N) or deg/s (Nm).
    double rotor = 0;          ///< What turns with the motor, as a mass or moment at the axis.
    double counterweight = 0;  ///< What a balance takes off the motor.
    double peak = std::numeric_limits<double>::infinity();        ///< The most that the motor brings up,
    double continuous = std::numeric_limits<double>::infinity();  ///< and what it does as a root mean square.
    /// Speeds (mm/s or deg/s), each above the one before, and what the motor brings up there, straight in
    /// between; beyond the last one nothing. Empty: `peak` at all speeds.
    std::vector<double> curve_speeds = {};
    std::vector<double> curve_peaks = {};

    bool operator==(const Drive&) const = default;
};

/// A mass that goes with a link.
struct LinkMass {
    std::string on;  ///< The letter of an axis, "tool" or "work".
    double mass_kg = 0;
    std::array<double, 3> centre_mm{};      ///< In the frame of that.
    std::array<double, 6> inertia_kg_m2{};  ///< About the centre: xx, yy, zz, xy, yz, zx of the tensor.

    bool operator==(const LinkMass&) const = default;
};

/// A hose from a point of the world to one of a link: a tether with a drag.
struct HoseTable {
    std::string on;                     ///< The letter of an axis, "tool" or "work".
    std::array<double, 3> point_mm{};   ///< In the frame of that.
    std::array<double, 3> anchor_mm{};  ///< In the world.
    double free_length_mm = 0;
    double stiffness_n_per_mm = 0;
    double drag_n_per_mm_s = 0;

    bool operator==(const HoseTable&) const = default;
};

inline constexpr double kDownwards_m_s2 = -9.80665;  // standard gravity, CGPM 1901

/// What limits accelerations.
enum class AccelerationLimit {
    axes,    ///< max_acceleration of each axis.
    torque,  ///< What the motors' peaks allow at the places and speeds of each move.
};

/// What forces and torques come of, beside the drives of the axes and the densities of shapes.
struct DynamicsTable {
    std::array<double, 3> gravity_m_s2{0, 0, kDownwards_m_s2};  ///< In the world.
    std::vector<LinkMass> masses = {};
    std::vector<HoseTable> hoses = {};
    AccelerationLimit limit = AccelerationLimit::axes;

    bool operator==(const DynamicsTable&) const = default;
};

}  // namespace gsim::machine
