#include "codegen/flow/jump_scan.h"

#include <array>
#include <charconv>
#include <cstring>
#include <limits>
#include <string_view>

#include "codegen/blocks/call_codes.h"
#include "codegen/blocks/leader_scan.h"
#include "grammar/parser.h"

namespace gsim::codegen {

namespace {

/// Targets beyond Lua's label limit are not collected: the second reading reports the program.
constexpr std::size_t kMaxTargets = 40000;

/// Finder of the letters GOTO in any case, or of the digits 99 that follow an M, in a text that arrives in
/// parts.
class JumpFinder {
  public:
    /// Returns true once one of them has come.
    bool find(const char* text, std::size_t size) {
        if (matched_length_ == 0 && !is_after_m_ && !may_contain_jump(text, size)) {
            matched_length_ = (text[size - 1] & ~0x20) == 'G' ? 1 : 0;  // its O may come next
            return false;
        }
        for (std::size_t i = 0; i < size; ++i) {
            const char c = text[i];
            const char letter = static_cast<char>(c & ~0x20);
            matched_length_ =
                letter == kWord[matched_length_] ? matched_length_ + 1 : (letter == 'G' ? 1 : 0);
            if (matched_length_ == kWord.size() || (is_after_m_ && c == '9' && last_ == '9')) return true;
            if (kBetween.find(c) == std::string_view::npos) is_after_m_ = letter == 'M';
            last_ = c;
        }
        return false;
    }

  private:
    static constexpr std::string_view kWord = "GOTO";
    static constexpr std::string_view kBetween = "09+ \t\r\v\f";  ///< Between M and 99.

    /// A tool path has long parts without any of these letters.
    static bool may_contain_jump(const char* text, std::size_t size) {
        for (const char letter : {'O', 'o', 'M', 'm'}) {
            if (std::memchr(text, letter, size) != nullptr) return true;
        }
        return false;
    }

    std::size_t matched_length_ = 0;
    char last_ = 0;
    bool is_after_m_ = false;
};

bool mentions_jump(lexer::Source& source) {
    std::array<char, 16384> buffer;
    JumpFinder finder;
    while (const std::size_t count = source.read(buffer.data(), buffer.size())) {
        if (finder.find(buffer.data(), count)) return true;
    }
    return false;
}

class JumpCollector : public grammar::BlockSink {
  public:
    explicit JumpCollector(FileScan& scan) : scan_(scan) { scan_.jumps.emplace_back(); }

    void on_block(const grammar::Block& block) override {
        if (block.has_program && begun_) scan_.jumps.emplace_back();
        if (!grammar::is_blank(block)) {
            begun_ = true;
            scan_.jumps.back().last_line = block.text->at(1).line;
        }
        if (block.text->bad) return;
        if (block.kind == grammar::BlockKind::jump || block.kind == grammar::BlockKind::if_goto)
            add_target(block);
        for (const lexer::Word& word : block.text->words) {
            const bool calls = (word.address == 'M' && word.code_x10 == kCallCode) ||
                               (word.address == 'G' && word.code_x10 == kMacroCode);
            if (calls) scan_.jumps.back().calls = true;
            if (word.address == 'M' && word.code_x10 == kReturnCode) record_return(block);
        }
    }

    /// To be called at the end.
    void set_returns_to_blocks() {
        for (ProgramJumps& jumps : scan_.jumps) jumps.returns_to_blocks = returns_to_blocks_;
    }

  private:
    /// Handles M99 P: in the first program a jump, else one in the calling program.
    void record_return(const grammar::Block& block) {
        for (const lexer::Word& word : block.text->words) {
            if (word.address != 'P') continue;
            if (scan_.jumps.size() > 1) {
                returns_to_blocks_ = true;
            } else if (word.expression >= 0) {
                scan_.jumps.back().computed = true;
            } else {
                add_number(block.text->view(word.number));
            }
        }
    }

    void add_target(const grammar::Block& block) {
        const grammar::Node& node = block.node(block.target);
        if (node.kind != grammar::NodeKind::number) {
            scan_.jumps.back().computed = true;
        } else {
            add_number(block.text->view(node.number));
        }
    }

    void add_number(std::string_view digits) {
        std::set<std::uint32_t>& targets = scan_.jumps.back().targets;
        std::uint32_t number = 0;
        const char* end = digits.data() + digits.size();
        if (std::from_chars(digits.data(), end, number).ptr == end && targets.size() < kMaxTargets)
            targets.insert(number);
    }

    FileScan& scan_;
    bool begun_ = false;
    bool returns_to_blocks_ = false;
};

/// Checks if the first block with content begins a program or a subroutine.
class FirstBlock : public grammar::BlockSink {
  public:
    void on_block(const grammar::Block& block) override {
        begins_program_or_sub_ =
            block.has_program || (block.kind == grammar::BlockKind::flow && block.flow == grammar::Flow::sub);
        done_ = !grammar::is_blank(block);
    }
    bool done() const { return done_; }
    bool begins_program_or_sub() const { return begins_program_or_sub_; }

  private:
    bool done_ = false;
    bool begins_program_or_sub_ = false;
};

}  // namespace

const ProgramJumps& FileScan::program(std::size_t ordinal) const {
    static const ProgramJumps kNoJumps;
    return ordinal < jumps.size() ? jumps[ordinal] : kNoJumps;
}

FileScan scan_file(lexer::Source& source, const lexer::Aliases& aliases, const grammar::Dialect& dialect) {
    FileScan scan;
    scan.leader_lines = leader_lines(source, aliases, dialect.text());
    const auto ignore_diagnostic = [](const text::Diagnostic&) {};
    constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
    {
        lexer::Diagnostics diagnostics(source, kNoLimit, ignore_diagnostic);
        lexer::Lexer lexer(source, diagnostics, aliases, dialect.text());
        lexer.extent().skip_leader(scan.leader_lines);
        FirstBlock first;
        grammar::Parser(lexer, diagnostics, first).run_until([&] { return first.done(); });
        scan.starts_with_part = first.begins_program_or_sub();
        source.rewind();
    }
    const bool return_alias = aliases.has_alias_of('M', kReturnCode / 10);
    if (dialect.rules().has_block_jumps && (return_alias || mentions_jump(source))) {
        source.rewind();
        lexer::Diagnostics diagnostics(source, kNoLimit, ignore_diagnostic);
        lexer::Lexer lexer(source, diagnostics, aliases, dialect.text());
        lexer.extent().skip_leader(scan.leader_lines);
        JumpCollector collector(scan);
        grammar::Parser(lexer, diagnostics, collector).run();
        collector.set_returns_to_blocks();
    }
    source.rewind();
    return scan;
}

}  // namespace gsim::codegen
