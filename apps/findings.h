#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text/diagnostic.h"
#include "cli/command_line.h"
#include "engine/diagnostic.h"
#include "engine/findings.h"

namespace gsim::apps {

/// How diagnostics are wanted.
struct FindingOptions {
    bool json = false;  ///< One JSON document in place of text.
    std::string sarif;  ///< A file of SARIF 2.1.0 besides, "-": standard output; empty: none.
};

/// Where the product of a program goes: the file that was named, or standard output.
std::string product_name(const std::string& output);
/// Why SARIF cannot go where it is asked for, as a sentence: the product goes to standard output, too.
std::optional<std::string> sarif_conflict(const FindingOptions& options, const std::string& product);

/// --sarif, and --json where the program has no other use of it.
void add_finding_options(CommandLine& line, FindingOptions& options);
void add_sarif_option(CommandLine& line, FindingOptions& options);

/// What a program has to tell of its input: text at once, or one document at the end.
class Findings {
  public:
    enum class Stream : std::uint8_t { standard_output, standard_error };

    /// `program` names it in sentences without a place; text goes to `text_to`, and makes way for SARIF
    /// there.
    Findings(std::string program, FindingOptions options, Stream text_to = Stream::standard_error)
        : program_(std::move(program)), options_(std::move(options)), text_to_(text_to) {}

    void take(const engine::Diagnostic& told);
    void take(const text::Diagnostic& told);
    /// A program has been looked at: for the JSON document.
    void checked(engine::CheckedProgram program) { programs_.push_back(std::move(program)); }
    /// Another document has told what was taken so far, and these.
    void replace(std::vector<engine::Diagnostic> diagnostics) { all_ = std::move(diagnostics); }
    /// Takes why something was not done; the exit status for it.
    int fail(const engine::Failure& failure);
    /// The same of a sentence that may begin with its place, or with the name `file`.
    int fail(text::DiagnosticKind kind, std::string_view sentence, std::string_view file = {});

    /// Ends with this status: writes the documents that are wanted. JSON goes to `json_to`: standard error
    /// where the program's product is on standard output. The status, or that of an output that cannot be
    /// written.
    int finish(int status, Stream json_to);
    /// The same where another document (a report) has told the diagnostics: SARIF alone.
    int finish_told(int status);

    /// A line of text beside the diagnostics; with JSON there is none.
    void say(const std::string& text) const;

    const FindingOptions& options() const { return options_; }

  private:
    std::string program_;
    FindingOptions options_;
    Stream text_to_;
    std::vector<engine::Diagnostic> all_;
    std::vector<engine::CheckedProgram> programs_;
};

}  // namespace gsim::apps
