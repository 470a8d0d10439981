#include "base/text/diagnostic_kind.h"

#include <algorithm>
#include <array>

namespace gsim::text {

namespace {

using Kind = DiagnosticKind;

constexpr std::array kKinds = {
    DiagnosticKindEntry{Kind::character, "character", "a character that is not valid in this dialect"},
    DiagnosticKindEntry{Kind::number, "number", "a number that is malformed, too long or not an integer"},
    DiagnosticKindEntry{Kind::syntax, "syntax", "a block, a comment or a name that is not valid"},
    DiagnosticKindEntry{Kind::word_without_value, "word-without-value", "a letter without its value"},
    DiagnosticKindEntry{Kind::word_out_of_place, "word-out-of-place",
                        "a word that no code in its block uses"},
    DiagnosticKindEntry{Kind::word_twice, "word-twice", "a word or a code that is given twice"},
    DiagnosticKindEntry{Kind::word_missing, "word-missing", "a code lacks a required word"},
    DiagnosticKindEntry{Kind::word_value, "word-value", "a value that the word or the call does not accept"},
    DiagnosticKindEntry{Kind::code_unknown, "code-unknown",
                        "a code that the dialect or the machine does not have"},
    DiagnosticKindEntry{Kind::code_unsupported, "code-unsupported",
                        "a code of the controller that is not simulated"},
    DiagnosticKindEntry{Kind::code_conflict, "code-conflict", "codes or words that exclude each other"},
    DiagnosticKindEntry{Kind::code_idle, "code-idle", "a code that has no effect in its block"},
    DiagnosticKindEntry{Kind::structure, "structure",
                        "a loop, a condition or a subroutine that is not closed or not open"},
    DiagnosticKindEntry{Kind::jump, "jump",
                        "the target block of a GOTO or M99 P does not exist or cannot be reached by a jump"},
    DiagnosticKindEntry{Kind::program_twice, "program-twice",
                        "a program or a subroutine that is defined twice"},
    DiagnosticKindEntry{Kind::program_missing, "program-missing",
                        "a called program or subroutine that does not exist or is not readable"},
    DiagnosticKindEntry{Kind::too_large, "too-large",
                        "a line, a block or a program that exceeds the max size"},
    DiagnosticKindEntry{Kind::too_many_errors, "too-many-errors",
                        "the remaining part of a program was not checked"},
    DiagnosticKindEntry{Kind::units, "units",
                        "the program seems to be in another unit than the one in which it is read"},
    DiagnosticKindEntry{Kind::dialect, "dialect",
                        "the program seems to be of another dialect, or its controller is only similar"},
    DiagnosticKindEntry{Kind::axis_limit, "axis-limit", "an axis would exceed its range"},
    DiagnosticKindEntry{Kind::zone, "zone",
                        "the tool enters a forbidden zone, or leaves a zone that it must stay in"},
    DiagnosticKindEntry{Kind::unreachable, "unreachable",
                        "a pose that the machine cannot reach or pass through"},
    DiagnosticKindEntry{Kind::arc, "arc", "an arc or a curve that its words do not define"},
    DiagnosticKindEntry{Kind::compensation, "compensation", "cutter compensation that is not possible here"},
    DiagnosticKindEntry{Kind::corner, "corner", "a corner word (,C ,R ,A) that its moves do not permit"},
    DiagnosticKindEntry{Kind::feed, "feed", "a feed that is missing or not valid"},
    DiagnosticKindEntry{Kind::spindle, "spindle", "a spindle speed or state that is not valid for the code"},
    DiagnosticKindEntry{Kind::tool, "tool", "a tool or an offset that is not in the table"},
    DiagnosticKindEntry{Kind::mode, "mode", "a word that the active modes do not permit"},
    DiagnosticKindEntry{Kind::frame, "frame", "an offset, a rotation or a scale that is not valid"},
    DiagnosticKindEntry{Kind::axis, "axis",
                        "an axis that the machine does not have, or that is of the wrong kind"},
    DiagnosticKindEntry{Kind::home, "home", "a home position that is not defined, or not reached"},
    DiagnosticKindEntry{Kind::variable, "variable",
                        "a variable or parameter that does not exist, or cannot be read or set"},
    DiagnosticKindEntry{Kind::arithmetic, "arithmetic", "an expression without a value"},
    DiagnosticKindEntry{Kind::nesting, "nesting", "calls, loops or brackets that are nested too deep"},
    DiagnosticKindEntry{Kind::input_output, "input-output", "an input, output or print that is not valid"},
    DiagnosticKindEntry{Kind::probe, "probe", "a probe that finds nothing, or begins in contact"},
    DiagnosticKindEntry{Kind::program_alarm, "program-alarm", "an alarm that the program raises"},
    DiagnosticKindEntry{Kind::script, "script", "an error in a script"},
    DiagnosticKindEntry{Kind::service, "service",
                        "a service of the motion planner, or of a controller module, that failed"},
    DiagnosticKindEntry{Kind::process, "process",
                        "processes, signals, robots or conveyors that are not consistent"},
    DiagnosticKindEntry{Kind::machine, "machine", "the machine is not in the required state"},
    DiagnosticKindEntry{Kind::run_limit, "run-limit",
                        "a limit of time, blocks, steps, processor time or memory ended the run"},
    DiagnosticKindEntry{Kind::passes, "passes", "a program that returns to its start"},
    DiagnosticKindEntry{Kind::warning, "warning", "information about a run, in its text"},
    DiagnosticKindEntry{Kind::collision, "collision", "two bodies of the cell or the machine touch"},
    DiagnosticKindEntry{Kind::near_miss, "near-miss", "two bodies come closer than the cell's clearance"},
    DiagnosticKindEntry{Kind::rapid_with_process_on, "rapid-with-process-on",
                        "a rapid while the process is on"},
    DiagnosticKindEntry{Kind::dwell_with_process_on, "dwell-with-process-on",
                        "a long dwell while the process is on"},
    DiagnosticKindEntry{Kind::end_with_process_on, "end-with-process-on",
                        "the program ends while the process is on"},
    DiagnosticKindEntry{Kind::feed_with_process_off, "feed-with-process-off",
                        "a cutting move while the process is off"},
    DiagnosticKindEntry{Kind::feed_with_spindle_off, "feed-with-spindle-off",
                        "a cutting move while the spindle is off"},
    DiagnosticKindEntry{Kind::motor_peak, "motor-peak",
                        "a move that needs more force or torque than a motor can deliver"},
    DiagnosticKindEntry{Kind::motor_continuous, "motor-continuous",
                        "a run that needs more force or torque than a motor can deliver continuously"},
    DiagnosticKindEntry{Kind::usage, "usage", "options that are not valid or exclude each other"},
    DiagnosticKindEntry{Kind::file, "file", "a file that cannot be read or written"},
    DiagnosticKindEntry{Kind::input_file, "input-file",
                        "an error in a file other than a program: machine, cell, post, drawing, ..."},
    DiagnosticKindEntry{Kind::path, "path",
                        "a path that cannot be created, or cannot be written for this controller"},
    DiagnosticKindEntry{Kind::output, "output", "an output that cannot be written"},
    DiagnosticKindEntry{Kind::internal, "internal", "an internal error of the program"},
};

}  // namespace

std::span<const DiagnosticKindEntry> diagnostic_kinds() {
    return kKinds;
}

std::string_view diagnostic_code(DiagnosticKind kind) {
    return kKinds.at(static_cast<std::size_t>(kind)).code;
}

std::optional<DiagnosticKind> diagnostic_kind(std::string_view code) {
    const auto* found =
        std::find_if(kKinds.begin(), kKinds.end(), [&](const auto& entry) { return entry.code == code; });
    return found == kKinds.end() ? std::nullopt : std::optional(found->kind);
}

}  // namespace gsim::text
