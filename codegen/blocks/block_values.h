#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "codegen/blocks/block_plan.h"
#include "grammar/syntax.h"

namespace gsim::codegen {

/// Words of a block of RS274/NGC that must be evaluated before the block acts, because the first actions may
/// change what they read. Examples are parameters that the block sets, or the position after a change of
/// units. Their values are stored in locals of Lua.
class BlockValues {
  public:
    /// Makes an empty list: each word is evaluated when it is executed.
    BlockValues() = default;
    /// Collects the words that read parameters, if the block has settings or more than one call.
    BlockValues(const grammar::Block& block, const BlockPlan& plan);

    bool empty() const { return words_.empty(); }
    bool has(std::uint32_t word) const;
    /// local w1, w2 = v[5420], p.width
    void write(const grammar::Block& block, std::string& out) const;
    /// Appends the local of a word that has one: w1 for the first of them.
    void write_name(std::uint32_t word, std::string& out) const;

  private:
    std::vector<std::uint32_t> words_;  ///< In ascending order.
};

/// Settings of a block of RS274/NGC: right sides see the old values, and of several values for one parameter
/// the last one is valid.
class Settings {
  public:
    /// A block has no more: Lua keeps all values of a statement at once, in some 250 registers.
    static constexpr std::size_t kMax = 50;

    explicit Settings(const grammar::Block& block);

    /// v[1], v[2] = 2.0, v[1]
    void write(std::string& out) const;

  private:
    struct Setting {
        std::string target;
        std::int32_t value;
    };

    const grammar::Block& block_;
    std::vector<Setting> settings_;
};

/// Appends the assignments of a block of the 9/Series, in order.
void write_assignments(const grammar::Block& block, std::string& out);

}  // namespace gsim::codegen
