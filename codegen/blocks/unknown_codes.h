#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "lexer/diagnostics.h"

namespace gsim::codegen {

/// Counter of codes that a dialect does not have, to warn of each once.
class UnknownCodes {
  public:
    void add(const std::string& code, const lexer::Location& location) {
        ++codes_.try_emplace(code, Entry{location, 0}).first->second.count;
    }
    /// Reports one warning for each code, at its first position, with the count; `consequence` describes the
    /// effect.
    void report(lexer::Diagnostics& diagnostics, std::string_view dialect_title,
                std::string_view consequence) const;

  private:
    struct Entry {
        lexer::Location first;
        std::uint64_t count;
    };
    std::map<std::string, Entry> codes_;
};

}  // namespace gsim::codegen
