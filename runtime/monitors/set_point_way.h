#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <deque>

namespace gsim::simulation {

/// The way of the tip's set points over the last while, of lines and of curves by their ends and slopes.
class SetPointWay {
  public:
    /// An end of a piece: a point, and how the point changes over the piece's parameter, which goes from 0 to
    /// 1.
    struct End {
        Eigen::Vector3d point_mm;
        Eigen::Vector3d slope_mm;
    };

    /// Forgets all; the tip stands here.
    void begin(const Eigen::Vector3d& at_mm);
    /// A line that goes on where the way ends; with `longer` the last piece, which is a line, becomes longer.
    void add_line(const Eigen::Vector3d& to_mm, double end_s, bool longer);
    /// A piece of a curve, as the polynomial of third order with these ends.
    void add_curve(const End& from, const End& to, double end_s);
    /// What was gone through before is forgotten, but for the last piece.
    void forget_before(double t_s);

    /// How far a point is from the way.
    double distance_mm(const Eigen::Vector3d& point_mm);

  private:
    static constexpr std::size_t kMost = 100'000;

    struct Piece {
        Eigen::Vector3d from, to;
        Eigen::Vector3d bend_from, bend_to;  ///< By which the slopes differ from the chord; 0 of a line.
        double bulge_mm = 0;                 ///< No point of it is farther from the chord.
        double length_mm = 0;                ///< It is not longer,
        double behind_mm = 0;                ///< nor are all pieces up to its start.
        double end_s = 0;

        Eigen::Vector3d at(double share) const;
        double distance_mm(const Eigen::Vector3d& point_mm, double enough_mm) const;
    };

    void add(Piece piece);
    std::size_t before(std::size_t piece, double skipped_mm) const;

    Eigen::Vector3d end_mm_ = Eigen::Vector3d::Zero();
    std::deque<Piece> pieces_;
    std::size_t near_ = 0;  ///< Where the last point was found nearest.
};

}  // namespace gsim::simulation
