#pragma once

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

/// One controller's way of writing programs (docs/paths.md). Templates hold {number}, {title}, {program},
/// {lower}, {unit}, {repeats}, {label}, {seconds}, {milliseconds} and {acceleration}.
struct Post {
    std::string name;
    std::string reads_as;  ///< The dialect of gcode2lua that reads these programs.
    int decimals_mm = 3, decimals_inch = 4, decimals_deg = 3, decimals_feed = 3;
    Zeros zeros = Zeros::cut;
    int number_step = 0;    ///< Between block numbers; 0: none.
    int number_digits = 0;  ///< Block numbers are filled up with zeros to so many digits.
    std::string axes;       ///< Letters of the axes that the controller has; empty: any.
    std::string dwell;
    std::string
        start_position;  ///< Word of a block that names where the tool stands at the start; may be empty.
    std::vector<std::string> acceleration;      ///< Lines that set it; empty: the controller has no words.
    std::vector<std::string> end_acceleration;  ///< Lines that take it back, at the program's end.
    std::vector<std::string> begin, end;        ///< Of the program.
    std::optional<SubprogramLines> subprogram;  ///< None: sub-paths are written where they are used.
    std::map<std::string, std::string, std::less<>> actions;  ///< Action to block; others become comments.

    bool operator==(const Post&) const = default;
};

/// What the places of a template stand for.
using Places = std::map<std::string, std::string, std::less<>>;

/// A template with its places filled in; those that `places` lacks stay.
std::string filled(std::string_view line, const Places& places);

}  // namespace gsim::codegen
