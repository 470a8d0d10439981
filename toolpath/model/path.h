#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gsim::path {

/// Point or direction in the work frame: x, y, z.
using Vector = std::array<double, 3>;

/// Motion of the tool to a point from the previous one; `none`: it is already there.
enum class MotionType { rapid, linear, circular, none };

/// Direction of the tool's axis, from its tip to its spindle or nozzle, in the work frame; of any length
/// above 0. The machine chooses the rotation about it.
struct ToolAxis {
    Vector direction{0, 0, 1};

    bool operator==(const ToolAxis&) const = default;
};

/// Full orientation of the tool in the work frame: Rz(roll) Ry(pitch) Rx(yaw).
struct RollPitchYaw {
    double roll_deg = 0, pitch_deg = 0, yaw_deg = 0;

    bool operator==(const RollPitchYaw&) const = default;
};

/// Machine's rotary axes as programs give them, by letter, in deg.
using RotaryAxes = std::map<char, double>;

using Orientation = std::variant<ToolAxis, RollPitchYaw, RotaryAxes>;

/// Arc through a point between its ends, in any plane of space; the ends differ.
struct ViaPoint {
    Vector via_mm{};

    bool operator==(const ViaPoint&) const = default;
};

/// Arc about a centre: the sense of `normal` by the right-hand rule, any angle above 0, also more than a full
/// turn. An end off the circle's plane along `normal` makes it a helix.
struct CenterArc {
    Vector center_mm{};
    Vector normal{0, 0, 1};
    double turn_deg = 0;

    bool operator==(const CenterArc&) const = default;
};

/// Geometric point (thesis 6.2): the tool position, the motion to it, and the actions on arrival. Omitted
/// values are as at the previous point.
struct Point {
    std::string name;
    MotionType motion = MotionType::linear;
    Vector position_mm{};
    std::variant<ViaPoint, CenterArc> arc;  ///< For a circular motion.
    std::optional<Orientation> orientation;
    std::optional<double> feed_mm_min;   ///< > 0; if only rotary axes move, feed_deg_min counts.
    std::optional<double> feed_deg_min;  ///< > 0
    std::optional<double> duration_s;    ///< > 0; for this motion only, instead of a feed.
    std::optional<double> feed_mm_rev;   ///< > 0; with feed_mm_min: what that is in a turn of the spindle.
    std::optional<double> lead_mm;       ///< > 0; of this line alone: in step with the spindle, in a turn.
    std::string work_offset;             ///< From here on: a name of Program::work_offsets; empty: as before.
    std::optional<double> acceleration_mm_s2;  ///< > 0
    double dwell_s = 0;                        ///< On arrival, before the actions.
    std::vector<std::string>
        actions;  ///< On arrival, in this order: "waterjet_on", "abrasive_off", or any other name.

    bool operator==(const Point&) const = default;
};

/// Max number of a tool or an offset.
inline constexpr int kMaxToolNumber = 99'999'999;

/// Straight path along one axis, until the tool touches something. A program uses it to find the position of
/// a work coordinate system along that axis.
struct Touch {
    char axis = 'Z';        ///< X, Y or Z.
    Vector from_mm{};       ///< Start of the path: X, Y and Z, in the system as it lies before.
    double to_mm = 0;       ///< End along the axis if it touches nothing.
    double surface_mm = 0;  ///< Position of the touched surface along the axis, in the system as it is after.
    double feed_mm_min = 0;      ///< > 0
    double probe_radius_mm = 0;  ///< >= 0; of the ball that touches, along X and Y.
    std::optional<int> tool =
        {};  ///< Tool that touches, with the length offset of its number; nullopt: current tool.

    bool operator==(const Touch&) const = default;
};

/// Work coordinate system that positions refer to.
struct WorkFrame {
    std::string name = {};  ///< "54", "59.1"; empty: that of the user.
    std::optional<Vector> set_offset_mm =
        {};                           ///< Position that the program itself sets: X, Y and Z of the machine.
    std::vector<Touch> touches = {};  ///< By which the program finds its position, after that.

    bool operator==(const WorkFrame&) const = default;
};

/// Tool and its offsets, by their numbers in the controller.
struct Tool {
    int number = 0;                           ///< >= 0
    int length_offset = 0;                    ///< >= 0; 0: no active offset.
    std::optional<int> diameter_offset = {};  ///< >= 0; nullopt: not called.

    bool operator==(const Tool&) const = default;
};

/// Another path, run `repeats` times.
struct SubPath {
    std::size_t path = 0;  ///< Index in Program::paths.
    int repeats = 1;       ///< >= 1
    WorkFrame frame = {};  ///< Frame of this use, instead of the path's own.

    bool operator==(const SubPath&) const = default;
};

/// Position of the machine's axes that the controller, or its data, knows. The machine moves there by a
/// rapid, in machine coordinates. Its position in the work is unknown, so the next motion is a rapid, too.
struct MachinePoint {
    enum class Kind {
        fixed,     ///< An entry of FIXED of the machine data.
        reference  ///< Home position of the controller, reached by a special word; by a name, an entry of
                   ///< REFERENCE of the machine data.
    };
    std::string name = {};  ///< For people.
    Kind kind = Kind::fixed;
    int number = 0;  ///< Above 0, of a reference point 1 to 4; or 0: its name in the machine data counts.
    std::string alias = {};                 ///< That name, in any case.
    double dwell_s = 0;                     ///< On arrival, before the actions.
    std::vector<std::string> actions = {};  ///< On arrival, in this order.
    /// Machine coordinates by axis letter, mm or deg. No path file has them: a caller with the machine data
    /// fills them in. They are empty for an unknown reference point.
    std::map<char, double> axes = {};

    bool operator==(const MachinePoint&) const = default;
};

/// Max number of a fixed point in the machine data.
inline constexpr int kMaxFixedPoint = 99'999;
/// Number of reference points.
inline constexpr int kReferencePointCount = 4;

using Target = std::variant<Point, SubPath, MachinePoint>;

/// List of targets, run in order.
struct Path {
    std::string name;
    std::vector<Target> targets;
    WorkFrame frame = {};           ///< Not in recorded programs; their points have it.
    std::optional<Tool> tool = {};  ///< Nullopt: the one in the spindle.

    bool operator==(const Path&) const = default;
};

/// Max nesting depth of sub-paths; the root path is not counted (thesis, example 6.1).
inline constexpr int kMaxDepth = 8;

/// Position of a work coordinate system of the machine.
struct WorkOffset {
    std::map<char, double> origin;  ///< By axis letter, mm or deg.
    double rotation_deg = 0;        ///< About Z.

    bool operator==(const WorkOffset&) const = default;
};

/// Root path and the paths that it uses. Well formed (validate()) if no path leads back to itself and no path
/// is nested deeper than kMaxDepth.
struct Program {
    std::string name;
    std::vector<Path> paths;
    std::size_t root = 0;  ///< Index in `paths`.
    /// Systems that a recorded program used, by name ("54"), as the machine had them.
    std::map<std::string, WorkOffset, std::less<>> work_offsets = {};

    /// Returns true if it was recorded from a run: then it begins at the machine's position, and contains the
    /// active offsets.
    bool is_recorded() const { return !work_offsets.empty(); }
    bool operator==(const Program&) const = default;
};

/// Returns the name of a work coordinate system as paths use it: "55" for "G55" as well.
std::string frame_name(std::string_view text);

/// Returns the name of a machine point in messages: "the fixed point 'CLAMP1'", "the reference point 2".
std::string point_title(const MachinePoint& point);

/// Returns the actions on arrival at a target; empty for a sub-path.
const std::vector<std::string>& target_actions(const Target& target);

/// Returns the frame of a sub-path, if the use or the path itself names one; otherwise that of the user.
const WorkFrame& sub_path_frame(const Program& program, const SubPath& sub_path_call);

}  // namespace gsim::path
