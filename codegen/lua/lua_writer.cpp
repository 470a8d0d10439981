#include "codegen/lua/lua_writer.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/trimmed.h"
#include "codegen/blocks/active_comment.h"
#include "codegen/blocks/block_values.h"
#include "codegen/lua/expression_writer.h"
#include "codegen/lua/lua_text.h"
#include "codegen/lua/print_writer.h"
#include "codegen/lua/word_writer.h"

namespace gsim::codegen {

using lexer::DiagnosticKind;

using grammar::Block;
using grammar::BlockKind;
using grammar::Node;
using grammar::NodeKind;

namespace {

constexpr std::string_view kWhitespace = " \t\r\v\f";  // the CR of a line that ends in CR LF among them
constexpr std::size_t kCommentColumn = 56;
constexpr int kMaxBareLabels = 100;  // consecutive labels; Lua's parser nests them, up to 200

// Upper bounds of the instructions that Lua's compiler makes of a test and of a node of an expression.
constexpr std::uint64_t kInstructionsPerTest = 6;
constexpr std::uint64_t kInstructionsPerNode = 4;

/// Returns true for O-words that can be left out by themselves.
bool is_plain_flow(grammar::Flow flow) {
    return flow == grammar::Flow::call || flow == grammar::Flow::return_ || flow == grammar::Flow::break_ ||
           flow == grammar::Flow::continue_;
}

/// Returns the name of a program in Lua's form: 12 for O0012, "PART7" for OPART7. A name in < > is used as
/// written, so o<02> is not o2.
std::string lua_program_name(std::string_view name, const lexer::TextRules& rules) {
    const bool is_number = rules.names_in_angle_brackets
                               ? is_oword_number(name)
                               : all_digits(name) && normalized_number(name).size() <= 9;
    if (is_number) return normalized_number(name);
    return fmt::format("\"{}\"", name);
}

}  // namespace

LuaWriter::LuaWriter(const grammar::Dialect& dialect, const FileScan& scan, lexer::Lexer& lexer,
                     lexer::Diagnostics& diagnostics, LuaSpool& spool, Options options)
    : scan_(scan),
      errors_(lexer.errors()),
      extent_(lexer.extent()),
      diagnostics_(diagnostics),
      spool_(spool),
      options_(options),
      plan_(dialect, lexer.errors(), diagnostics, options.warn_of_unknown ? &unknown_ : nullptr),
      flow_(diagnostics),
      oword_flow_(diagnostics) {}

void LuaWriter::begin_file(std::string_view source_name) {
    std::string head = fmt::format("local _ENV = require \"{}{}\" ", plan_.dialect().rules().lua_module,
                                   options_.inch ? ".inch" : "");
    flow_.begin_program(scan_.program(0));
    if (!scan_.starts_with_part) {
        ++next_ordinal_;
        parts_.begin_program("nil", head);
        declare_jump(head);
    }
    head += fmt::format("-- from {}; line n there is line n+1 here", lexer::printable(source_name));
    spool_.write_head(head);
    parts_.end_line(spool_.size(), false, true);
}

/// Returns true if the block becomes only calls with numbers.
bool LuaWriter::is_plain(const Block& block) {
    return block.kind == BlockKind::words && block.nodes.empty() && block.skip_level == 0;
}

void LuaWriter::on_block(const Block& block) {
    if (block.text->bad) {
        record_bad_block(block);
    } else {
        write_block(block);
    }
    is_plain_line_ = is_plain_line_ && is_plain(block);
    add_comment(block);
    if (block.text->end == lexer::BlockEnd::line && block.kind != BlockKind::tape) end_line();
}

/// The parts of a block with an error that others refer to still count, so that one error does not cause
/// more.
void LuaWriter::record_bad_block(const Block& block) {
    if (block.has_program) open_program(block);
    if (block.text->structural) {
        flow_.stop_nesting_checks();
        oword_flow_.stop_nesting_checks();
    }
    if (parts_.open() && block.sequence)
        flow_.add_sequence(*block.sequence, block.text->at(block.prefix_column));
}

void LuaWriter::report_duplicate_program(const Block& block, std::string_view name) {
    const std::string what = fmt::format("the program O{} is defined twice in this file", name);
    if (!plan_.dialect().rules().first_program_counts) {
        errors_.fail(block.prefix_column, DiagnosticKind::program_twice, what);
        return;
    }
    if (block.text->bad) return;
    diagnostics_.warning(block.text->at(block.prefix_column), DiagnosticKind::program_twice,
                         fmt::format("{}; M98 P{} calls the first one after the main program", what, name));
}

void LuaWriter::open_program(const Block& block) {
    close_program();
    main_ended_ = false;
    const std::string_view name = block.text->view(block.text->program);
    const std::string lua_name = lua_program_name(name, plan_.dialect().text());
    if (!names_.define(lua_name)) report_duplicate_program(block, name);
    flow_.begin_program(scan_.program(next_ordinal_++));
    parts_.begin_program(lua_name, code_);
    declare_jump(code_);
    comment_ += fmt::format("{}O{}", comment_.empty() ? "" : " ", name);
}

bool LuaWriter::is_empty_block(const Block& block) {
    if (!grammar::is_blank(block)) return false;
    std::string action;
    if (plan_.dialect().rules().active_comments) write_comment_action(block, action);
    return action.empty();
}

/// Every statement must be in a function; a subroutine brings its own.
void LuaWriter::begin_function(const Block& block) {
    if (block.kind != BlockKind::flow || block.flow != grammar::Flow::sub) parts_.begin_remainder(code_);
}

/// A subroutine is a separate function, so that it can be called from above.
void LuaWriter::open_sub(const Block& block) {
    if (parts_.open()) parts_.end(code_);
    const std::string name = oword_name(block);
    if (const lexer::Location* first = names_.define_sub(name, block.text->at(block.flow_column))) {
        errors_.fail(block.flow_column, DiagnosticKind::program_twice,
                     fmt::format("the subroutine o{} is defined twice in this file, first in line {}",
                                 block.text->view(block.text->program), first->line));
    }
    parts_.begin_sub(name, code_);
}

void LuaWriter::write_flow(const Block& block) {
    flow_.add_weight(kInstructionsPerTest * (1 + block.arguments.size()));
    if (block.flow == grammar::Flow::sub && !oword_flow_.open()) open_sub(block);
    const bool inside = oword_flow_.inside_sub();
    oword_flow_.write(block, flow_.weight(), code_);
    if (inside && !oword_flow_.inside_sub()) {
        parts_.end(code_);
        if (main_ended_) extent_.end_main_program();
    }
    plan_.defer_unknown(oword_flow_.inside_sub() ? &deferred_codes_ : nullptr);
}

void LuaWriter::close_program() {
    flow_.end_program();
    oword_flow_.end_program();
    if (!parts_.open()) return;
    if (flow_.computed()) write_dispatcher();
    if (flow_.has_jumps()) parts_.forbid_cuts();
    parts_.end(code_);
}

void LuaWriter::check_skip(const Block& block) {
    if (block.skip_level == 0) return;
    const bool structure = block.has_program || block.kind == BlockKind::while_do ||
                           block.kind == BlockKind::end_loop ||
                           (block.kind == BlockKind::flow && !is_plain_flow(block.flow));
    if (structure) {
        errors_.fail(
            block.prefix_column, DiagnosticKind::structure,
            "block delete '/' must not precede a program or a control structure: its end would be lost");
    }
}

void LuaWriter::write_block(const Block& block) {
    check_skip(block);
    if (block.has_program) open_program(block);
    if (!parts_.open()) {
        if (is_empty_block(block)) return;
        begin_function(block);
    }
    const bool label =
        block.sequence && flow_.add_sequence(*block.sequence, block.text->at(block.prefix_column));
    if (label) text::append_format(code_, "::N{}:: ", *block.sequence);
    const std::size_t labelled = code_.size();
    write_statements(block);
    if (code_.size() > labelled) {
        bare_label_count_ = 0;
    } else if (label && ++bare_label_count_ == kMaxBareLabels) {
        code_ += "do end ";
        bare_label_count_ = 0;
    }
}

void LuaWriter::write_statements(const Block& block) {
    if (const auto column = nested_too_deep(block, nesting_levels_around(block))) {
        errors_.fail(*column, DiagnosticKind::nesting,
                     "the expression is nested too deep for Lua; assign a part of it to a variable first");
    }
    const std::size_t before = code_.size();
    if (block.skip_level > 0) text::append_format(code_, "if not skipped({}) then ", block.skip_level);
    const std::size_t body = code_.size();
    flow_.add_weight(block.nodes.size() * kInstructionsPerNode +
                     (block.skip_level > 0 ? kInstructionsPerTest : 0));
    write_body(block);
    if (block.skip_level == 0) return;
    if (code_.size() == body) {
        code_.resize(before);
    } else {
        code_ += "end ";
    }
}

/// Returns the levels of Lua that are used before an expression of the block begins; simultaneous settings
/// also use some.
int LuaWriter::nesting_levels_around(const Block& block) const {
    if (!plan_.dialect().rules().blocks.values_before_actions) return oword_flow_.levels();
    constexpr int kLevelsPerSetting = 2;
    const std::size_t settings = std::min(block.assignments.size(), Settings::kMax);
    return oword_flow_.levels() + kLevelsPerSetting * static_cast<int>(settings);
}

/// The last one of several comments in ( ) may act; a remark that begins with ';' does not, nor does the text
/// that follows an O-word.
void LuaWriter::write_comment_action(const Block& block, std::string& out) {
    const std::vector<lexer::Slice>& comments = block.text->comments;
    const std::size_t count = comments.size() - (block.text->has_line_comment ? 1 : 0);
    if (count == 0 || block.has_program) return;
    if (const auto done = write_active_comment(block.text->view(comments[count - 1]), out); !done)
        errors_.fail(1, DiagnosticKind::syntax, done.error().message);
}

void LuaWriter::write_body(const Block& block) {
    switch (block.kind) {
        case BlockKind::words:
        case BlockKind::assignments: write_content(block); return;
        case BlockKind::if_then:
            code_ += "if ";
            write_condition(block, block.condition, code_);
            code_ += " then ";
            write_content(block);
            code_ += "end ";
            return;
        case BlockKind::if_goto:
            code_ += "if ";
            write_condition(block, block.condition, code_);
            code_ += " then ";
            write_goto(block);
            code_ += " end ";
            return;
        case BlockKind::jump:
            write_goto(block);
            code_ += ' ';
            return;
        case BlockKind::while_do:
            flow_.open_loop(block);
            code_ += "while ";
            write_condition(block, block.condition, code_);
            code_ += " do ";
            return;
        case BlockKind::end_loop:
            write_loop_dispatcher();
            flow_.close_loop(block);
            code_ += "end ";
            return;
        case BlockKind::print:
            if (const auto done = write_print(block, code_); !done)
                errors_.fail(1, DiagnosticKind::syntax, done.error().message);
            return;
        case BlockKind::flow: write_flow(block); return;
        case BlockKind::tape: return;
    }
}

void LuaWriter::add_comment(const Block& block) {
    std::string fragment;
    if (options_.annotate) {
        fragment = lexer::printable(text::trimmed(block.text->raw, kWhitespace));
        if (block.has_program) comment_.clear();
    } else {
        if (block.sequence) fragment = fmt::format("N{}", *block.sequence);
        for (const lexer::Slice slice : block.text->comments) {
            fragment +=
                fmt::format("{}({})", fragment.empty() ? "" : " ", lexer::printable(block.text->view(slice)));
        }
    }
    if (fragment.empty()) return;
    if (!comment_.empty()) comment_ += ' ';
    comment_ += fragment;
}

void LuaWriter::end_line() {
    while (!code_.empty() && code_.back() == ' ') code_.pop_back();
    if (!comment_.empty()) {
        code_.append(code_.size() < kCommentColumn ? kCommentColumn - code_.size() : 1, ' ');
        code_ += "-- ";
        code_ += comment_;
        comment_.clear();
    }
    code_ += '\n';
    spool_.write(code_);
    parts_.end_line(code_.size(), !flow_.in_loop() && !oword_flow_.open(), is_plain_line_);
    is_plain_line_ = true;
    code_.clear();
}

void LuaWriter::end_file() {
    close_program();
    if (!code_.empty() || !comment_.empty()) end_line();
    unknown_.report(diagnostics_, plan_.dialect().title(), "it is skipped, a G code with its complete block");
    deferred_codes_.report(diagnostics_, plan_.dialect().title(),
                           "a call of the enclosing subroutine would end in an alarm");
    names_.report_missing(diagnostics_);
}

}  // namespace gsim::codegen
