#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gsim::machine {

/// What the tool works with.
enum class ProcessKind { jet, plasma, laser, spindle };
std::string_view name(ProcessKind kind);

/// A code of part programs that switches the process; only where these words stand with it, where there are
/// any.
struct SwitchWord {
    int code = 0;                  ///< Of an M code: 62 of M62.
    std::map<char, double> words;  ///< By upper case letter: P 0.

    /// "M62 P0"
    std::string text() const;
    bool operator==(const SwitchWord&) const = default;
};

/// What a run looks for where the machine's process is known.
struct ProcessChecks {
    bool rapid_with_process_on = true;
    bool dwell_with_process_on = true;
    bool end_with_process_on = true;
    bool feed_with_process_off = true;
    double dwell_s = 0;  ///< The longest dwell with the process on.

    bool operator==(const ProcessChecks&) const = default;
};

/// What a machine works with, and what switches it (docs/machine-file.md).
struct Process {
    ProcessKind kind = ProcessKind::jet;
    std::vector<SwitchWord> on;
    std::vector<SwitchWord> off;
    ProcessChecks checks;

    bool operator==(const Process&) const = default;
};

}  // namespace gsim::machine
