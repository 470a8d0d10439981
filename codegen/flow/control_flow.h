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

/// Follows the loops, labels and jumps of one program and reports what Lua could not do: Lua has no jump into
/// a loop, at most 32,767 labels and as many open jumps in a function, and none over more than 2^24
/// instructions.
class ControlFlow {
  public:
    explicit ControlFlow(lexer::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

    void begin_program(const ProgramJumps& jumps);
    /// Reports what is left open or leads nowhere.
    void end_program();

    /// WHILE and END; false where the error was reported.
    bool open_loop(const grammar::Block& block);
    bool close_loop(const grammar::Block& block);
    /// A GOTO to a number that is known at run time only: the label in Lua that finds its block, of the loop
    /// around it or of the program.
    std::string add_computed_jump();
    /// Where such jumps of the innermost loop lead; nothing where it has none.
    struct LoopTargets {
        std::string label;                   ///< What finds the block.
        std::string outer;                   ///< What finds it where it is none of the body.
        std::string end;                     ///< A label for the end of the body.
        std::vector<std::uint32_t> numbers;  ///< Blocks of the body itself.
    };
    std::optional<LoopTargets> loop_targets() const;
    /// A GOTO to a number that is known.
    void add_jump(std::uint32_t target, const lexer::Location& location);
    /// A block with N; true where it needs a label in Lua.
    bool add_sequence(std::uint32_t number, const lexer::Location& location);
    /// Whether a block with this number and a label has come.
    bool has_label(std::uint32_t number) const { return labels_.contains(number); }
    /// Counts instructions of Lua, as an upper bound.
    void add_weight(std::uint64_t instructions) { weight_ += instructions; }
    std::uint64_t weight() const { return weight_; }

    /// A WHILE or END could not be understood: no error of nesting is reported in this program any more.
    void lose_track() { lost_ = true; }
    bool in_loop() const { return !loops_.empty(); }
    bool has_jumps() const { return computed() || !jumps_->targets.empty(); }
    /// The program needs the dispatcher of computed jumps.
    bool computed() const { return jumps_->computed || has_returns(); }
    /// Calls of other programs may tell at which block to go on.
    bool has_returns() const { return jumps_->calls && jumps_->returns_to_blocks; }
    /// Numbers that a computed GOTO can reach from anywhere: those outside of loops.
    const std::vector<std::uint32_t>& reachable() const { return reachable_; }

  private:
    struct Loop {
        std::uint32_t number;
        std::uint32_t instance;
        std::uint64_t weight;
        lexer::Location location;
        bool has_computed_jumps = false;
        std::vector<std::uint32_t> numbers =
            {};  ///< Of its blocks that have a label, those of inner loops left out.
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
    std::string finder(std::size_t depth) const;
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
