#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "codegen/block_plan.h"
#include "grammar/syntax.h"

namespace gsim::codegen {

/// Appends the Lua of one call of a block's plan, and a blank. With `further` ("`, true`"), an argument
/// behind its words, the call stands in round brackets.
void write_call(const grammar::Block& block, const BlockPlan& plan, const Call& call, std::string& out,
                std::string_view further = {});

/// Appends the assignments of a block of the 9/Series, one after the other.
void write_assignments(const grammar::Block& block, std::string& out);

/// The settings of a block of RS274/NGC: right sides see the old values, and of several values for one
/// parameter the last one holds.
class Settings {
  public:
    explicit Settings(const grammar::Block& block);

    /// v[1], v[2] = 2.0, v[1]
    void write_at_once(std::string& out) const;
    /// Around words: the values are worked out before the block acts, and set behind it.
    void open(std::string& out) const;
    void close(std::string& out) const;

  private:
    struct Setting {
        std::string target;
        std::int32_t value;
    };
    void write_targets(std::string& out) const;

    const grammar::Block& block_;
    std::vector<Setting> settings_;
};

/// A number of a program or block without leading zeros; the digits are few, see the scanner.
std::string normal_number(std::string_view digits);

/// True for digits alone, one at least.
bool all_digits(std::string_view text);

/// An upper bound of the instructions that Lua makes of a call.
std::uint64_t weight(const Call& call);

}  // namespace gsim::codegen
