#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gsim::machine {

/// Type of process of the tool.
enum class ProcessKind { jet, plasma, laser, spindle };
std::string_view name(ProcessKind kind);

/// A code of part programs that switches the process. If words are listed, it switches only in combination
/// with these words.
struct SwitchWord {
    int code = 0;                  ///< For an M code: 62 of M62.
    std::map<char, double> words;  ///< By upper case letter: P 0.

    /// Returns the text "M62 P0".
    std::string text() const;
    bool operator==(const SwitchWord&) const = default;
};

/// Checks of a run, if the machine's process is known.
struct ProcessChecks {
    bool rapid_with_process_on = true;
    bool dwell_with_process_on = true;
    bool end_with_process_on = true;
    bool feed_with_process_off = true;
    double dwell_s = 0;  ///< The longest dwell with the process on.

    bool operator==(const ProcessChecks&) const = default;
};

/// The process of a machine, and the words that switch it (docs/machine-file.md).
struct Process {
    ProcessKind kind = ProcessKind::jet;
    std::vector<SwitchWord> on;
    std::vector<SwitchWord> off;
    ProcessChecks checks;

    bool operator==(const Process&) const = default;
};

}  // namespace gsim::machine
