#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lexer/block_text.h"
#include "lexer/token.h"

namespace gsim::grammar {

using lexer::Flow;
using lexer::Operator;
using lexer::Slice;

enum class NodeKind : std::uint8_t {
    number,    ///< `number` holds the digits.
    variable,  ///< #5: `left` is the number of the variable.
    indirect,  ///< #[..], ##5: `left` is the node that gives the number.
    negate,    ///< `left`
    binary,    ///< `op` of `left` and `right`
    call,      ///< `op` of `left`; ATAN[..]/[..] has `right` too.
    named,     ///< #<name>: `number` holds the name.
    exists,    ///< EXISTS[..]: `left` is a variable.
};

/// Node of an expression; children are indices into Block::nodes, or -1.
struct Node {
    NodeKind kind = NodeKind::number;
    Operator op = Operator::add;
    std::int32_t left = -1;
    std::int32_t right = -1;
    std::uint32_t column = 0;
    Slice number;
};

struct Assignment {
    std::int32_t target = -1;  ///< A variable or indirect node.
    std::int32_t value = -1;
};

enum class BlockKind : std::uint8_t {
    words,        ///< Words, possibly zero.
    assignments,  ///< #1=.. and so on.
    if_goto,      ///< `condition`, `target`
    if_then,      ///< `condition`, and words or assignments
    while_do,     ///< `condition`, `loop`
    end_loop,     ///< `loop`
    jump,         ///< GOTO `target`
    tape,         ///< %
    print,        ///< 9/Series: DPRNT[..], POPEN, PCLOS by `print`
    flow,         ///< RS274/NGC: an O-word with `flow` and `arguments`
};

/// One block: the tree that the grammar builds, on top of the scanner's arena. It is emptied and used again,
/// so that memory does not grow with the file.
struct Block {
    lexer::BlockText* text = nullptr;
    BlockKind kind = BlockKind::words;
    bool has_program = false;
    std::optional<std::uint32_t> sequence;  ///< N
    std::uint8_t skip_level = 0;            ///< /n, 0 without
    std::uint32_t prefix_column = 0;        ///< Column of the control word, N or / for messages.
    std::vector<Node> nodes;
    std::vector<Assignment> assignments;
    std::int32_t condition = -1;
    std::int32_t target = -1;  ///< Node: a number, or an expression (computed GOTO).
    std::uint32_t target_column = 0;
    std::uint32_t loop = 0;  ///< DO and END number.
    std::uint32_t loop_column = 0;
    lexer::Print print = lexer::Print::text;
    Flow flow = Flow::program;
    std::int32_t flow_node = -1;  ///< The O-word's name if it is an expression; else it is text->program.
    std::uint32_t flow_column = 0;
    std::vector<std::int32_t> arguments;

    void clear();
    const Node& node(std::int32_t index) const { return nodes[static_cast<std::size_t>(index)]; }
};

/// Returns true for a block without content: a tape mark, or no program name and no word.
bool is_blank(const Block& block);

/// Returns true if the node's value is a truth value: a comparison, or AND, OR, XOR of two such.
bool is_condition(const Block& block, std::int32_t index);

/// Returns true if the expression at `index` reads a parameter, or checks if one exists.
bool reads_parameter(const Block& block, std::int32_t index);

}  // namespace gsim::grammar
