#pragma once

#include <Eigen/Core>
#include <string>

namespace gsim::process {

/// Belt that carries things in a straight line. Its speed is constant from one change to the next.
class Conveyor {
  public:
    /// Sets `direction`, a unit vector of the world in which the belt's position grows. It runs with
    /// `speed_mm_s` (which may be negative) from time 0 on, at position 0.
    Conveyor(std::string name, const Eigen::Vector3d& direction, double speed_mm_s)
        : name_(std::move(name)), direction_(direction), speed_mm_s_(speed_mm_s) {}

    const std::string& name() const { return name_; }
    const Eigen::Vector3d& direction() const { return direction_; }
    double speed_mm_s() const { return speed_mm_s_; }
    /// Returns the travel at a time that is not before the last change of speed.
    double position_mm(double time_s) const { return position_mm_ + speed_mm_s_ * (time_s - last_change_s_); }
    /// Sets the speed from `time_s` on, which is not before the last change.
    void set_speed(double speed_mm_s, double time_s);
    /// Returns when it has travelled that far, from `time_s` on, if it keeps its speed: `time_s` if it has
    /// passed there, infinity if it is at standstill elsewhere.
    double arrival_time_s(double position_mm, double time_s) const;

  private:
    std::string name_;
    Eigen::Vector3d direction_;
    double speed_mm_s_;
    double position_mm_ = 0;  ///< At last_change_s_.
    double last_change_s_ = 0;
};

}  // namespace gsim::process
