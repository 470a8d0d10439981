#include "tests/grammar/parse.h"

#include <array>

#include <fmt/format.h>

#include "grammar/parser.h"

namespace gsim::grammar {
namespace {

std::string_view name(Operator op) {
    static constexpr std::array<std::string_view, 33> kNames = {
        "+",     "-",   "*",   "/",   "MOD", "AND", "OR",   "XOR",  "EQ",   "NE",   "GT",
        "GE",    "LT",  "LE",  "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN", "SQRT", "ABS",
        "ROUND", "FIX", "FUP", "LN",  "EXP", "BIN", "BCD",  "**",   "EQ~",  "NE~",  "EXISTS"};
    return kNames.at(static_cast<std::size_t>(op));
}

/// The tree in prefix notation: (+ 1 (* 2 #3)).
std::string tree(const Block& block, std::int32_t index) {
    const Node& node = block.node(index);
    switch (node.kind) {
        case NodeKind::number: return std::string(block.text->view(node.number));
        case NodeKind::variable: return fmt::format("#{}", node.left);
        case NodeKind::indirect: return fmt::format("(# {})", tree(block, node.left));
        case NodeKind::negate: return fmt::format("(neg {})", tree(block, node.left));
        case NodeKind::binary:
            return fmt::format("({} {} {})", name(node.op), tree(block, node.left), tree(block, node.right));
        case NodeKind::named: return fmt::format("#<{}>", block.text->view(node.number));
        case NodeKind::exists: return fmt::format("(EXISTS {})", tree(block, node.left));
        case NodeKind::call: break;
    }
    const std::string second = node.right >= 0 ? fmt::format(" {}", tree(block, node.right)) : "";
    return fmt::format("({} {}{})", name(node.op), tree(block, node.left), second);
}

std::string_view name(lexer::Role role) {
    static constexpr std::array<std::string_view, 5> kNames = {"", ":axis", ":time", ":program",
                                                               ":parameter"};
    return kNames.at(static_cast<std::size_t>(role));
}

std::string content(const Block& block) {
    std::string out;
    for (const lexer::Word& word : block.text->words) {
        out += fmt::format(
            " {}={}{}", lexer::address_name(word.address),
            word.expression >= 0 ? tree(block, word.expression) : std::string(block.text->view(word.number)),
            name(word.role));
    }
    for (const Assignment& a : block.assignments)
        out += fmt::format(" {}:={}", tree(block, a.target), tree(block, a.value));
    return out;
}

std::string flow(const Block& block) {
    static constexpr std::array<std::string_view, 16> kNames = {
        "program", "sub",   "endsub",   "call", "return", "if",        "elseif", "else",
        "endif",   "while", "endwhile", "do",   "repeat", "endrepeat", "break",  "continue"};
    std::string out = fmt::format("{} o{}", kNames.at(static_cast<std::size_t>(block.flow)),
                                  block.flow_node >= 0 ? tree(block, block.flow_node)
                                                       : std::string(block.text->view(block.text->program)));
    for (const std::int32_t argument : block.arguments) out += fmt::format(" {}", tree(block, argument));
    return out;
}

std::string body(const Block& block) {
    switch (block.kind) {
        case BlockKind::words: return "words" + content(block);
        case BlockKind::assignments: return "assign" + content(block);
        case BlockKind::if_goto:
            return fmt::format("if {} goto {}", tree(block, block.condition), tree(block, block.target));
        case BlockKind::if_then:
            return fmt::format("if {} then{}", tree(block, block.condition), content(block));
        case BlockKind::while_do:
            return fmt::format("while {} do {}", tree(block, block.condition), block.loop);
        case BlockKind::end_loop: return fmt::format("end {}", block.loop);
        case BlockKind::jump: return fmt::format("goto {}", tree(block, block.target));
        case BlockKind::print:
            return fmt::format("print {} {}", static_cast<int>(block.print),
                               block.text->view(block.text->print));
        case BlockKind::flow: return flow(block);
        case BlockKind::tape: return "tape";
    }
    return "";
}

class Writer : public BlockSink {
  public:
    explicit Writer(std::vector<std::string>& blocks) : blocks_(blocks) {}

    void on_block(const Block& block) override {
        std::string out;
        if (block.has_program) out += fmt::format("O{} ", block.text->view(block.text->program));
        if (block.sequence) out += fmt::format("N{} ", *block.sequence);
        if (block.skip_level != 0) out += fmt::format("/{} ", block.skip_level);
        blocks_.push_back(block.text->bad ? "bad" : out + body(block));
    }

  private:
    std::vector<std::string>& blocks_;
};

}  // namespace

Parsed parse(std::string_view text, const Dialect& dialect) {
    Parsed result;
    lexer::Source source = lexer::Source::from_text(std::string(text), "t");
    lexer::Diagnostics diagnostics(source, 1000, [&](const text::Diagnostic& reported) {
        const std::string message = text::to_text(reported);
        result.messages += std::string(message.substr(2, message.find('\n') - 1));
    });
    const lexer::Aliases aliases;
    lexer::Lexer lexer(source, diagnostics, aliases, dialect.text());
    Writer writer(result.blocks);
    result.finished = Parser(lexer, diagnostics, writer).run();
    return result;
}

Parsed parse_ngc(std::string_view text) {
    return parse(text, dialect_rs274ngc());
}

std::string repeated(std::string before, std::string_view fragment, std::size_t count) {
    std::string text = std::move(before);
    for (std::size_t i = 0; i < count; ++i) text += fragment;
    return text;
}

}  // namespace gsim::grammar
