#pragma once

#include <utility>
#include <vector>

#include "base/text/diagnostic.h"
#include "engine/diagnostic.h"
#include "engine/src/conversions.h"
#include "engine/src/run/run_inputs.h"

namespace gsim::engine {

/// Diagnostics of a run: kept for its report, and passed on to the caller's handler as they come.
class DiagnosticLog {
  public:
    explicit DiagnosticLog(DiagnosticHandler user_handler) : user_handler_(std::move(user_handler)) {}
    DiagnosticLog(const DiagnosticLog&) = delete;
    DiagnosticLog& operator=(const DiagnosticLog&) = delete;

    /// Returns the handler that adds a diagnostic.
    const TextDiagnosticHandler& handler() const { return handler_; }
    const std::vector<text::Diagnostic>& diagnostics() const { return diagnostics_; }

  private:
    DiagnosticHandler user_handler_;
    std::vector<text::Diagnostic> diagnostics_;
    TextDiagnosticHandler handler_ = [this](const text::Diagnostic& diagnostic) {
        diagnostics_.push_back(diagnostic);
        if (user_handler_) user_handler_(to_diagnostic(diagnostic));
    };
};

}  // namespace gsim::engine
