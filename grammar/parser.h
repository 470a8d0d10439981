#pragma once

#include <functional>
#include <optional>

#include "grammar/syntax.h"
#include "lexer/lexer.h"

namespace gsim::grammar {

/// Consumer of the blocks of a program, one at a time; a block and its text are gone after the call.
class BlockSink {
  public:
    virtual ~BlockSink() = default;
    /// Processes a block. `block.text->bad`: an error has been reported, the remainder of the block may be
    /// incomplete.
    virtual void on_block(const Block& block) = 0;
};

/// GLR parser over a full source: reads, builds one block, passes it on, empties it.
class Parser {
  public:
    Parser(lexer::Lexer& lexer, lexer::Diagnostics& diagnostics, BlockSink& sink);

    /// Reads to the end of the source, or until too many errors occurred. Returns false if the parser itself
    /// gave up, which the scanner's limits should prevent; it is reported as an error.
    bool run();
    /// Runs like run(), but ends with the block for which `done` is true.
    bool run_until(std::function<bool()> done);

    // Called by the actions of the grammar; columns and indices come from token values.
    int scan(lexer::Value& value);
    void syntax_error();
    void finish_block();
    void finish_bad_block();
    void finish_tape();
    void set_kind(BlockKind kind) { block_.kind = kind; }
    void set_print(std::uint32_t print) {
        block_.kind = BlockKind::print;
        block_.print = static_cast<lexer::Print>(print);
    }
    void set_role(std::uint32_t word, lexer::Role role);
    void set_expression(std::uint32_t word, std::uint32_t node);
    void set_sequence(lexer::Value value);
    void set_skip(lexer::Value value);
    void set_program(std::uint32_t column);
    void set_condition(std::uint32_t node) { block_.condition = static_cast<std::int32_t>(node); }
    void set_target(lexer::Value node);
    void set_loop(lexer::Value number);
    void add_assignment(std::uint32_t target, std::uint32_t value);
    void set_flow_name(std::uint32_t column, std::optional<std::uint32_t> node = {});
    void set_flow_program();
    void set_flow(lexer::Value keyword);
    void add_argument(std::uint32_t node) { block_.arguments.push_back(static_cast<std::int32_t>(node)); }
    std::uint32_t add_named(lexer::Value name);
    std::uint32_t add_number(lexer::Value number);
    std::uint32_t add_variable(lexer::Value variable);
    /// Adds the parameter of RS274/NGC that has a signed value, or a function, as its number: #-[-3],
    /// #ATAN[1]/[1].
    std::uint32_t add_unbracketed_index(lexer::Value number);
    std::uint32_t add_node(NodeKind kind, Operator op, lexer::Value left,
                           std::optional<lexer::Value> right = {});

  private:
    std::uint32_t push(const Node& node);

    lexer::Lexer& lexer_;
    lexer::Diagnostics& diagnostics_;
    BlockSink& sink_;
    Block block_;
    std::function<bool()> done_;
    bool ended_ = false;
};

}  // namespace gsim::grammar
