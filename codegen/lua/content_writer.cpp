// Part of LuaWriter that writes the content of a block: its words, assignments and settings.

#include <algorithm>

#include <fmt/format.h>

#include "codegen/blocks/call_codes.h"
#include "codegen/lua/lua_text.h"
#include "codegen/lua/lua_writer.h"
#include "codegen/lua/word_writer.h"

namespace gsim::codegen {

using lexer::DiagnosticKind;

using grammar::Block;
using grammar::Node;
using grammar::NodeKind;

namespace {

constexpr std::int32_t kAlarmVariable = 3000;
constexpr std::int32_t kStopVariable = 3006;

bool is_m_code(const Call& call, std::int32_t code_x10) {
    return call.kind == Call::Kind::code && call.code->letter == 'M' && call.code->code_x10 == code_x10;
}

bool is_macro_call(const Call& call) {
    return call.kind == Call::Kind::code && call.code->letter == 'G' && call.code->code_x10 == kMacroCode;
}

bool ends_program(const Call& call) {
    return is_m_code(call, 20) || is_m_code(call, 300);
}

}  // namespace

void LuaWriter::write_content(const Block& block) {
    if (plan_.dialect().rules().blocks.values_before_actions) return write_values_first(block);
    write_message(block);
    if (!block.assignments.empty()) return write_assignments(block, code_);
    if (!block.text->words.empty() && plan_.plan(block)) write_calls(block, {});
}

/// All values of the block come first, then its settings and its comment, then its words act.
void LuaWriter::write_values_first(const Block& block) {
    if (block.assignments.size() > Settings::kMax) {
        errors_.fail(1, DiagnosticKind::too_large,
                     fmt::format("a block sets at most {} parameters", Settings::kMax));
        return;
    }
    const bool has_effect = !block.text->words.empty();
    if (has_effect && !plan_.plan(block)) return;
    const BlockValues values = has_effect ? BlockValues(block, plan_) : BlockValues();
    if (!values.empty()) {
        code_ += "do ";
        values.write(block, code_);
    }
    if (!block.assignments.empty()) Settings(block).write(code_);
    if (plan_.dialect().rules().active_comments) write_comment_action(block, code_);
    if (has_effect) write_calls(block, values);
    if (!values.empty()) code_ += "end ";
}

/// #3000 and #3006 (alarm, stop) show the comment of their block.
void LuaWriter::write_message(const Block& block) {
    const bool has_content =
        std::any_of(block.assignments.begin(), block.assignments.end(), [&](const auto& assignment) {
            const Node& target = block.node(assignment.target);
            return target.kind == NodeKind::variable &&
                   (target.left == kAlarmVariable || target.left == kStopVariable);
        });
    if (!has_content || block.text->comments.empty()) return;
    code_ += "message(";
    write_lua_string(block.text->view(block.text->comments.front()), code_);
    code_ += ") ";
}

void LuaWriter::write_calls(const Block& block, const BlockValues& values) {
    for (const Call& call : plan_.calls()) {
        flow_.add_weight(weight(call));
        if (is_m_code(call, kCallCode)) record_call(block, call);
        const bool calls = is_m_code(call, kCallCode) || is_macro_call(call);
        if (calls && flow_.has_returns()) {
            // M99 P in the called program: this one continues at that block.
            code_ += "jump = ";
            write_call(block, plan_, call, values, code_, ", true");
            code_ += "if jump then ";
            write_computed_jump();
            code_ += " end ";
        } else if (!is_m_code(call, kReturnCode) || next_ordinal_ != 1 || !write_return_goto(block, call)) {
            write_call(block, plan_, call, values, code_);
        }
        if (ends_program(call) && plan_.dialect().rules().end_code_ends_text && !oword_flow_.open() &&
            block.skip_level == 0) {
            main_ended_ = true;
            extent_.end_main_program();
        }
    }
}

}  // namespace gsim::codegen
