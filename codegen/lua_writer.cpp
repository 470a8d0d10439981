#include "codegen/lua_writer.h"

#include <algorithm>
#include <charconv>
#include <iterator>

#include <fmt/format.h>

#include "codegen/expression_writer.h"

namespace gsim::codegen {

using grammar::Block;
using grammar::BlockKind;
using grammar::Node;
using grammar::NodeKind;
using lexer::Role;
using lexer::Word;

namespace {

constexpr std::size_t kCommentColumn = 56;
constexpr std::uint32_t kLinesBetweenCuts = 5000;
constexpr std::size_t kMaxCalledPrograms = 10000;
constexpr int kMaxBareLabels = 100;  // labels one behind the other; Lua's parser nests them, up to 200

// Upper bounds of what Lua's compiler makes of a call, an operand and a node of an expression.
constexpr std::uint64_t kInstructionsPerCall = 6;
constexpr std::uint64_t kInstructionsPerOperand = 5;
constexpr std::uint64_t kInstructionsPerNode = 4;

/// A number of a program or block without leading zeros; the digits are few, see the scanner.
std::string normal_number(std::string_view digits) {
    const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
    return std::string(digits.substr(first));
}

/// Without the blanks around it, the CR of a line that ends in CR LF among them.
std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r\v\f";
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

bool all_digits(std::string_view text) {
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// The name of a program as Lua has it: 12 for O0012, "PART7" for OPART7.
std::string lua_program_name(std::string_view name) {
    if (all_digits(name) && normal_number(name).size() <= 9) return normal_number(name);
    return fmt::format("\"{}\"", name);
}

}  // namespace

LuaWriter::LuaWriter(const grammar::Dialect& dialect, const FileScan& scan, lexer::Lexer& lexer,
                     lexer::Diagnostics& diagnostics, LuaSpool& spool, Options options)
    : scan_(scan),
      lexer_(lexer),
      diagnostics_(diagnostics),
      spool_(spool),
      options_(options),
      plan_(dialect, lexer, diagnostics),
      flow_(diagnostics) {}

void LuaWriter::begin_file(std::string_view source_name) {
    std::string head = "local _ENV = require \"gsim\"";
    if (!scan_.starts_with_program) head += " program(nil, function()";
    const std::size_t body_begin = head.size();
    head += fmt::format(" -- from {}; line n there is line n+1 here", lexer::printable(source_name));
    spool_.write_head(head);
    written_ = spool_.size();
    if (!scan_.starts_with_program) {
        start_function("nil");
        map_.back().body_begin = body_begin;
        map_.back().first_line = 1;
    }
    lua_line_ = 2;
}

void LuaWriter::take(const Block& block) {
    if (block.text->bad) {
        note_bad_block(block);
    } else {
        write_block(block);
    }
    add_comment(block);
    if (block.text->end == lexer::BlockEnd::line && block.kind != BlockKind::tape) end_line();
}

/// Of a block with an error, what others refer to counts all the same, so that one error does not bring more.
void LuaWriter::note_bad_block(const Block& block) {
    if (block.has_program) open_program(block);
    if (in_program_ && block.sequence)
        flow_.add_sequence(*block.sequence, block.text->at(block.prefix_column));
}

void LuaWriter::start_function(const std::string& name) {
    in_program_ = true;
    flow_.begin_program(scan_.program(next_ordinal_++));
    ProgramPart part;
    part.name = name;
    map_.push_back(std::move(part));
    last_cut_line_ = lua_line_;
}

void LuaWriter::open_program(const Block& block) {
    if (in_program_) close_program();
    const std::string_view name = block.text->view(block.text->program);
    const std::string lua_name = lua_program_name(name);
    if (!defined_.insert(lua_name).second) {
        lexer_.fail(block.prefix_column, fmt::format("the program O{} stands twice in this file", name));
    }
    start_function(lua_name);
    fmt::format_to(std::back_inserter(code_), "{}program({}, function()", code_.empty() ? "" : " ", lua_name);
    map_.back().body_begin = written_ + code_.size();
    map_.back().first_line = lua_line_;
    code_ += ' ';
    comment_ += fmt::format("{}O{}", comment_.empty() ? "" : " ", name);
}

void LuaWriter::close_program() {
    flow_.end_program();
    if (flow_.computed()) write_dispatcher();
    map_.back().body_end = written_ + code_.size();
    if (flow_.has_jumps()) map_.back().cuts.clear();
    code_ += code_.empty() ? "end)" : " end)";
    in_program_ = false;
}

void LuaWriter::write_dispatcher() {
    code_ += code_.empty() ? "do return end ::computed:: " : " do return end ::computed:: ";
    for (const std::uint32_t number : flow_.reachable()) {
        fmt::format_to(std::back_inserter(code_), "if jump == {} then goto N{} end ", number, number);
    }
    code_ += "no_target(jump)";
}

void LuaWriter::check_skip(const Block& block) {
    if (block.skip_level == 0) return;
    const bool structure =
        block.has_program || block.kind == BlockKind::while_do || block.kind == BlockKind::end_loop;
    if (structure) {
        lexer_.fail(
            block.prefix_column,
            "block delete '/' cannot stand before O, WHILE or END: the program would lose its structure");
    }
}

void LuaWriter::write_block(const Block& block) {
    check_skip(block);
    if (block.has_program) open_program(block);
    if (!in_program_) {
        if (grammar::is_blank(block)) return;
        start_function("nil");
    }
    const bool label =
        block.sequence && flow_.add_sequence(*block.sequence, block.text->at(block.prefix_column));
    if (label) fmt::format_to(std::back_inserter(code_), "::N{}:: ", *block.sequence);
    const std::size_t labelled = code_.size();
    write_statements(block);
    if (code_.size() > labelled) {
        bare_labels_ = 0;
    } else if (label && ++bare_labels_ == kMaxBareLabels) {
        code_ += "do end ";
        bare_labels_ = 0;
    }
}

void LuaWriter::write_statements(const Block& block) {
    if (const auto column = nested_too_deep(block)) {
        lexer_.fail(*column,
                    "the expression is nested too deep for Lua; put a part of it into a variable first");
    }
    const std::size_t before = code_.size();
    if (block.skip_level > 0)
        fmt::format_to(std::back_inserter(code_), "if not skipped({}) then ", block.skip_level);
    const std::size_t body = code_.size();
    flow_.add_weight(block.nodes.size() * kInstructionsPerNode +
                     (block.skip_level > 0 ? kInstructionsPerCall : 0));
    write_body(block);
    if (block.skip_level == 0) return;
    if (code_.size() == body) {
        code_.resize(before);
    } else {
        code_ += "end ";
    }
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
            flow_.close_loop(block);
            code_ += "end ";
            return;
        case BlockKind::tape: return;
    }
}

void LuaWriter::write_content(const Block& block) {
    if (block.assignments.empty()) {
        write_words(block);
    } else {
        write_assignments(block);
    }
}

void LuaWriter::write_words(const Block& block) {
    if (block.text->words.empty() || !plan_.plan(block)) return;
    for (const Call& call : plan_.calls()) {
        write_call(block, call);
        code_ += ' ';
    }
}

void LuaWriter::write_call(const Block& block, const Call& call) {
    const Word& word = block.text->words[call.word];
    flow_.add_weight(kInstructionsPerCall + kInstructionsPerOperand * call.operand_count);
    switch (call.kind) {
        case Call::Kind::move:
            code_ += "move";
            write_operands(block, call);
            return;
        case Call::Kind::via_point:
            code_ += "CIP";
            write_operands(block, call);
            return;
        case Call::Kind::letter:
            code_ += static_cast<char>(word.address);
            code_ += '(';
            write_value(block, word);
            code_ += ')';
            return;
        case Call::Kind::code: break;
    }
    const bool is_return = call.code->letter == 'M' && call.code->code_x10 == 990;
    if (call.code->letter == 'M' && call.code->code_x10 == 980) note_call(block, call);
    if (is_return) code_ += "do return ";
    code_ += grammar::lua_name(*call.code);
    write_operands(block, call);
    if (is_return) code_ += " end";
}

void LuaWriter::write_operands(const Block& block, const Call& call) {
    if (call.operand_count == 0) {
        code_ += "()";
        return;
    }
    char separator = '{';
    for (const std::uint32_t index : plan_.operands(call)) {
        const Word& word = block.text->words[index];
        code_ += separator;
        if (separator == ',') code_ += ' ';
        code_ += lua_key(word.address);
        code_ += '=';
        write_value(block, word);
        separator = ',';
    }
    code_ += '}';
}

void LuaWriter::write_value(const Block& block, const Word& word) {
    if (word.expression >= 0) {
        write_number(block, word.expression, code_);
    } else if (word.role == Role::program) {
        code_ += normal_number(block.text->view(word.number));
    } else {
        code_ += block.text->view(word.number);
    }
}

void LuaWriter::note_call(const Block& block, const Call& call) {
    for (const std::uint32_t index : plan_.operands(call)) {
        const Word& word = block.text->words[index];
        if (word.expression >= 0) continue;
        const std::string_view digits = block.text->view(word.number);
        const std::string number = all_digits(digits) ? normal_number(digits) : "";
        if (number.empty() || number.size() > 9) {
            lexer_.fail(word.column, fmt::format("{} of M98 is a whole number, not {}",
                                                 lexer::address_name(word.address), digits));
            return;
        }
        std::uint32_t value = 0;
        std::from_chars(number.data(), number.data() + number.size(), value);
        if (word.address == 'P' && called_.size() < kMaxCalledPrograms)
            called_.try_emplace(value, block.text->at(word.column));
    }
}

void LuaWriter::write_assignments(const Block& block) {
    for (const grammar::Assignment& assignment : block.assignments) {
        write_number(block, assignment.target, code_);
        code_ += " = ";
        write_number(block, assignment.value, code_);
        code_ += ' ';
    }
}

void LuaWriter::write_goto(const Block& block) {
    const Node& target = block.node(block.target);
    if (target.kind != NodeKind::number) {
        code_ += "jump = goto_target(";
        write_number(block, block.target, code_);
        code_ += ") goto computed";
        return;
    }
    const std::string_view digits = block.text->view(target.number);
    const std::string number = all_digits(digits) ? normal_number(digits) : "";
    std::uint32_t value = 0;
    if (number.empty() || number.size() > 9) {
        lexer_.fail(block.target_column, fmt::format("GOTO takes a block number, not {}", digits));
        return;
    }
    std::from_chars(number.data(), number.data() + number.size(), value);
    flow_.add_jump(value, block.text->at(block.target_column));
    fmt::format_to(std::back_inserter(code_), "goto N{}", value);
}

void LuaWriter::add_comment(const Block& block) {
    std::string piece;
    if (options_.annotate) {
        piece = lexer::printable(trimmed(block.text->raw));
        if (block.has_program) comment_.clear();
    } else {
        if (block.sequence) piece = fmt::format("N{}", *block.sequence);
        for (const lexer::Slice slice : block.text->comments) {
            piece +=
                fmt::format("{}({})", piece.empty() ? "" : " ", lexer::printable(block.text->view(slice)));
        }
    }
    if (piece.empty()) return;
    if (!comment_.empty()) comment_ += ' ';
    comment_ += piece;
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
    written_ += code_.size();
    code_.clear();
    ++lua_line_;
    if (in_program_ && !flow_.in_loop() && lua_line_ - last_cut_line_ >= kLinesBetweenCuts) {
        map_.back().cuts.push_back({written_, lua_line_});
        last_cut_line_ = lua_line_;
    }
}

void LuaWriter::end_file() {
    if (in_program_) close_program();
    if (!code_.empty() || !comment_.empty()) end_line();
    for (const auto& [number, location] : called_) {
        if (!defined_.contains(std::to_string(number))) {
            diagnostics_.warning(
                location,
                fmt::format("program O{} is not in this file; it is looked for beside it when it is called",
                            number));
        }
    }
}

}  // namespace gsim::codegen
