#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace gsim::machine {

/// The drive of an axis, seen at the axis: N and kg for a linear one, Nm and kg m2 for a rotary one. Forces
/// and torques count in the sense of its value.
struct Drive {
    double coulomb_friction = 0;  ///< Friction whatever the speed.
    double viscous = 0;           ///< Friction for each mm/s (N) or deg/s (Nm).
    double rotor = 0;             ///< Inertia that turns with the motor, as a mass or moment at the axis.
    double counterweight = 0;     ///< Load that a balance takes off the motor.
    double peak = std::numeric_limits<double>::infinity();        ///< Max force or torque of the motor,
    double continuous = std::numeric_limits<double>::infinity();  ///< and what it does as a root mean square.
    /// Speeds (mm/s or deg/s), each above the one before, and the motor's max there, linear in between; 0
    /// beyond the last one. Empty: `peak` at all speeds.
    std::vector<double> curve_speeds = {};
    std::vector<double> curve_peaks = {};

    bool operator==(const Drive&) const = default;
};

/// A mass that moves with a link.
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

inline constexpr double kGravity_m_s2 = -9.80665;  // standard gravity, CGPM 1901

/// Source of the limits of accelerations.
enum class AccelerationLimit {
    axes,    ///< max_acceleration of each axis.
    torque,  ///< Motor peaks at the positions and speeds of each move.
};

/// Causes of forces and torques, other than the drives of the axes and the densities of shapes.
struct DynamicsTable {
    std::array<double, 3> gravity_m_s2{0, 0, kGravity_m_s2};  ///< In the world.
    std::vector<LinkMass> masses = {};
    std::vector<HoseTable> hoses = {};
    AccelerationLimit limit = AccelerationLimit::axes;

    bool operator==(const DynamicsTable&) const = default;
};

}  // namespace gsim::machine
