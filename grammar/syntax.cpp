#include "grammar/syntax.h"

namespace gsim::grammar {

void Block::clear() {
    kind = BlockKind::words;
    has_program = false;
    sequence.reset();
    skip_level = 0;
    prefix_column = 0;
    nodes.clear();
    assignments.clear();
    condition = -1;
    target = -1;
    target_column = 0;
    loop = 0;
    loop_column = 0;
    flow = Flow::program;
    flow_node = -1;
    flow_column = 0;
    arguments.clear();
}

bool is_blank(const Block& block) {
    if (block.kind == BlockKind::tape) return true;
    return !block.has_program && block.kind == BlockKind::words && block.text->words.empty() &&
           block.assignments.empty() && !block.text->bad;
}

bool is_condition(const Block& block, std::int32_t index) {
    const Node& node = block.node(index);
    if (node.kind != NodeKind::binary) return false;
    switch (node.op) {
        case Operator::equal:
        case Operator::not_equal:
        case Operator::near_equal:
        case Operator::not_near_equal:
        case Operator::greater:
        case Operator::greater_equal:
        case Operator::less:
        case Operator::less_equal: return true;
        case Operator::bit_and:
        case Operator::bit_or:
        case Operator::bit_xor: return is_condition(block, node.left) && is_condition(block, node.right);
        default: return false;
    }
}

bool reads_parameter(const Block& block, std::int32_t index) {
    const Node& node = block.node(index);
    switch (node.kind) {
        case NodeKind::number: return false;
        case NodeKind::variable:
        case NodeKind::indirect:
        case NodeKind::named:
        case NodeKind::exists: return true;
        case NodeKind::negate:
        case NodeKind::call:
        case NodeKind::binary: break;
    }
    return reads_parameter(block, node.left) || (node.right >= 0 && reads_parameter(block, node.right));
}

}  // namespace gsim::grammar
