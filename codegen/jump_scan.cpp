#include "codegen/jump_scan.h"

#include <array>
#include <charconv>
#include <limits>
#include <string_view>

#include "grammar/parser.h"

namespace gsim::codegen {

namespace {

/// Targets beyond what Lua can label are not collected: the second reading reports the program.
constexpr std::size_t kMaxTargets = 40000;

/// Looks for the letters GOTO in any case, through a window, so that the common program without them costs
/// hardly more than reading it.
bool mentions_goto(lexer::Source& source) {
    constexpr std::string_view kWord = "GOTO";
    std::array<char, 65536> buffer;
    std::size_t matched = 0;
    while (const std::size_t count = source.read(buffer.data(), buffer.size())) {
        for (std::size_t i = 0; i < count; ++i) {
            const char c = static_cast<char>(buffer[i] & ~0x20);
            matched = c == kWord[matched] ? matched + 1 : (c == 'G' ? 1 : 0);
            if (matched == kWord.size()) return true;
        }
    }
    return false;
}

class JumpCollector : public grammar::BlockSink {
  public:
    explicit JumpCollector(FileScan& scan) : scan_(scan) { scan_.jumps.emplace_back(); }

    void take(const grammar::Block& block) override {
        if (block.has_program && begun_) scan_.jumps.emplace_back();
        begun_ |= !grammar::is_blank(block);
        if (block.text->bad) return;
        if (block.kind == grammar::BlockKind::jump || block.kind == grammar::BlockKind::if_goto)
            add_target(block);
    }

  private:
    void add_target(const grammar::Block& block) {
        const grammar::Node& node = block.node(block.target);
        ProgramJumps& jumps = scan_.jumps.back();
        std::uint32_t number = 0;
        const std::string_view digits = block.text->view(node.number);
        if (node.kind != grammar::NodeKind::number) {
            jumps.computed = true;
        } else if (std::from_chars(digits.data(), digits.data() + digits.size(), number).ptr ==
                       digits.data() + digits.size() &&
                   jumps.targets.size() < kMaxTargets) {
            jumps.targets.insert(number);
        }
    }

    FileScan& scan_;
    bool begun_ = false;
};

/// Finds out whether the first block that says anything starts a program.
class FirstBlock : public grammar::BlockSink {
  public:
    void take(const grammar::Block& block) override {
        program_ = block.has_program;
        done_ = !grammar::is_blank(block);
    }
    bool done() const { return done_; }
    bool program() const { return program_; }

  private:
    bool done_ = false;
    bool program_ = false;
};

}  // namespace

const ProgramJumps& FileScan::program(std::size_t ordinal) const {
    static const ProgramJumps kNone;
    return ordinal < jumps.size() ? jumps[ordinal] : kNone;
}

FileScan scan_file(lexer::Source& source, const lexer::Aliases& aliases) {
    FileScan scan;
    const auto silent = [](std::string_view) {};
    constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
    {
        lexer::Diagnostics diagnostics(source, kNoLimit, silent);
        lexer::Lexer lexer(source, diagnostics, aliases);
        FirstBlock first;
        grammar::Parser(lexer, diagnostics, first).run_until([&] { return first.done(); });
        scan.starts_with_program = first.program();
        source.rewind();
    }
    if (mentions_goto(source)) {
        source.rewind();
        lexer::Diagnostics diagnostics(source, kNoLimit, silent);
        lexer::Lexer lexer(source, diagnostics, aliases);
        JumpCollector collector(scan);
        grammar::Parser(lexer, diagnostics, collector).run();
    }
    source.rewind();
    return scan;
}

}  // namespace gsim::codegen
