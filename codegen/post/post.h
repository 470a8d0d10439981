#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gsim::codegen {

/// How a number ends: 500.000, 500. or 500.
enum class Zeros { keep, point, cut };

/// What a sub-path becomes. Lines are templates, see Post.
struct SubprogramLines {
    bool before_program = false;  ///< Subprograms stand above the program that calls them.
    std::vector<std::string> begin, end, call, call_repeated;
    std::string file;  ///< Name of its file, where each has one.

    bool operator==(const SubprogramLines&) const = default;
};

/// The words of an arc through a point: its code, and the letters of X, Y and Z of the point.
struct ThroughPoint {
    std::string code;
    std::array<std::string, 3> letters;

    bool operator==(const ThroughPoint&) const = default;
};

/// How a controller is told that F is no feed per minute. Empty words: it has none.
struct FeedModes {
    std::string per_minute, inverse_time, per_revolution;
    bool inverse_time_by_angle = false;  ///< F of an arc is the inverse of its time for a radian.

    bool operator==(const FeedModes&) const = default;
};

/// How a recorded program finds the places of the machine again. Empty words: the controller has none.
struct OffsetWords {
    std::string system;                ///< Template with {system}: selects a work coordinate system.
    std::vector<std::string> systems;  ///< That it has; programs begin in the first one.
    std::string set;                   ///< Template with {index} (from 1), {x}, {y} and {z}: sets a system.
    std::string machine;  ///< In front of a line or a rapid: its numbers are machine coordinates.
    std::string here;     ///< In front of axis words: where the machine stands has these coordinates.
    std::vector<std::string> begin;  ///< Lines that take back all other offsets.
    std::vector<std::string> end;    ///< Lines that take back what `here` has done.

    bool operator==(const OffsetWords&) const = default;
};

/// How the control goes to its home positions.
struct ReferenceWords {
    std::vector<std::string> go;   ///< A template with {axes} for each of those that it has.
    std::vector<std::string> end;  ///< Lines that take back what these leave in force.

    bool operator==(const ReferenceWords&) const = default;
};

/// What the word for the change of the tool stops by itself, as paths do not say.
struct ToolChangeWords {
    bool stops_spindle = false;
    bool stops_coolant = false;

    bool operator==(const ToolChangeWords&) const = default;
};

/// One controller's way of writing programs (docs/paths.md). Templates hold {number}, {title}, {program},
/// {lower}, {unit}, {repeats}, {label}, {seconds}, {milliseconds}, {acceleration}, {system}, {index}, {x},
/// {y}, {z}, {axes}, {axis}, {number}, {to}, {feed} and {surface}.
struct Post {
    std::string name;
    std::string reads_as;  ///< The dialect of gcode2lua that reads these programs.
    int decimals_mm = 3, decimals_inch = 4, decimals_deg = 3, decimals_feed = 3;
    std::optional<int> decimals_recorded_mm;  ///< Of recorded paths; none: decimals_mm.
    Zeros zeros = Zeros::cut;
    int number_step = 0;    ///< Between block numbers; 0: none.
    int number_digits = 0;  ///< Block numbers are filled up with zeros to so many digits.
    std::string axes;       ///< Letters of the axes that the controller has; empty: any.
    std::string dwell;
    std::string
        start_position;  ///< Word of a block that names where the tool stands at the start; may be empty.
    std::string turns_of_arcs;  ///< The letter of how many circles an arc begins; empty: one at most.
    std::optional<ThroughPoint> through_point;  ///< Of arcs in any plane; none: the controller has no word.
    bool refuses_oblique_arcs = false;          ///< Those it has no word for; otherwise they become lines.
    std::string thread;       ///< Word of a line in step with the spindle; empty: the controller has none.
    std::string thread_lead;  ///< The letter of its lead.
    FeedModes feed_modes;
    OffsetWords offsets;
    ReferenceWords references;
    std::vector<std::string> touch;  ///< Lines that find a work offset along one axis; empty: it cannot.
    ToolChangeWords tool_change;
    std::vector<std::string> acceleration;      ///< Lines that set it; empty: the controller has no words.
    std::vector<std::string> end_acceleration;  ///< Lines that take it back, at the program's end.
    std::vector<std::string> begin, end;        ///< Of the program.
    std::optional<SubprogramLines> subprogram;  ///< None: sub-paths are written where they are used.
    std::map<std::string, std::string, std::less<>> actions;  ///< See ActionWords.

    bool operator==(const Post&) const = default;
};

/// What the places of a template stand for.
using Places = std::map<std::string, std::string, std::less<>>;

/// A template with its places filled in; those that `places` lacks stay.
std::string filled(std::string_view line, const Places& places);

}  // namespace gsim::codegen
