#include "cam/drawing/svg_path.h"

#include <array>
#include <cctype>
#include <numbers>

#include <fmt/format.h>

#include "base/units.h"
#include "cam/drawing/svg_values.h"

namespace gsim::drawing {

using geometry::Point;

namespace {

class PathReader {
  public:
    PathReader(std::string_view data, Pen& pen) : scanner_(data), pen_(pen) {}

    Result<void> run() {
        while (!scanner_.at_end()) {
            const std::optional<char> letter = scanner_.letter();
            if (letter) {
                command_ = *letter;
            } else if (command_ == 0 || command_ == 'Z' || command_ == 'z') {
                return syntax_error("a command is missing");
            }
            if (!begun_ && command_ != 'M' && command_ != 'm')
                return syntax_error("it does not begin with M");
            if (!draw())
                return syntax_error(
                    fmt::format("command {} is unknown, or its numbers are not complete", command_));
            if (pen_.error()) return tl::unexpected(*pen_.error());
            previous_command_ = static_cast<char>(std::toupper(command_));
            // Further pairs of a move are lines.
            if (command_ == 'M') command_ = 'L';
            if (command_ == 'm') command_ = 'l';
        }
        return {};
    }

  private:
    Unexpected syntax_error(const std::string& what) const {
        return Unexpected(fmt::format("has path data that cannot be read at character {}: {}",
                                      scanner_.offset() + 1, what));
    }

    bool is_relative() const { return command_ >= 'a'; }

    std::optional<Point> point() {
        const std::optional<double> x = scanner_.number();
        const std::optional<double> y = scanner_.number();
        if (!x || !y) return {};
        return is_relative() ? current_ + Point{*x, *y} : Point{*x, *y};
    }

    bool draw() {
        switch (std::toupper(command_)) {
            case 'M': return move();
            case 'L': return line(point());
            case 'H': return level();
            case 'V': return vertical_line();
            case 'C': return cubic(true);
            case 'S': return cubic(false);
            case 'Q': return quadratic(true);
            case 'T': return quadratic(false);
            case 'A': return arc();
            case 'Z': return close();
            default: return false;
        }
    }

    bool move() {
        const std::optional<Point> to = point();
        if (!to) return false;
        begun_ = true;
        start_ = current_ = *to;
        pen_.move_to(*to);
        return true;
    }

    bool line(std::optional<Point> to) {
        if (!to) return false;
        current_ = *to;
        pen_.line_to(*to);
        return true;
    }

    bool level() {
        const std::optional<double> x = scanner_.number();
        return x && line(Point{is_relative() ? current_.x + *x : *x, current_.y});
    }

    bool vertical_line() {
        const std::optional<double> y = scanner_.number();
        return y && line(Point{current_.x, is_relative() ? current_.y + *y : *y});
    }

    bool close() {
        pen_.close();
        current_ = start_;
        return true;
    }

    // Returns the mirror image of the last control point if the command before was of that kind, else the
    // current point.
    Point mirrored(char kind, char shorthand) const {
        return previous_command_ == kind || previous_command_ == shorthand ? 2.0 * current_ - control_
                                                                           : current_;
    }

    bool cubic(bool has_both_controls) {
        const std::optional<Point> first = has_both_controls ? point() : mirrored('C', 'S');
        const std::optional<Point> second = point();
        const std::optional<Point> to = point();
        if (!first || !second || !to) return false;
        curve(*first, *second, *to);
        control_ = *second;
        return true;
    }

    bool quadratic(bool has_control_point) {
        const std::optional<Point> control_point = has_control_point ? point() : mirrored('Q', 'T');
        const std::optional<Point> to = point();
        if (!control_point || !to) return false;
        control_ = *control_point;
        const Point from = current_;
        curve((1.0 / 3) * (from + 2.0 * control_), (1.0 / 3) * (*to + 2.0 * control_), *to);
        return true;
    }

    void curve(Point first, Point second, Point to) {
        pen_.nurbs(bezier(current_, first, second, to));
        current_ = to;
    }

    // Converts ends, radii and flags to the centre, as in SVG 1.1, F.6.
    bool arc() {
        const std::optional<double> rx = scanner_.number();
        const std::optional<double> ry = scanner_.number();
        const std::optional<double> turn_deg = scanner_.number();
        const std::optional<bool> large = scanner_.flag();
        const std::optional<bool> positive = scanner_.flag();
        const std::optional<Point> to = point();
        if (!rx || !ry || !turn_deg || !large || !positive || !to) return false;
        if (*rx == 0 || *ry == 0 || *to == current_) return line(to);
        const Affine axes = turned(*turn_deg * kRadPerDeg) * scaled(std::abs(*rx), std::abs(*ry));
        // In the coordinates of the axes the ellipse is the unit circle.
        const double scale = cross(axes.x, axes.y);
        const auto inward = [&](Point p) {
            return Point{cross(p, axes.y) / scale, cross(axes.x, p) / scale};
        };
        const Point half = inward(0.5 * (*to - current_));
        const double reach = length(half);
        const double grow = std::max(1.0, reach);  // radii that are too small for the ends grow
        const double height = std::sqrt(std::max(0.0, grow * grow - reach * reach));
        const Point lateral = (height / reach) * left_normal(half);
        const Point middle = *large == *positive ? -1.0 * lateral : lateral;
        const double from_rad = std::atan2(-half.y - middle.y, -half.x - middle.x);
        double sweep = std::atan2(half.y - middle.y, half.x - middle.x) - from_rad;
        if (*positive && sweep <= 0) sweep += 2 * std::numbers::pi;
        if (!*positive && sweep >= 0) sweep -= 2 * std::numbers::pi;
        const Point center = 0.5 * (current_ + *to) + axes.direction(middle);
        pen_.arc({center, grow * axes.x, grow * axes.y, from_rad, sweep});
        current_ = *to;
        pen_.line_to(*to);  // what rounding left over
        return true;
    }

    SvgScanner scanner_;
    Pen& pen_;
    char command_ = 0;
    char previous_command_ = 0;
    bool begun_ = false;
    Point start_, current_, control_;
};

}  // namespace

Result<void> draw_path_data(std::string_view data, Pen& pen) {
    return PathReader(data, pen).run();
}

}  // namespace gsim::drawing
