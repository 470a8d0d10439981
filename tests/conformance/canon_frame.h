#pragma once

#include <span>

#include "tests/conformance/move.h"

namespace gsim::conformance {

/// Precision of canonical output: four digits after the point.
inline constexpr double kPrinted = 0.00005;

/// A point and how far the printed digits leave it open, mm and deg.
struct PrintedPoint {
    AxisValues at{};
    AxisValues tolerance{};
};

/// State that relates printed coordinates to those of the machine.
class CanonFrame {
  public:
    void set_unit(double mm) { unit_mm_ = mm; }
    double unit_mm() const { return unit_mm_; }

    /// Offsets in the unit in force now, for the first axes of kAxes.
    void set_work_offset(std::span<const double> values) { work_ = offset(values); }
    void set_g92_offset(std::span<const double> values) { g92_ = offset(values); }
    void set_tool_offset(std::span<const double> values) { tool_ = offset(values); }
    void set_rotation_deg(double angle_deg) { rotation_deg_ = angle_deg; }

    /// A point of the program, for all axes of kAxes, in the unit in force now.
    PrintedPoint to_machine(const AxisValues& printed) const;
    /// A direction of the program.
    Vector turned(const Vector& direction) const;

  private:
    PrintedPoint offset(std::span<const double> values) const;
    void rotate(PrintedPoint& point) const;

    double unit_mm_ = 1;
    double rotation_deg_ = 0;
    PrintedPoint work_;
    PrintedPoint g92_;
    PrintedPoint tool_;
};

}  // namespace gsim::conformance
