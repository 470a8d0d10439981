#include "codegen/flow/oword_flow.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "base/text/format.h"
#include "codegen/flow/lua_limits.h"
#include "codegen/lua/expression_writer.h"
#include "codegen/lua/lua_text.h"

namespace gsim::codegen {

using lexer::DiagnosticKind;

using grammar::Block;
using grammar::Flow;

namespace {

constexpr int kMaxLevels = 80;  // Lua reads 200, of which expressions need some

/// Returns the levels of Lua that a structure needs; a `for` has four variables in addition.
int nesting_levels(Flow flow) {
    return flow == Flow::repeat ? 5 : flow == Flow::sub ? 3 : 1;
}

std::string_view keyword(Flow flow) {
    switch (flow) {
        case Flow::sub: return "sub";
        case Flow::if_: return "if";
        case Flow::while_: return "while";
        case Flow::do_: return "do";
        default: return "repeat";
    }
}

std::string_view program_name(const Block& block) {
    return block.text->view(block.text->program);
}

bool is_loop(Flow flow) {
    return flow == Flow::while_ || flow == Flow::do_ || flow == Flow::repeat;
}

}  // namespace

bool is_oword_number(std::string_view name) {
    const bool digits = !name.empty() && name.find_first_not_of("0123456789") == std::string_view::npos;
    return digits && name.size() <= 9 && (name.size() == 1 || name[0] != '0');
}

std::string oword_name(const Block& block) {
    const std::string_view name = program_name(block);
    if (is_oword_number(name)) return std::string(name);
    std::string quoted;
    write_lua_string(name, quoted);
    return quoted;
}

void OWordFlow::fail(const Block& block, const std::string& message) {
    if (!lost_) diagnostics_.error(block.text->at(block.flow_column), DiagnosticKind::structure, message);
    lost_ = true;  // one error of nesting causes others; only the first one helps
}

void OWordFlow::write(const Block& block, std::uint64_t weight, std::string& out) {
    weight_ = weight;
    switch (block.flow) {
        case Flow::program: return;
        case Flow::sub:
        case Flow::if_:
        case Flow::do_:
        case Flow::repeat: return open_structure(block, out);
        case Flow::while_: return write_while(block, out);
        case Flow::else_if:
        case Flow::else_: return write_else(block, out);
        case Flow::end_sub: return write_sub_end(block, out);
        case Flow::end_if: close_structure(block, Flow::if_, out); return;
        case Flow::end_while: close_structure(block, Flow::while_, out); return;
        case Flow::end_repeat: close_structure(block, Flow::repeat, out); return;
        case Flow::break_:
        case Flow::continue_: return write_jump(block, out);
        case Flow::call: return write_call(block, out);
        case Flow::return_: return write_return(block, out);
    }
}

void OWordFlow::open_structure(const Block& block, std::string& out) {
    if (block.flow == Flow::sub && open())
        fail(block, "a subroutine must not begin inside another one or inside a control structure");
    if (levels() + nesting_levels(block.flow) > kMaxLevels)
        fail(block, "O-words are nested too deep for Lua");
    switch (block.flow) {
        case Flow::sub: break;
        case Flow::if_:
            out += "if ";
            write_condition(block, block.arguments[0], out);
            out += " then ";
            break;
        case Flow::while_:
            out += "while ";
            write_condition(block, block.arguments[0], out);
            out += " do ";
            break;
        case Flow::do_: out += "repeat "; break;
        default:
            out += "for _ = 1, times(";
            write_number(block, block.arguments[0], out);
            out += ") do ";
            break;
    }
    open_.push_back({block.flow, std::string(program_name(block)), block.text->at(block.flow_column),
                     next_id_++, weight_});
}

void OWordFlow::fail_to_close(const Block& block, std::string_view end) {
    const std::string what = fmt::format("o{} {}", program_name(block), end);
    fail(block, open_.empty()
                    ? fmt::format("{} has no beginning", what)
                    : fmt::format("{} does not close o{} {}, which is open since line {}", what,
                                  open_.back().name, keyword(open_.back().kind), open_.back().location.line));
}

/// Returns true if the innermost structure is of this kind and name and has been closed.
bool OWordFlow::close_structure(const Block& block, Flow kind, std::string& out) {
    if (open_.empty() || open_.back().kind != kind || open_.back().name != program_name(block)) {
        fail_to_close(block, fmt::format("end{}", keyword(kind)));
        return false;
    }
    check_length(open_.back(), block.text->at(block.flow_column));
    write_end(open_.back(), out);
    open_.pop_back();
    return true;
}

/// Lua jumps over 2^24 instructions at most; a subroutine is a function, and jumps do not cross it.
void OWordFlow::check_length(const Structure& structure, const lexer::Location& end) {
    if (structure.kind == Flow::sub || weight_ - structure.weight <= kMaxJumpWeight) return;
    diagnostics_.error(structure.location, DiagnosticKind::too_large,
                       fmt::format("o{} {} up to line {} is too long for Lua; move its body to a subroutine",
                                   structure.name, keyword(structure.kind), end.line));
}

void OWordFlow::write_end(const Structure& structure, std::string& out) const {
    if (structure.has_continue) text::append_format(out, "::continue_{}:: ", structure.id);
    if (structure.kind != Flow::sub) out += "end ";
    if (structure.has_break) text::append_format(out, "::break_{}:: ", structure.id);
}

void OWordFlow::write_sub_end(const Block& block, std::string& out) {
    if (!block.arguments.empty()) write_return(block, out);
    close_structure(block, Flow::sub, out);
}

void OWordFlow::write_else(const Block& block, std::string& out) {
    if (open_.empty() || open_.back().kind != Flow::if_ || open_.back().name != program_name(block)) {
        fail(block, fmt::format("there is no open o{} if for this word", program_name(block)));
        return;
    }
    if (open_.back().has_else) fail(block, "only endif may follow else");
    if (block.flow == Flow::else_) {
        open_.back().has_else = true;
        out += "else ";
        return;
    }
    out += "elseif ";
    write_condition(block, block.arguments[0], out);
    out += " then ";
}

/// Writes the end of a do, or the head of a loop.
void OWordFlow::write_while(const Block& block, std::string& out) {
    const auto is_matching_do = [&](const Structure& structure) {
        return structure.kind == Flow::do_ && structure.name == program_name(block);
    };
    if (!open() || !is_matching_do(open_.back())) {
        if (std::any_of(open_.begin(), open_.end(), is_matching_do)) fail_to_close(block, "while");
        return open_structure(block, out);
    }
    const Structure structure = open_.back();
    check_length(structure, block.text->at(block.flow_column));
    open_.pop_back();
    if (structure.has_continue) text::append_format(out, "::continue_{}:: ", structure.id);
    out += "until not (";
    write_condition(block, block.arguments[0], out);
    out += ") ";
    if (structure.has_break) text::append_format(out, "::break_{}:: ", structure.id);
}

void OWordFlow::write_jump(const Block& block, std::string& out) {
    bool innermost = true;
    for (auto structure = open_.rbegin(); structure != open_.rend(); ++structure) {
        if (structure->kind == Flow::sub) break;
        if (!is_loop(structure->kind)) continue;
        if (structure->name == program_name(block)) {
            if (block.flow == Flow::continue_) {
                structure->has_continue = true;
                text::append_format(out, "goto continue_{} ", structure->id);
            } else if (innermost) {
                out += "break ";
            } else {
                // Lua's break leaves only the innermost loop; O-words name theirs.
                structure->has_break = true;
                text::append_format(out, "goto break_{} ", structure->id);
            }
            return;
        }
        innermost = false;
    }
    fail(block, fmt::format("there is no loop o{} around this block", program_name(block)));
}

void OWordFlow::write_call(const Block& block, std::string& out) const {
    out += "call(";
    if (block.flow_node >= 0) {
        write_number(block, block.flow_node, out);
    } else {
        out += oword_name(block);
    }
    for (const std::int32_t argument : block.arguments) {
        out += ", ";
        write_number(block, argument, out);
    }
    out += ") ";
}

int OWordFlow::levels() const {
    int sum = 0;
    for (const Structure& structure : open_) sum += nesting_levels(structure.kind);
    return sum;
}

bool OWordFlow::inside_sub() const {
    return !open_.empty() && open_.front().kind == Flow::sub;
}

void OWordFlow::write_return(const Block& block, std::string& out) {
    if (!inside_sub()) fail(block, "return must be inside a subroutine");
    // Lua requires `return` at the end of a block, so it gets one of its own; a program may continue past it.
    out += "do return ";
    if (!block.arguments.empty()) {
        out += "result(";
        write_number(block, block.arguments[0], out);
        out += ") ";
    }
    out += "end ";
}

void OWordFlow::end_program() {
    if (!lost_) {
        for (const Structure& structure : open_) {
            diagnostics_.error(structure.location, DiagnosticKind::structure,
                               fmt::format("o{} {} is not closed", structure.name, keyword(structure.kind)));
        }
    }
    open_.clear();
    lost_ = false;
}

}  // namespace gsim::codegen
