#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/text/diagnostic.h"
#include "cli/command_line.h"
#include "engine/diagnostic.h"
#include "engine/findings.h"

namespace gsim::apps {

/// Output options for diagnostics.
struct FindingOptions {
    bool json = false;  ///< One JSON document in place of text.
    std::string sarif;  ///< SARIF 2.1.0 file in addition, "-": standard output; empty: none.
};

/// Returns the destination of a program's product: the file that was named, or standard output.
std::string output_destination(const std::string& output);
/// Returns an error if SARIF cannot be written to the requested output: the product uses standard output,
/// too.
std::optional<Error> sarif_conflict(const FindingOptions& options, const std::string& product);

/// Adds --sarif, and --json if the program does not use that option otherwise.
void add_finding_options(CommandLine& line, FindingOptions& options);
void add_sarif_option(CommandLine& line, FindingOptions& options);

/// Collector of the diagnostics of a program's input: printed as text at once, or as one document at the end.
class Findings {
  public:
    enum class Stream : std::uint8_t { standard_output, standard_error };

    /// `program` is its name in messages without a source location. Text is written to `text_stream`, unless
    /// SARIF is written there.
    Findings(std::string program, FindingOptions options, Stream text_stream = Stream::standard_error)
        : program_(std::move(program)), options_(std::move(options)), text_stream_(text_stream) {}

    void add(const engine::Diagnostic& diagnostic);
    void add(const text::Diagnostic& diagnostic);
    /// Adds a checked program to the JSON document.
    void add_program(engine::CheckedProgram program) { programs_.push_back(std::move(program)); }
    /// Replaces the diagnostics because another document has reported those taken so far, and these.
    void replace(std::vector<engine::Diagnostic> diagnostics) { all_ = std::move(diagnostics); }
    /// Adds the reason why something was not done; returns the exit status for it.
    int fail(const engine::Error& error);
    /// Does the same for a message that may begin with its source location, or with the name `file`.
    int fail(text::DiagnosticKind kind, std::string_view message, std::string_view file = {});

    /// Ends with this status: writes the requested documents. JSON is written to `json_stream`: standard
    /// error if the program's product is on standard output. Returns the status, or that of an output that
    /// cannot be written.
    int finish(int status, Stream json_stream);
    /// Does the same if another document (a report) contains the diagnostics: writes SARIF alone.
    int finish_sarif_only(int status);

    /// Prints a line of text next to the diagnostics, but not with JSON.
    void print_text(const std::string& text) const;

    const FindingOptions& options() const { return options_; }

  private:
    std::string program_;
    FindingOptions options_;
    Stream text_stream_;
    std::vector<engine::Diagnostic> all_;
    std::vector<engine::CheckedProgram> programs_;
};

}  // namespace gsim::apps
