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

/// A point or a direction in the work frame: x, y, z.
using Vector = std::array<double, 3>;

/// How the tool goes to a point from the one before; `none`: it stands there already.
enum class MotionType { rapid, linear, circular, none };

/// The direction of the tool's axis, from its tip to its spindle or nozzle, in the work frame; of any length
/// above 0. The turn about it is left to the machine.
struct ToolAxis {
    Vector direction{0, 0, 1};

    bool operator==(const ToolAxis&) const = default;
};

/// The whole orientation of the tool in the work frame: Rz(roll) Ry(pitch) Rx(yaw).
struct RollPitchYaw {
    double roll_deg = 0, pitch_deg = 0, yaw_deg = 0;

    bool operator==(const RollPitchYaw&) const = default;
};

/// The machine's rotary axes as programs give them, by letter, in deg.
using RotaryAxes = std::map<char, double>;

using Orientation = std::variant<ToolAxis, RollPitchYaw, RotaryAxes>;

/// An arc through a point between its ends, in any plane of space; the ends differ.
struct ViaPoint {
    Vector via_mm{};

    bool operator==(const ViaPoint&) const = default;
};

/// An arc about a centre: the sense of `normal` by the right hand, any angle above 0, also more than a full
/// turn. What the end is off the circle's plane along `normal` makes it a helix.
struct CenterArc {
    Vector center_mm{};
    Vector normal{0, 0, 1};
    double turn_deg = 0;

    bool operator==(const CenterArc&) const = default;
};

/// A geometric point (thesis 6.2): where the tool goes, how it goes there, and what is done on arrival. What
/// is left out is as at the point before.
struct Point {
    std::string name;
    MotionType motion = MotionType::linear;
    Vector position_mm{};
    std::variant<ViaPoint, CenterArc> arc;  ///< Of a circular motion.
    std::optional<Orientation> orientation;
    std::optional<double> feed_mm_min;   ///< > 0; where rotary axes alone move, feed_deg_min counts.
    std::optional<double> feed_deg_min;  ///< > 0
    std::optional<double> duration_s;    ///< > 0; of this motion alone, in place of a feed.
    std::optional<double> feed_mm_rev;   ///< > 0; with feed_mm_min: what that is in a turn of the spindle.
    std::optional<double> lead_mm;       ///< > 0; of this line alone: in step with the spindle, in a turn.
    std::string work_offset;             ///< From here on: a name of Program::work_offsets; empty: as before.
    std::optional<double> acceleration_mm_s2;  ///< > 0
    double dwell_s = 0;                        ///< On arrival, before the actions.
    std::vector<std::string>
        actions;  ///< On arrival, in this order: "waterjet_on", "abrasive_off", or any other name.

    bool operator==(const Point&) const = default;
};

/// Of a tool or an offset.
inline constexpr int kGreatestToolNumber = 99'999'999;

/// A straight way along one axis, until the tool touches something, by which a program finds where a work
/// coordinate system lies along that axis.
struct Touch {
    char axis = 'Z';             ///< X, Y or Z.
    Vector from_mm{};            ///< Where the way begins: X, Y and Z, counted as the system lies before.
    double to_mm = 0;            ///< Where it ends along the axis if it touches nothing.
    double surface_mm = 0;       ///< Where what it touches lies along the axis in the system as it is behind.
    double feed_mm_min = 0;      ///< > 0
    double probe_radius_mm = 0;  ///< >= 0; of the ball that touches, along X and Y.
    std::optional<int> tool =
        {};  ///< That touches, with the length offset of its number; none: the one there is.

    bool operator==(const Touch&) const = default;
};

/// The work coordinate system that positions are counted in.
struct WorkFrame {
    std::string name = {};  ///< "54", "59.1"; empty: that of the user.
    std::optional<Vector> set_offset_mm =
        {};                           ///< Where the program itself puts it: X, Y and Z of the machine.
    std::vector<Touch> touches = {};  ///< By which the program finds where it lies, behind that.

    bool operator==(const WorkFrame&) const = default;
};

/// A tool and the offsets that go with it, by their numbers in the control.
struct Tool {
    int number = 0;                           ///< >= 0
    int length_offset = 0;                    ///< >= 0; 0: none is in force.
    std::optional<int> diameter_offset = {};  ///< >= 0; without it none is called.

    bool operator==(const Tool&) const = default;
};

/// Another path, gone through `repeats` times.
struct SubPath {
    std::size_t path = 0;  ///< Index in Program::paths.
    int repeats = 1;       ///< >= 1
    WorkFrame frame = {};  ///< That it is used in, in place of its own.

    bool operator==(const SubPath&) const = default;
};

/// A place of the machine's axes that the control, or its data, knows. The machine goes there by a rapid, in
/// machine coordinates; where that is in the work nobody knows, so that what follows is a rapid, too.
struct MachinePoint {
    enum class Kind {
        fixed,     ///< An entry of FIXED of the machine data.
        reference  ///< A home position of the control, which goes there by a word of its own; by a name, an
                   ///< entry of REFERENCE of the machine data.
    };
    std::string name = {};  ///< For people.
    Kind kind = Kind::fixed;
    int number = 0;  ///< Above 0, of a reference point 1 to 4; or 0: its name in the machine data counts.
    std::string called = {};                ///< That name, in any case.
    double dwell_s = 0;                     ///< On arrival, before the actions.
    std::vector<std::string> actions = {};  ///< On arrival, in this order.
    /// Machine coordinates by axis letter, mm or deg. No path file has them: who has the machine data fills
    /// them in. Of a reference point that nobody knows they are empty.
    std::map<char, double> axes = {};

    bool operator==(const MachinePoint&) const = default;
};

/// Of a number that the machine data give a fixed point.
inline constexpr int kGreatestFixedPoint = 99'999;
/// How many reference points there are.
inline constexpr int kReferencePoints = 4;

using Target = std::variant<Point, SubPath, MachinePoint>;

/// A list of targets, gone through in order.
struct Path {
    std::string name;
    std::vector<Target> targets;
    WorkFrame frame = {};           ///< Not in recorded programs, whose points say it.
    std::optional<Tool> tool = {};  ///< None: the one that is in the spindle.

    bool operator==(const Path&) const = default;
};

/// How deep sub-paths may be nested; the root path is not counted (thesis, example 6.1).
inline constexpr int kMaxDepth = 8;

/// Where a work coordinate system of the machine lies.
struct WorkOffset {
    std::map<char, double> origin;  ///< By axis letter, mm or deg.
    double rotation_deg = 0;        ///< About Z.

    bool operator==(const WorkOffset&) const = default;
};

/// A root path and the paths that it uses. Well formed (validate()) if no path leads back to itself and none
/// is nested deeper than kMaxDepth.
struct Program {
    std::string name;
    std::vector<Path> paths;
    std::size_t root = 0;  ///< Index in `paths`.
    /// Of a recorded program: the systems that it used, by name ("54"), as the machine had them.
    std::map<std::string, WorkOffset, std::less<>> work_offsets = {};

    /// Whether it was recorded from a run: then it begins where the machine stood, and says what offsets were
    /// in force.
    bool is_recorded() const { return !work_offsets.empty(); }
    bool operator==(const Program&) const = default;
};

/// A work coordinate system as paths name it: "55" for "G55" as well.
std::string frame_name(std::string_view text);

/// What a machine point is called in sentences: "the fixed point 'CLAMP1'", "the reference point 2".
std::string title_of(const MachinePoint& point);

/// What is done on arrival at a target; nothing of a sub-path.
const std::vector<std::string>& actions_of(const Target& target);

/// The frame of a sub-path, where the use or the path itself names one; else that of the user.
const WorkFrame& frame_of(const Program& program, const SubPath& use);

}  // namespace gsim::path
