#include "codegen/blocks/leader_scan.h"

#include <limits>
#include <string_view>

#include "grammar/parser.h"

namespace gsim::codegen {

namespace {

class LeaderFinder : public grammar::BlockSink {
  public:
    void on_block(const grammar::Block& block) override {
        if (block.kind == grammar::BlockKind::tape) {
            if (mark_line_ > 0 || !has_text_) done_ = true;
            mark_line_ = block.text->begin.line;
        } else if (!grammar::is_blank(block)) {
            leads_ = mark_line_ > 0;
            done_ = leads_ || !block.text->bad;
            has_text_ = true;
        }
    }
    bool done() const { return done_; }
    std::uint32_t lines() const { return leads_ ? mark_line_ - 1 : 0; }

  private:
    std::uint32_t mark_line_ = 0;  ///< Line of the first %; 0: not found yet.
    bool has_text_ = false;        ///< Text before it that is no block.
    bool leads_ = false;
    bool done_ = false;
};

}  // namespace

std::uint32_t leader_lines(lexer::Source& source, const lexer::Aliases& aliases,
                           const lexer::TextRules& rules) {
    if (!rules.tape_leader) return 0;
    lexer::Diagnostics diagnostics(source, std::numeric_limits<std::size_t>::max(),
                                   [](const text::Diagnostic&) {});
    lexer::Lexer lexer(source, diagnostics, aliases, rules);
    LeaderFinder finder;
    grammar::Parser(lexer, diagnostics, finder).run_until([&] { return finder.done(); });
    source.rewind();
    return finder.lines();
}

}  // namespace gsim::codegen
