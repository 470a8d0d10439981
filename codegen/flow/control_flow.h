#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "codegen/flow/jump_scan.h"
#include "grammar/syntax.h"
#include "lexer/diagnostics.h"

namespace gsim::codegen {

/// Check of the loops, labels and jumps of one program; it reports what Lua does not support. In Lua a
/// function has at most 32,767 labels and as many open jumps. It has no jump into a loop or over more than
/// 2^24 instructions.
class ControlFlow {
  public:
    explicit ControlFlow(lexer::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

    void begin_program(const ProgramJumps& jumps);
    /// Reports structures that are left open and jumps without a target.
    void end_program();

    /// Handle WHILE and END; return false if the error was reported.
    bool open_loop(const grammar::Block& block);
    bool close_loop(const grammar::Block& block);
    /// Adds a GOTO to a number that is known only at run time. Returns the label in Lua that finds its block,
    /// of the loop around it or of the program.
    std::string add_computed_jump();
    /// Targets of such jumps of the innermost loop; no value if it has no such jumps.
    struct LoopTargets {
        std::string label;                   ///< Label that finds the block.
        std::string outer;                   ///< Label if it is no block of the body.
        std::string end;                     ///< A label for the end of the body.
        std::vector<std::uint32_t> numbers;  ///< Blocks of the body itself.
    };
    std::optional<LoopTargets> loop_targets() const;
    /// Adds a GOTO to a number that is known.
    void add_jump(std::uint32_t target, const lexer::Location& location);
    /// Adds a block with N; returns true if it needs a label in Lua.
    bool add_sequence(std::uint32_t number, const lexer::Location& location);
    /// Returns true if a block with this number and a label has come.
    bool has_label(std::uint32_t number) const { return labels_.contains(number); }
    /// Counts instructions of Lua, as an upper bound.
    void add_weight(std::uint64_t instructions) { weight_ += instructions; }
    std::uint64_t weight() const { return weight_; }

    /// Records that a WHILE or END could not be understood: errors of nesting are no longer reported in this
    /// program.
    void stop_nesting_checks() { lost_ = true; }
    bool in_loop() const { return !loops_.empty(); }
    bool has_jumps() const { return computed() || !jumps_->targets.empty(); }
    /// Returns true if the program needs the dispatcher of computed jumps.
    bool computed() const { return jumps_->computed || has_returns(); }
    /// Returns true if calls of other programs may return the block at which to continue.
    bool has_returns() const { return jumps_->calls && jumps_->returns_to_blocks; }
    /// Returns the numbers that a computed GOTO can reach from anywhere: those outside of loops.
    const std::vector<std::uint32_t>& reachable() const { return reachable_; }

  private:
    struct Loop {
        std::uint32_t number;
        std::uint32_t instance;
        std::uint64_t weight;
        lexer::Location location;
        bool has_computed_jumps = false;
        std::vector<std::uint32_t> numbers =
            {};  ///< Its blocks that have a label, without those of inner loops.
    };
    struct Label {
        std::vector<std::uint32_t> path;  ///< Instances of the loops around it.
        std::uint64_t weight;
    };
    struct Jump {
        std::uint32_t target;
        std::vector<std::uint32_t> path;
        std::uint64_t weight;
        lexer::Location location;
    };
    std::vector<std::uint32_t> path() const;
    std::string dispatch_label(std::size_t depth) const;
    void check(const Jump& jump);

    lexer::Diagnostics& diagnostics_;
    const ProgramJumps* jumps_ = nullptr;
    std::vector<Loop> loops_;
    std::map<std::uint32_t, Label> labels_;
    std::vector<Jump> open_jumps_;
    std::vector<std::uint32_t> reachable_;
    std::uint32_t next_instance_ = 0;
    std::uint64_t weight_ = 0;
    bool lost_ = false;
    bool too_many_labels_ = false;
    bool too_many_jumps_ = false;
};

}  // namespace gsim::codegen
