#pragma once

#include <cstdint>
#include <string_view>

#include "lexer/block_text.h"
#include "lexer/diagnostics.h"

namespace gsim::lexer {

/// Errors of the block that is being read.
class BlockErrors {
  public:
    /// Makes the errors of `block`; both arguments must outlive them.
    BlockErrors(BlockText& block, Diagnostics& diagnostics) : block_(block), diagnostics_(diagnostics) {}

    /// Reports an error in the block, the first one only, and marks the block as bad.
    void fail(std::uint32_t column, DiagnosticKind kind, std::string_view message,
              std::string_view hint = {});
    /// Reports that the block exceeds a limit. The remainder of its line is ignored.
    void exceed(std::uint32_t column, DiagnosticKind kind, std::string_view message);
    /// Returns true if the remainder of the line is ignored.
    bool is_dropping() const { return is_dropping_; }
    /// Ends that at the end of a line.
    void end_line() { is_dropping_ = false; }

  private:
    BlockText& block_;
    Diagnostics& diagnostics_;
    bool is_dropping_ = false;
};

}  // namespace gsim::lexer
