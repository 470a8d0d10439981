#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "calibrate/geometry/deviation.h"
#include "calibrate/geometry/measured_tip.h"

namespace gsim::calibrate {

inline constexpr double kMicrometresPerMm = 1000;
inline constexpr double kArcsecPerDeg = 3600;

/// Noise of measurements, as standard deviations: of each coordinate, and of the rotation about each axis.
struct Noise {
    double mm = 0.01;
    double deg = 0.003;
};

/// Difference between a measured TCP and that of a geometry, in directions of the frame of measurement.
struct TipError {
    Eigen::Vector3d mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d deg = Eigen::Vector3d::Zero();  ///< As a rotation vector; 0 if none was measured.
};

std::vector<TipError> tip_errors(const Geometry& geometry, std::span<const MeasuredTip> tips);

/// Root mean square and maximum of the errors' lengths.
struct TipSummary {
    double rms_um = 0, greatest_um = 0;
    double rms_arcsec = 0, greatest_arcsec = 0;
};
TipSummary summary_of(std::span<const TipError> errors);

/// Errors of TCPs as one vector in units of their noise: 3 numbers for each TCP, 6 for one with orientation.
/// Noise in a line of the list has priority over `noise`.
class WeightedErrors {
  public:
    WeightedErrors(const DeviatedMachine& machine, std::span<const Deviation> deviations,
                   std::span<const MeasuredTip> tips, const Noise& noise);

    Eigen::Index size() const { return first_.back(); }
    Eigen::Index count() const { return static_cast<Eigen::Index>(tips_.size()); }
    Eigen::Index first(Eigen::Index tip) const { return first_[static_cast<std::size_t>(tip)]; }
    Eigen::Index size(Eigen::Index tip) const { return first(tip + 1) - first(tip); }

    Eigen::VectorXd at(const Eigen::VectorXd& values) const;
    /// Returns the derivatives of the errors by the values: central differences, accurate to 1e-7 of them.
    Eigen::MatrixXd slopes(const Eigen::VectorXd& values) const;

  private:
    const DeviatedMachine& machine_;
    std::span<const Deviation> deviations_;
    std::span<const MeasuredTip> tips_;
    Noise noise_;
    std::vector<Eigen::Index> first_;
};

}  // namespace gsim::calibrate
