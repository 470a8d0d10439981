#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/syntax.h"
#include "lexer/diagnostics.h"

namespace gsim::codegen {

/// Returns true if a name of an O-word is a number: digits without a zero before them. The scanner removes
/// zeros from a number, not from a name in < >.
bool is_oword_number(std::string_view name);

/// Returns the name in the O-word of a block in Lua's form: a number, or a quoted text.
std::string oword_name(const grammar::Block& block);

/// Writer of the O-words of RS274/NGC as control structures of Lua. They nest by their names (o100 if .. o100
/// endif); an error is reported at its position.
class OWordFlow {
  public:
    explicit OWordFlow(lexer::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

    /// Appends the Lua of a block of BlockKind::flow and a blank; the caller writes the function around a
    /// subroutine's body. `weight`: instructions of Lua before it in its program, as an upper bound.
    void write(const grammar::Block& block, std::uint64_t weight, std::string& out);
    /// Records that a block with an O-word could not be understood. The open structures are then uncertain,
    /// and errors of nesting are not reported in this program.
    void stop_nesting_checks() { lost_ = true; }
    /// Returns true inside of any structure.
    bool open() const { return !open_.empty(); }
    bool inside_sub() const;
    /// Returns the levels of Lua's nesting that the open structures need.
    int levels() const;
    /// Reports structures that are left open, and starts again.
    void end_program();

  private:
    struct Structure {
        grammar::Flow kind;  ///< sub, if_, while_, do_ or repeat
        std::string name;
        lexer::Location location;
        std::uint32_t id;  ///< For labels.
        std::uint64_t weight;
        bool has_else = false;
        bool has_continue = false;  ///< Its end needs a label for `continue`,
        bool has_break = false;     ///< or one past it for `break` out of an inner loop.
    };

    void open_structure(const grammar::Block& block, std::string& out);
    void fail_to_close(const grammar::Block& block, std::string_view end);
    bool close_structure(const grammar::Block& block, grammar::Flow kind, std::string& out);
    void write_end(const Structure& structure, std::string& out) const;
    void check_length(const Structure& structure, const lexer::Location& end);
    void write_sub_end(const grammar::Block& block, std::string& out);
    void write_else(const grammar::Block& block, std::string& out);
    void write_while(const grammar::Block& block, std::string& out);
    void write_jump(const grammar::Block& block, std::string& out);
    void write_call(const grammar::Block& block, std::string& out) const;
    void write_return(const grammar::Block& block, std::string& out);
    void fail(const grammar::Block& block, const std::string& message);

    lexer::Diagnostics& diagnostics_;
    std::vector<Structure> open_;
    std::uint32_t next_id_ = 1;
    std::uint64_t weight_ = 0;
    bool lost_ = false;
};

}  // namespace gsim::codegen
