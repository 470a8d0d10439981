#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace gsim::text {

/// What a diagnostic is about. Each kind has a code that stays the same from release to release
/// (docs/diagnostics.md), so that other programs can sort and suppress by it.
enum class DiagnosticKind : std::uint8_t {
    // Of a program's text.
    character,
    number,
    syntax,
    word_without_value,
    word_out_of_place,
    word_twice,
    word_missing,
    word_value,
    code_unknown,
    code_unsupported,
    code_conflict,
    code_idle,
    structure,
    jump,
    program_twice,
    program_missing,
    too_large,
    too_many_errors,
    units,
    dialect,
    // Of a run.
    axis_limit,
    zone,
    unreachable,
    arc,
    compensation,
    corner,
    feed,
    spindle,
    tool,
    mode,
    frame,
    axis,
    home,
    variable,
    arithmetic,
    nesting,
    input_output,
    probe,
    program_alarm,
    script,
    service,
    process,
    machine,
    run_limit,
    passes,
    warning,
    // Of a cell.
    collision,
    near_miss,
    // Of the process that cuts (jet, plasma, laser, spindle).
    rapid_with_process_on,
    dwell_with_process_on,
    end_with_process_on,
    feed_with_process_off,
    feed_with_spindle_off,
    // Of the motors.
    motor_peak,
    motor_continuous,
    // Of other input, of outputs and of what was asked for.
    usage,
    file,
    input_file,
    path,
    output,
    internal,
};

/// A kind with its code and what it means.
struct DiagnosticKindEntry {
    DiagnosticKind kind;
    std::string_view code;     ///< "axis-limit"
    std::string_view meaning;  ///< A sentence for people, without its full stop.
};

/// All kinds, in the order of the enumeration.
std::span<const DiagnosticKindEntry> diagnostic_kinds();

/// "axis-limit"
std::string_view code_of(DiagnosticKind kind);

/// The kind with this code; nothing where there is none.
std::optional<DiagnosticKind> diagnostic_kind(std::string_view code);

}  // namespace gsim::text
