#pragma once

#include <Eigen/Geometry>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tests/lua_lib/roundtrip/roundtrip_units.h"

namespace gsim::roundtrip {

inline constexpr std::string_view kAxes = "XYZABCUVW";
using Point = Eigen::Matrix<double, 9, 1>;  ///< In the order of kAxes, mm and deg.

/// Axes of the planes G17, G18, G19: first, second, normal.
inline constexpr std::array<std::array<Eigen::Index, 3>, 3> kPlanes{{{0, 1, 2}, {2, 0, 1}, {1, 2, 0}}};

enum class Kind { rapid, linear, arc, dwell };

/// A move as it must come out.
struct Move {
    Kind kind = Kind::rapid;
    Point end = Point::Zero();
    double length_mm = 0;
    double feed_per_min = 0;       ///< mm/min, or deg/min if only rotary axes move.
    std::optional<double> time_s;  ///< If the program has it: a dwell, inverse time feed.
    // Arcs only:
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< Any point of the axis.
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();   ///< About which it runs by the right hand, unit.
    int turns = 0;                                     ///< 1 up to a full circle, 2 for one more turn, ..
};

/// A block with the values of its words; a vacant variable has left out its word.
struct ReadBlock {
    std::set<std::string> codes;
    std::map<std::string, double> words;

    bool has(const std::string& code) const { return codes.contains(code); }
    std::optional<double> word(const std::string& letter) const {
        const auto found = words.find(letter);
        return found == words.end() ? std::nullopt : std::optional<double>(found->second);
    }
    bool has_axis() const {
        for (const char axis : kAxes)
            if (words.contains(std::string(1, axis))) return true;
        return false;
    }
};

/// Common part of both dialects: modal state, position, lines and arcs. A dialect adds its offsets and its
/// order of execution.
class Control {
  public:
    Control() = default;
    Control(const Control&) = delete;
    Control& operator=(const Control&) = delete;
    virtual ~Control() = default;

    virtual void run(const ReadBlock& block) = 0;
    /// Returns the value of a variable that the controller keeps itself, or none for others.
    virtual std::optional<double> variable(int number) const = 0;

    const std::vector<Move>& moves() const { return moves_; }

  protected:
    using Space = Eigen::Affine3d;

    /// The map of program coordinates X Y Z to those of the machine, and the offsets of the other axes.
    virtual Space space() const = 0;
    virtual Point other_offsets() const = 0;
    /// Seconds of an arc with inverse time feed F1.
    virtual double inverse_time_of_arc_s(double sweep_rad) const = 0;

    Point to_machine(const Point& program) const;
    Point to_program(const Point& machine) const;
    Point program_point() const { return to_program(position_); }
    double length(std::size_t axis, double value) const { return is_rotary(axis) ? value : value * unit_mm_; }
    static bool is_rotary(std::size_t axis) { return axis >= 3 && axis < 6; }
    /// Calls use(axis, value in mm or deg) for each axis word.
    template <class Use>
    void each_axis(const ReadBlock& block, Use use) const {
        for (std::size_t i = 0; i < kAxes.size(); ++i)
            if (const auto value = block.word(std::string(1, kAxes[i]))) use(i, length(i, *value));
    }

    void select_plane(const ReadBlock& block);
    void select_units(const ReadBlock& block);
    void select_distance(const ReadBlock& block);
    void select_system(const ReadBlock& block);
    void select_feed_mode(const ReadBlock& block);
    void set_feed(const ReadBlock& block);
    void dwell(double seconds);

    /// The end of a move in program coordinates.
    Point program_target(const ReadBlock& block) const;
    void go(bool rapid, const Point& machine);
    void line(bool rapid, const ReadBlock& block);
    void arc(bool counterclockwise, const ReadBlock& block);

    Point position_ = Point::Zero();
    double unit_mm_ = 1;
    bool incremental_ = false;
    bool arc_centre_is_point_ = false;
    int plane_ = 0;
    std::size_t system_ = 0;    ///< G54 is 0
    bool return_to_r_ = false;  ///< G99
    std::string motion_;

  private:
    struct Circle {
        Eigen::Vector2d centre;
        double sweep_rad;
    };
    Circle circle_by_centre(const ReadBlock& block, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                            bool ccw) const;
    static Circle circle_by_radius(double radius, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                   bool ccw);
    void add(Move move);

    std::vector<Move> moves_;
    double feed_ = 0, feed_unit_mm_ = 1;
    bool inverse_time_ = false;
};

}  // namespace gsim::roundtrip
