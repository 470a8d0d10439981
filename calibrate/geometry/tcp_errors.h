#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "calibrate/geometry/deviation.h"
#include "calibrate/geometry/measured_tcp.h"

namespace gsim::calibrate {

inline constexpr double kMicrometresPerMm = 1000;
inline constexpr double kArcsecPerDeg = 3600;

/// Noise of measurements, as standard deviations: of each coordinate, and of the rotation about each axis.
struct Noise {
    double mm = 0.01;
    double deg = 0.003;
};

/// Difference between a measured TCP and that of a geometry, in directions of the frame of measurement.
struct TcpError {
    Eigen::Vector3d mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d deg = Eigen::Vector3d::Zero();  ///< As a rotation vector; 0 if none was measured.
};

std::vector<TcpError> tcp_errors(const Geometry& geometry, std::span<const MeasuredTcp> tcps);

/// Root mean square and maximum of the errors' lengths.
struct TcpErrorSummary {
    double rms_um = 0, max_um = 0;
    double rms_arcsec = 0, max_arcsec = 0;
};
TcpErrorSummary summarize_errors(std::span<const TcpError> errors);

/// Errors of TCPs as one vector in units of their noise: 3 numbers for each TCP, 6 for one with orientation.
/// Noise in a line of the list has priority over `noise`.
class WeightedErrors {
  public:
    WeightedErrors(const DeviatedMachine& machine, std::span<const Deviation> deviations,
                   std::span<const MeasuredTcp> tcps, const Noise& noise);

    Eigen::Index size() const { return first_row_.back(); }
    Eigen::Index count() const { return static_cast<Eigen::Index>(tcps_.size()); }
    Eigen::Index first(Eigen::Index tcp) const { return first_row_[static_cast<std::size_t>(tcp)]; }
    Eigen::Index size(Eigen::Index tcp) const { return first(tcp + 1) - first(tcp); }

    Eigen::VectorXd at(const Eigen::VectorXd& values) const;
    /// Returns the derivatives of the errors by the values: central differences, accurate to 1e-7 of them.
    Eigen::MatrixXd slopes(const Eigen::VectorXd& values) const;

  private:
    const DeviatedMachine& machine_;
    std::span<const Deviation> deviations_;
    std::span<const MeasuredTcp> tcps_;
    Noise noise_;
    std::vector<Eigen::Index> first_row_;
};

}  // namespace gsim::calibrate
