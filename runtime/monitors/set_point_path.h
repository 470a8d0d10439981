#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <deque>

namespace gsim::simulation {

/// Path of the TCP's recent set points, of lines and of curves by their ends and slopes.
class SetPointPath {
  public:
    /// End of a part: a point, and its change over the part's parameter, which runs from 0 to 1.
    struct EndPoint {
        Eigen::Vector3d point_mm;
        Eigen::Vector3d slope_mm;
    };

    /// Forgets everything; the TCP is here.
    void begin(const Eigen::Vector3d& at_mm);
    /// Adds a line at the end of the path; with `extends_last` the last part, which is a line, is extended.
    void add_line(const Eigen::Vector3d& to_mm, double end_s, bool extends_last);
    /// Adds a part of a curve, as the polynomial of third order with these ends.
    void add_curve(const EndPoint& from, const EndPoint& to, double end_s);
    /// Forgets the path before that time, except the last part.
    void discard_before(double t_s);

    /// Returns the distance of a point from the path.
    double distance_mm(const Eigen::Vector3d& point_mm);

  private:
    static constexpr std::size_t kMaxSubSegments = 100'000;

    struct SubSegment {
        Eigen::Vector3d from, to;
        Eigen::Vector3d slope_deviation_from,
            slope_deviation_to;        ///< By which the slopes differ from the chord; 0 of a line.
        double bulge_mm = 0;           ///< No point of it is farther from the chord.
        double length_mm = 0;          ///< It is not longer,
        double start_distance_mm = 0;  ///< nor are all parts up to its start.
        double end_s = 0;

        Eigen::Vector3d at(double share) const;
        double distance_mm(const Eigen::Vector3d& point_mm, double enough_mm) const;
    };

    void add(SubSegment sub_segment);
    std::size_t before(std::size_t sub_segment, double skipped_mm) const;

    Eigen::Vector3d end_mm_ = Eigen::Vector3d::Zero();
    std::deque<SubSegment> sub_segments_;
    std::size_t nearest_ = 0;  ///< Part at which the last point was nearest.
};

}  // namespace gsim::simulation
