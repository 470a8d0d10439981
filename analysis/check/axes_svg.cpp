#include <cmath>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

#include "analysis/check/axis_motion.h"
#include "base/text/format.h"

namespace gsim::check {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kSize = 440;             // of the picture above its text, in its units
constexpr double kArrowLength = 130;      // of an arrow
constexpr double kFrameArrowLength = 55;  // of the work frame's axes
constexpr double kArrowHead = 9;          // of an arrow
constexpr double kWidth = 640;
constexpr double kLineHeight = 18;      // of the messages below
constexpr double kTurnRadius = 26;      // of the arrow of a turn
constexpr double kTurnPosition = 0.62;  // position of a turn on its axis, as a share of the reach
constexpr int kTurnSteps = 24;
constexpr double kTurnShare = 0.8;    // of a full turn that the arrow spans
constexpr double kArrowSpacing = 20;  // between arrows of the same direction
constexpr double kMinParallelCosine = 0.999;

// Projects a point as seen from the front, the right and above: x to the right, y into the picture, z up.
Vector2d project(const Vector3d& point) {
    constexpr double kDepthShiftRight = 0.45;
    constexpr double kDepthShiftUp = 0.38;
    return {point.x() + kDepthShiftRight * point.y(), -(point.z() + kDepthShiftUp * point.y())};
}

// Colours.
constexpr const char* kFrameColour = "#777777";
constexpr const char* kToolColour = "#1f4e79";
constexpr const char* kWorkColour = "#a04000";
constexpr const char* kErrorColour = "#b00020";

const char* axis_colour(const AxisMotion& motion) {
    return motion.carries_work ? kWorkColour : kToolColour;
}

// Returns some direction at right angles to another one.
Vector3d perpendicular(const Vector3d& direction) {
    constexpr double kVerticalLimit = 0.9;
    return direction.cross(std::abs(direction.z()) < kVerticalLimit ? Vector3d::UnitZ() : Vector3d::UnitX())
        .normalized();
}

class Picture {
  public:
    explicit Picture(const machine::Machine& machine)
        : motions_(axis_motions(machine)), errors_(find_left_handed_axes(motions_)) {}

    std::string release() {
        const double height = kSize + kLineHeight * static_cast<double>(motions_.size() + errors_.size() + 2);
        add("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
            "font-family=\"sans-serif\" font-size=\"13\" stroke-width=\"2.5\">\n",
            kWidth, height);
        draw_frame();
        for (std::size_t i = 0; i < motions_.size(); ++i) {
            motions_[i].is_rotary ? draw_rotary_axis(motions_[i]) : draw_linear_axis(i);
        }
        write_messages();
        return std::move(svg_) + "</svg>\n";
    }

  private:
    template <typename... Args>
    void add(fmt::format_string<Args...> format, Args&&... args) {
        text::append_format(svg_, format, std::forward<Args>(args)...);
    }

    static Vector2d to_paper(const Vector3d& point) {
        return Vector2d(kWidth / 2, kSize / 2) + project(point);
    }

    // Draws a line through points of the paper, with a head at its end.
    void draw_arrow(const char* colour, const std::vector<Vector2d>& points) {
        add("<path fill=\"none\" stroke=\"{}\" d=\"", colour);
        char command = 'M';
        for (const Vector2d& point : points) {
            add("{}{:.1f} {:.1f}", command, point.x(), point.y());
            command = 'L';
        }
        const Vector2d& end = points.back();
        const Vector2d along = (end - points[points.size() - 2]).normalized();
        const Vector2d normal(-along.y(), along.x());
        const Vector2d left = end - kArrowHead * (along + normal / 2);
        const Vector2d right = end - kArrowHead * (along - normal / 2);
        const Vector2d arrow_tip = end + kArrowHead / 3 * along;
        add("\"/>\n<path fill=\"{}\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\"/>\n", colour,
            arrow_tip.x(), arrow_tip.y(), left.x(), left.y(), right.x(), right.y());
    }

    void label(const char* colour, const Vector2d& at, std::string_view text) {
        add("<text fill=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", colour, at.x() + 8, at.y() - 4, text);
    }

    // Draws the work frame itself, in a separate corner.
    void draw_frame() {
        const Vector3d corner(-3 * kFrameArrowLength, 0, -3 * kFrameArrowLength);
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            const Vector2d end = to_paper(corner + kFrameArrowLength * Vector3d::Unit(axis));
            draw_arrow(kFrameColour, {to_paper(corner), end});
            label(kFrameColour, end, std::string_view("xyz").substr(static_cast<std::size_t>(axis), 1));
        }
        label(kFrameColour, to_paper(corner) + Vector2d(-10, kLineHeight + 6), "work frame");
    }

    // Shifts arrows that would lie on one another, so that they are side by side.
    Vector3d lateral_offset(std::size_t index) const {
        const Vector3d& direction = motions_[index].direction;
        int before = 0;
        for (std::size_t i = 0; i < index; ++i) {
            const AxisMotion& other = motions_[i];
            if (!other.is_rotary && std::abs(other.direction.dot(direction)) > kMinParallelCosine) ++before;
        }
        return before * kArrowSpacing * perpendicular(direction);
    }

    void draw_linear_axis(std::size_t index) {
        const AxisMotion& motion = motions_[index];
        const Vector3d start = lateral_offset(index);
        const Vector2d end = to_paper(start + kArrowLength * motion.direction);
        draw_arrow(axis_colour(motion), {to_paper(start), end});
        label(axis_colour(motion), end, fmt::format("+{}", motion.letter));
    }

    void draw_rotary_axis(const AxisMotion& motion) {
        const Vector3d first = perpendicular(motion.direction);
        const Vector3d second = motion.direction.cross(first);
        std::vector<Vector2d> points;
        for (int step = 0; step <= kTurnSteps; ++step) {
            const double angle = 2 * std::numbers::pi * kTurnShare * step / kTurnSteps;
            points.push_back(to_paper(kTurnPosition * kArrowLength * motion.direction +
                                      kTurnRadius * (std::cos(angle) * first + std::sin(angle) * second)));
        }
        draw_arrow(axis_colour(motion), points);
        label(axis_colour(motion), points.back(), fmt::format("+{}", motion.letter));
    }

    void write_messages() {
        double y = kSize + kLineHeight;
        const auto line = [&](const char* colour, const std::string& text) {
            label(colour, {kLineHeight, y}, text);
            y += kLineHeight;
        };
        line(kFrameColour,
             "blue: the tool moves; brown: the workpiece moves, drawn as the motion of the tool relative to "
             "it");
        for (const AxisMotion& motion : motions_) line(axis_colour(motion), to_message(motion));
        for (const std::string& error : errors_) line(kErrorColour, error);
    }

    std::vector<AxisMotion> motions_;
    std::vector<std::string> errors_;
    std::string svg_;
};

}  // namespace

std::string axes_svg(const machine::Machine& machine) {
    return Picture(machine).release();
}

}  // namespace gsim::check
