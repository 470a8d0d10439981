#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/dialect_rules.h"

namespace gsim::grammar {

/// Language of part programs: a description, and fast access to its tables.
class Dialect {
  public:
    explicit Dialect(DialectRules rules);
    /// Makes a dialect that differs from its base: `change` receives a copy of the base's description. The
    /// functions of grammar/rows.h change its tables.
    Dialect(const Dialect& base, const std::function<void(DialectRules&)>& change);
    Dialect(const Dialect&) = delete;  // views of the tables are passed on
    Dialect& operator=(const Dialect&) = delete;

    std::string name() const { return std::string(rules_.name); }
    std::string_view title() const { return rules_.title; }
    const DialectRules& rules() const { return rules_; }
    const lexer::TextRules& text() const { return rules_.text; }
    /// Returns the rank of a phase: phases of a block act in ascending order of it.
    int rank(Phase phase) const { return ranks_[static_cast<std::size_t>(phase)]; }
    /// Returns the row of a code, or null if the dialect has no such code.
    const Code* find(char letter, std::int32_t code_x10) const;
    std::span<const Code> codes() const { return rules_.codes; }

  private:
    DialectRules rules_;
    std::array<int, kPhaseCount> ranks_;
    std::vector<std::uint16_t> index_;  // by letter and number; 0: no code, else row + 1
};

/// Returns Allen-Bradley 9/Series, with the codes of the thesis (Appendix C and E).
const Dialect& dialect_ab9();
/// Returns RS274/NGC as in LinuxCNC 2.9.
const Dialect& dialect_rs274ngc();
/// Returns Klipper, as klippy reads it.
const Dialect& dialect_klipper();
/// Returns all dialects.
std::span<const Dialect* const> dialects();
/// Returns the names of all dialects.
std::vector<std::string_view> dialect_names();
/// Returns the dialect with this name ("ab9", "rs274ngc", "klipper"), or null.
const Dialect* find_dialect(std::string_view name);

}  // namespace gsim::grammar
