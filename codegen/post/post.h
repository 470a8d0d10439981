#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gsim::codegen {

/// End of a number: 500.000, 500. or 500.
enum class TrailingZeros { keep, point, cut };

/// Subprogram for a sub-path. Lines are templates, see Post.
struct SubprogramLines {
    bool before_program = false;  ///< Subprograms come before the program that calls them.
    std::vector<std::string> begin, end, call, call_repeated;
    std::string file;  ///< Name of its file, if each has one.

    bool operator==(const SubprogramLines&) const = default;
};

/// Numbers of a program.
struct NumberDigits {
    int decimals_mm = 3, decimals_inch = 4, decimals_deg = 3, decimals_feed = 3;
    std::optional<int> decimals_recorded_mm;  ///< For recorded paths; not set: decimals_mm.
    TrailingZeros zeros = TrailingZeros::cut;

    bool operator==(const NumberDigits&) const = default;
};

/// Blocks of a program.
struct BlockFormat {
    int number_step = 0;    ///< Between block numbers; 0: no numbers.
    int number_digits = 0;  ///< Block numbers are filled up with zeros to so many digits.
    std::string axes;       ///< Letters of the axes that the controller has; empty: any.
    std::string dwell;      ///< Template with {seconds} or {milliseconds}.
    std::string
        start_position;  ///< Word of a block with the position of the tool at the start; may be empty.

    bool operator==(const BlockFormat&) const = default;
};

/// Words of an arc through a point: its code, and the letters of X, Y and Z of the point.
struct ThroughPointWords {
    std::string code;
    std::array<std::string, 3> letters;

    bool operator==(const ThroughPointWords&) const = default;
};

/// Arcs that the controller has beyond those by their centre in a plane of the axes.
struct ArcAbilities {
    std::string turns_letter;  ///< Letter of the number of circles that an arc begins; empty: max one.
    std::optional<ThroughPointWords>
        through_point;             ///< For arcs in any plane; not set: the controller has no word.
    bool rejects_oblique = false;  ///< Those it has no word for; otherwise they become lines.

    bool operator==(const ArcAbilities&) const = default;
};

/// Words of a line in step with the spindle; empty: not supported.
struct ThreadWords {
    std::string code;
    std::string lead;  ///< The letter of its lead.

    bool operator==(const ThreadWords&) const = default;
};

/// Lines for accelerations; empty: the controller has no words.
struct AccelerationLines {
    std::vector<std::string> set;
    std::vector<std::string> end;  ///< Lines that cancel it, at the program's end.

    bool operator==(const AccelerationLines&) const = default;
};

/// Words for an F that is no feed per minute. Empty: the controller has no word.
struct FeedModes {
    std::string per_minute, inverse_time, per_revolution;
    bool inverse_time_by_angle = false;  ///< F of an arc is the inverse of its time for a radian.

    bool operator==(const FeedModes&) const = default;
};

/// Words by which a recorded program finds the positions of the machine again. Empty: the controller has no
/// word.
struct OffsetWords {
    std::string system;                ///< Template with {system}: selects a work coordinate system.
    std::vector<std::string> systems;  ///< That it has; programs begin in the first one.
    std::string set;                   ///< Template with {index} (from 1), {x}, {y} and {z}: sets a system.
    std::string machine;             ///< In front of a line or a rapid: its numbers are machine coordinates.
    std::string preset;              ///< Before axis words: the present position has these coordinates.
    std::vector<std::string> begin;  ///< Lines that cancel all other offsets.
    std::vector<std::string> end;    ///< Lines that cancel the effect of `preset`.

    bool operator==(const OffsetWords&) const = default;
};

/// Words of the controller for its home positions.
struct ReferenceWords {
    std::vector<std::string> go;   ///< A template with {axes} for each of those that it has.
    std::vector<std::string> end;  ///< Lines that cancel what these leave active.

    bool operator==(const ReferenceWords&) const = default;
};

/// Outputs that the word for the tool change stops by itself, because paths do not define it.
struct ToolChangeWords {
    bool stops_spindle = false;
    bool stops_coolant = false;

    bool operator==(const ToolChangeWords&) const = default;
};

/// Program format of one controller (docs/paths.md). Templates hold {number}, {title}, {program}, {lower},
/// {unit}, {repeats}, {label}, {seconds}, {milliseconds}, {acceleration}, {system}, {index}, {x}, {y}, {z},
/// {axes}, {axis}, {number}, {to}, {feed} and {surface}.
struct Post {
    std::string name;
    std::string dialect;  ///< The dialect of gcode2lua that reads these programs.
    NumberDigits numbers;
    BlockFormat blocks;
    ArcAbilities arcs;
    ThreadWords thread;
    FeedModes feed_modes;
    OffsetWords offsets;
    ReferenceWords references;
    std::vector<std::string> touch;  ///< Lines that find a work offset along one axis; empty: it cannot.
    ToolChangeWords tool_change;
    AccelerationLines acceleration;
    std::vector<std::string> begin, end;        ///< Lines of the program.
    std::optional<SubprogramLines> subprogram;  ///< Not set: sub-paths are written at their use.
    std::map<std::string, std::string, std::less<>> actions;  ///< See ActionBlocks.

    bool operator==(const Post&) const = default;
};

/// Values of the placeholders of a template.
using PlaceholderValues = std::map<std::string, std::string, std::less<>>;

/// Returns a template with its placeholders filled in; those that `placeholders` lacks stay.
std::string fill_template(std::string_view line, const PlaceholderValues& placeholders);

}  // namespace gsim::codegen
