#include "grammar/parser.h"

#include <fmt/format.h>

#include "grammar/gcode_parser.h"

namespace gsim::grammar {

using lexer::DiagnosticKind;
using lexer::Token;
using lexer::Value;

Parser::Parser(lexer::Lexer& lexer, lexer::Diagnostics& diagnostics, BlockSink& sink)
    : lexer_(lexer), diagnostics_(diagnostics), sink_(sink) {
    block_.text = &lexer_.block();
}

bool Parser::run() {
    if (gcode_parse(*this) == 0) return true;
    if (!diagnostics_.full()) {
        diagnostics_.error(block_.text->begin, DiagnosticKind::syntax,
                           "the parser stopped at this block; the remaining program was not checked");
    }
    return false;
}

bool Parser::run_until(std::function<bool()> done) {
    done_ = std::move(done);
    return run();
}

int Parser::scan(Value& value) {
    return ended_ || diagnostics_.full() ? lexer::kEnd : lexer_.next(value);
}

namespace {

/// Describes the token at which the parser failed.
std::string describe(const lexer::Lexer& lexer, const lexer::BlockText& text) {
    switch (lexer.last_token()) {
        case lexer::kEob:
        case lexer::kEnd: return "the block ends too early";
        case lexer::kSequence: return "N must be at the start of a block, and only once";
        case lexer::kSkip: return "block delete '/' must be at the start of a block, and only once";
        case lexer::kProgram: return "a program name must be at the start of a block";
        case lexer::kFlowName:
        case lexer::kFlowLetter: return "an O-word must be at the start of a block, and only once";
        case lexer::kFlow: return "an O-word must be followed by one keyword, with its values in brackets";
        case lexer::kSet: return "'=' is not allowed here";
        case lexer::kPrint: return "POPEN, PCLOS and DPRNT[..] must be in a separate block";
        case lexer::kFunction:
        case lexer::kAtan:
        case lexer::kExists: return "a function must be in the value of a word or in an expression";
        case lexer::kSumWord:
        case lexer::kProductWord:
        case lexer::kPower:
        case lexer::kLogicWord:
        case lexer::kComparison: return "the operator has no value before it";
        case lexer::kNumber:
            return lexer.rules().has_o_words && text.structural ? "values after an O-word must be in brackets"
                                                                : "a number without its letter";
        case lexer::kHash:
        case lexer::kVariable: return "a variable must be the value of a word, or precede '='";
        case lexer::kRelation:
            return "a comparison is not allowed here; comparisons are combined as [..] AND [..]";
        case lexer::kDwell:
            return "G04 is given with an axis word, M98 or M99, or twice; it requires one of P, X and U, the "
                   "time in seconds";
        case lexer::kCall: return "M98 and M99 must be given only once in a block, and not with G04";
        case lexer::kAxis:
        case lexer::kAxisLetter:
        case lexer::kP:
        case lexer::kAxisOrTime:
            if (lexer.words().saw_dwell() && !text.words.empty()) {
                return fmt::format("{} has no meaning in a block with G04, which requires one of P, X and U",
                                   lexer::address_name(text.words.back().address));
            }
            break;
        case lexer::kAxisOrTimeLetter:
        case lexer::kPLetter:
        case lexer::kOtherLetter: break;
        case lexer::kThen:
        case lexer::kDo:
        case lexer::kGoto:
        case lexer::kIf:
        case lexer::kWhile:
        case lexer::kEndLoop:
            return "a keyword is not allowed here; IF [..] GOTO n, IF [..] THEN .., WHILE [..] DO m, END m "
                   "and GOTO n must be in a separate block";
        default: break;
    }
    const Token token = lexer.last_token();
    if (lexer.rules().separate_assignments && token == '=' && lexer.previous_token() == lexer::kVariable) {
        return "an assignment must be in a separate block";
    }
    if (token > ' ' && token < 0x7f) return fmt::format("'{}' is not allowed here", static_cast<char>(token));
    if (!text.words.empty())
        return fmt::format("{} is not allowed here", lexer::address_name(text.words.back().address));
    return "this is not allowed here";
}

/// Returns true for the first two letters of IF, WHILE, GOTO or END.
bool begins_macro_keyword(lexer::Address first, lexer::Address second) {
    return (first == 'I' && second == 'F') || (first == 'W' && second == 'H') ||
           (first == 'G' && second == 'O') || (first == 'E' && second == 'N');
}

bool is_variable(Token token) {
    return token == lexer::kVariable || token == lexer::kNamedVariable;
}

/// Returns true for a token that may directly follow `X#1`, so that a variable before it was no value.
bool may_follow_value(Token token) {
    return token == lexer::kEob || is_variable(token) ||
           (token >= lexer::kAxis && token <= lexer::kOtherLetter && token != lexer::kDwell &&
            token != lexer::kCall);
}

bool opens_word(Token token) {
    return token == lexer::kAxisLetter || token == lexer::kAxisOrTimeLetter || token == lexer::kPLetter ||
           token == lexer::kOtherLetter;
}

}  // namespace

void Parser::syntax_error() {
    lexer::BlockText& text = *block_.text;
    if (text.bad) return;  // the scanner has said it all
    if (opens_word(lexer_.previous_token())) {
        // The second of two letters has opened a word of its own.
        const std::size_t opened_words = opens_word(lexer_.last_token()) ? 1 : 0;
        const lexer::Word& word = text.words[lexer_.words().open_word_index() - opened_words];
        const bool keyword =
            opened_words == 1 && begins_macro_keyword(word.address, text.words.back().address);
        lexer_.errors().fail(word.column, DiagnosticKind::word_without_value,
                             fmt::format("{} has no value{}", lexer::address_name(word.address),
                                         keyword ? lexer_.rules().missing_keywords_hint : ""));
        return;
    }
    if (is_variable(lexer_.previous_token()) && may_follow_value(lexer_.last_token()) &&
        !lexer_.words().saw_dwell()) {
        lexer_.errors().fail(lexer_.previous_column(), DiagnosticKind::syntax,
                             "a variable must be the value of a word, or precede '='");
        return;
    }
    lexer_.errors().fail(lexer_.cursor().column(), DiagnosticKind::syntax, describe(lexer_, text));
}

void Parser::finish_block() {
    sink_.on_block(block_);
    block_.clear();
    lexer_.start_block();
    ended_ = done_ && done_();
}

void Parser::finish_bad_block() {
    lexer_.errors().fail(1, DiagnosticKind::syntax,
                         "the block is not valid");  // unless a closer message has been given
    finish_block();
}

void Parser::finish_tape() {
    block_.kind = BlockKind::tape;
    finish_block();
}

void Parser::set_role(std::uint32_t word, lexer::Role role) {
    block_.text->words[word].role = role;
}

void Parser::set_expression(std::uint32_t word, std::uint32_t node) {
    block_.text->words[word].expression = static_cast<std::int32_t>(node);
}

void Parser::set_sequence(Value value) {
    if (block_.sequence)
        lexer_.errors().fail(value.column, DiagnosticKind::word_twice, "a block must have only one N");
    block_.sequence = value.index;
    block_.prefix_column = value.column;
}

void Parser::set_skip(Value value) {
    if (block_.skip_level != 0)
        lexer_.errors().fail(value.column, DiagnosticKind::word_twice,
                             "a block must have only one block delete '/'");
    block_.skip_level = static_cast<std::uint8_t>(value.index);
    block_.prefix_column = value.column;
}

void Parser::set_program(std::uint32_t column) {
    block_.has_program = true;
    block_.prefix_column = column;
}

void Parser::set_target(Value node) {
    block_.target = static_cast<std::int32_t>(node.index);
    block_.target_column = node.column;
}

void Parser::set_loop(Value number) {
    block_.loop_column = number.column;
    const std::string_view digits = block_.text->view(block_.text->numbers[number.index]);
    block_.loop = digits.size() == 1 ? static_cast<std::uint32_t>(digits[0] - '0') : 0;
    if (block_.loop < 1 || block_.loop > 3)
        lexer_.errors().fail(number.column, DiagnosticKind::number, "DO and END require 1, 2 or 3");
}

void Parser::add_assignment(std::uint32_t target, std::uint32_t value) {
    block_.assignments.push_back({static_cast<std::int32_t>(target), static_cast<std::int32_t>(value)});
}

void Parser::set_flow_name(std::uint32_t column, std::optional<std::uint32_t> node) {
    block_.flow_column = column;
    block_.prefix_column = column;
    if (node) block_.flow_node = static_cast<std::int32_t>(*node);
}

void Parser::set_flow_program() {
    if (block_.flow_node >= 0) {
        lexer_.errors().fail(block_.flow_column, DiagnosticKind::structure,
                             "the name of a program must be a number or a name, not an expression");
    }
    block_.has_program = true;
}

namespace {

/// Number of values that follow a keyword.
struct FlowSyntax {
    std::size_t min;
    std::size_t max;
    std::string_view text;
};

FlowSyntax flow_syntax(Flow flow) {
    constexpr std::size_t kMaxArguments = 30;
    switch (flow) {
        case Flow::call: return {0, kMaxArguments, "up to 30 values, each in brackets"};
        case Flow::end_sub:
        case Flow::return_: return {0, 1, "at most one value"};
        case Flow::if_:
        case Flow::else_if:
        case Flow::while_: return {1, 1, "its condition in brackets"};
        case Flow::repeat: return {1, 1, "the number of repetitions in brackets"};
        default: return {0, 0, "nothing"};
    }
}

}  // namespace

void Parser::set_flow(Value keyword) {
    block_.kind = BlockKind::flow;
    block_.flow = static_cast<Flow>(keyword.index);
    const FlowSyntax shape = flow_syntax(block_.flow);
    if (block_.arguments.size() < shape.min || block_.arguments.size() > shape.max)
        lexer_.errors().fail(keyword.column, DiagnosticKind::word_value,
                             fmt::format("this keyword must be followed by {}", shape.text));
    const bool expression = block_.flow_node >= 0;
    if (expression && block_.flow != Flow::call) {
        lexer_.errors().fail(
            block_.flow_column, DiagnosticKind::structure,
            "an O-word whose number is an expression can only be called; others must be numbers or <names>");
    }
}

std::uint32_t Parser::add_named(Value name) {
    Node node;
    node.kind = NodeKind::named;
    node.number = block_.text->numbers[name.index];
    node.column = name.column;
    return push(node);
}

std::uint32_t Parser::push(const Node& node) {
    block_.nodes.push_back(node);
    return static_cast<std::uint32_t>(block_.nodes.size() - 1);
}

std::uint32_t Parser::add_number(Value number) {
    Node node;
    node.kind = NodeKind::number;
    node.number = block_.text->numbers[number.index];
    node.column = number.column;
    return push(node);
}

std::uint32_t Parser::add_variable(Value variable) {
    Node node;
    node.kind = NodeKind::variable;
    node.left = static_cast<std::int32_t>(variable.index);
    node.column = variable.column;
    return push(node);
}

std::uint32_t Parser::add_unbracketed_index(Value number) {
    if (!lexer_.rules().unbracketed_variable_index)
        lexer_.errors().fail(number.column, DiagnosticKind::syntax,
                             "a computed variable number must be in brackets, as in #[1+#2]");
    return add_node(NodeKind::indirect, Operator::add, number);
}

std::uint32_t Parser::add_node(NodeKind kind, Operator op, Value left, std::optional<Value> right) {
    Node node;
    node.kind = kind;
    node.op = op;
    node.left = static_cast<std::int32_t>(left.index);
    node.right = right ? static_cast<std::int32_t>(right->index) : -1;
    node.column = left.column;
    return push(node);
}

}  // namespace gsim::grammar
