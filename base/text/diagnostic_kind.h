#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace gsim::text {

/// Subject of a diagnostic. Each kind has a code that stays the same from release to release
/// (docs/diagnostics.md), so that other programs can sort and suppress by it.
enum class DiagnosticKind : std::uint8_t {
    // Kinds for a program's text.
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
    // Kinds for a run.
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
    // Kinds for a cell.
    collision,
    near_miss,
    // Kinds for the process that cuts (jet, plasma, laser, spindle).
    rapid_with_process_on,
    dwell_with_process_on,
    end_with_process_on,
    feed_with_process_off,
    feed_with_spindle_off,
    // Kinds for the motors.
    motor_peak,
    motor_continuous,
    // Kinds for other input, for outputs and for requests.
    usage,
    file,
    input_file,
    path,
    output,
    internal,
};

/// A kind with its code and its meaning.
struct DiagnosticKindEntry {
    DiagnosticKind kind;
    std::string_view code;     ///< "axis-limit"
    std::string_view meaning;  ///< Text for people, without its full stop.
};

/// Returns all kinds, in the order of the enumeration.
std::span<const DiagnosticKindEntry> diagnostic_kinds();

/// Returns the code, such as "axis-limit".
std::string_view diagnostic_code(DiagnosticKind kind);

/// Returns the kind with this code, or nothing if no kind has it.
std::optional<DiagnosticKind> diagnostic_kind(std::string_view code);

}  // namespace gsim::text
