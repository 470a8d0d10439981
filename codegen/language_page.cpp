#include "codegen/language_page.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/letter_case.h"
#include "grammar/controller_name.h"
#include "grammar/dialect.h"
#include "lexer/names.h"

namespace gsim::codegen {

using grammar::AxisUse;
using grammar::Code;
using grammar::Dialect;
using grammar::Group;
using grammar::Phase;
using grammar::Support;

namespace {

/// Lines of Markdown.
class Page {
  public:
    template <typename... Args>
    void line(fmt::format_string<Args...> format, Args&&... args) {
        text::append_format(text_, format, std::forward<Args>(args)...);
        text_ += '\n';
    }
    std::string release() { return std::move(text_); }

  private:
    std::string text_;
};

std::string argument_words(const Code& code) {
    std::string words = code.axes == AxisUse::none ? "" : "axes";
    const auto add = [&](std::string_view word) {
        if (!words.empty()) words += ' ';
        words += word;
    };
    for (const char letter : code.words) {
        switch (letter) {
            case '=': add("AR="); break;
            case '1': add("I1= J1= K1="); break;
            case ',': break;  // ,C ,R and ,A are separate words
            case '*': add("(I J K several times)"); break;
            default: add(std::string_view(&letter, 1)); break;
        }
    }
    return words;
}

std::string lua_text(const Code& code) {
    if (code.support == Support::planned) return "refused";
    const bool has_words = code.axes != AxisUse::none || !code.words.empty();
    return fmt::format("`{}{}`", grammar::lua_name(code), has_words ? "{..}" : "()");
}

bool is_initial(const Dialect& dialect, const Code& code) {
    return dialect.rules().initial.find(fmt::format(" {} ", grammar::code_name(code))) !=
           std::string_view::npos;
}

/// Returns true for rows that differ only in their number: the settable frames, the user codes.
bool is_continuation(const Code& before, const Code& code) {
    return before.letter == code.letter && before.group == code.group && before.meaning == code.meaning &&
           code.code_x10 == before.code_x10 + 10 &&
           (code.group == Group::user || code.group == Group::work_frame);
}

void add_group(Page& page, const Dialect& dialect, const std::vector<const Code*>& codes) {
    page.line("| code | meaning | words | Lua | at the start |");
    page.line("| --- | --- | --- | --- | --- |");
    for (std::size_t i = 0; i < codes.size(); ++i) {
        std::size_t last = i;
        while (last + 1 < codes.size() && is_continuation(*codes[last], *codes[last + 1])) ++last;
        const std::string to = last > i ? fmt::format(" to {}", grammar::code_name(*codes[last])) : "";
        page.line("| {}{} | {} | {} | {} | {} |", grammar::code_name(*codes[i]), to, codes[i]->meaning,
                  argument_words(*codes[i]), lua_text(*codes[i]),
                  is_initial(dialect, *codes[i]) ? "yes" : "");
        i = last;
    }
    page.line("");
}

void add_codes(Page& page, const Dialect& dialect) {
    for (std::size_t index = 0; index < grammar::kGroupCount; ++index) {
        const auto group = static_cast<Group>(index);
        std::vector<const Code*> codes;
        for (const Code& code : dialect.codes()) {
            if (code.group == group) codes.push_back(&code);
        }
        if (codes.empty()) continue;
        const std::string_view title = grammar::name(group);
        page.line("### {}{}\n", text::upper(title.substr(0, 1)), title.substr(1));
        add_group(page, dialect, codes);
    }
}

void add_order(Page& page, const Dialect& dialect) {
    std::vector<Phase> phases{Phase::feed, Phase::spindle_speed, Phase::tool};
    for (const Code& code : dialect.codes()) {
        if (std::find(phases.begin(), phases.end(), code.phase) == phases.end()) phases.push_back(code.phase);
    }
    std::sort(phases.begin(), phases.end(),
              [&](Phase a, Phase b) { return dialect.rank(a) < dialect.rank(b); });
    page.line("### Order of execution in a block\n");
    constexpr std::int32_t kFirstFrame = 5050;  // G505 and what follows are too many to list
    for (std::size_t i = 0; i < phases.size(); ++i) {
        std::string codes;
        for (const Code& code : dialect.codes()) {
            const bool is_visible =
                code.phase == phases[i] && code.group != Group::user && code.code_x10 < kFirstFrame;
            if (is_visible) codes += (codes.empty() ? ": " : " ") + grammar::code_name(code);
        }
        page.line("{}. {}{}", i + 1, grammar::name(phases[i]), codes);
    }
    page.line("");
}

void add_letters(Page& page, const Dialect& dialect) {
    page.line("### Letters\n");
    page.line("| letter | meaning |");
    page.line("| --- | --- |");
    for (const grammar::Letter& letter : dialect.rules().letters)
        page.line("| {} | {} |", letter.address, letter.meaning);
    page.line("");
}

void add_expressions(Page& page, const Dialect& dialect) {
    page.line("### Functions and operators\n");
    page.line("| name | meaning |");
    page.line("| --- | --- |");
    for (const lexer::ExpressionName& name : dialect.rules().expression_names)
        page.line("| {} | {} |", name.name, name.meaning);
    page.line("");
}

void add_dialect(Page& page, const Dialect& dialect) {
    page.line("## {} (`--dialect {}`)\n", dialect.title(), dialect.name());
    add_letters(page, dialect);
    add_codes(page, dialect);
    add_order(page, dialect);
    add_expressions(page, dialect);
}

constexpr std::string_view kPageHeader =
    R"(# The language, code by code

Generated by `make docs` from the tables of the translator; a test compares the two. The details of each word
are in `lua_lib/`, the differences between the dialects in [dialects.md](dialects.md). `--unknown warn` skips codes
that a dialect does not have; without it they are errors. `refused`: the language has the code, gsim does not support it.
)";

constexpr std::string_view kMacroStatements = R"(### Statements

| G-code | Lua |
| --- | --- |
| `#1=#2+4` | `v[1] = v[2] + 4.0` |
| `#[#1+1]=0` | `v[v[1] + 1.0] = 0.0` |
| `X#1`, `X-[#1+2]` | `x=v[1]`, `x=(-(v[1] + 2.0))` |
| `IF[#1 EQ 5]GOTO100` | `if v[1] == 5.0 then goto N100 end` |
| `IF[#1 EQ 5]THEN #2=1` | `if v[1] == 5.0 then v[2] = 1.0 end` |
| `GOTO100`, `GOTO#1` | `goto N100`, `jump = goto_target(v[1]) goto computed` |
| `WHILE[#1 LT 10]DO1` .. `END1` | `while v[1] < 10.0 do` .. `end` |
| `M98P2L3`, `M99`, `M99P100` | `M98{p=2, l=3}`, `do return (M99()) end`, `do return (M99{p=100}) end` |
| `G65P9010A1B2` | `G65{p=9010, a=1, b=2}` |
| `POPEN`, `DPRNT[X#100[53]]`, `PCLOS` | `POPEN()`, `DPRNT("X%.3f", v[100])`, `PCLOS()` |
| `#3000=1(TOOL BROKEN)` | `message("TOOL BROKEN") v[3000] = 1.0` |
| `G1X10,R2` | `corner(2) G1{x=10}`; `,C2`: `chamfer(2)`; `,A30`: `line_angle(30)` |
| `/2 M08` | `if not skipped(2) then M8() end` |
| `O0012` | `end) program(12, function()` |

Binding: brackets and functions; `*` `/` `MOD` `AND`; `+` `-` `OR` `XOR`; comparisons. A vacant variable is `nil`.
)";

constexpr std::string_view kControllers = R"(
## Names of controllers

`--dialect`, and `dialect` under `[program]` of a machine file, accept these names; capitals, blanks, dots, dashes and slashes are ignored. If the language of a controller is only similar
to the dialect, a warning reports it.
)";

constexpr std::string_view kFlowHeader = R"(### O-words

| O-word | meaning |
| --- | --- |)";

constexpr std::string_view kFlowStatements = R"(
### Statements

| G-code | Lua |
| --- | --- |
| `#1=2 #2=#1` | `v[1], v[2] = 2.0, v[1]` (right sides see the old values) |
| `#1=2 X#1` | `do local w1 = v[1] v[1] = 2.0 move{x=w1} end` (so do words) |
| `G20 X#5420` | `do local w1 = v[5420] G20() move{x=w1} end` (values first, if more than one code acts) |
| `G[#<_plane>/10]`, `M#1` | `code("G", p._plane / 10.0)`, `code("M", v[1])` |
| `#<width>=5`, `#<_global>` | `p.width = 5.0`, `p._global` |
| `EXISTS[#<width>]` | `exists("width")` |
| `[#1 EQ 2]`, `[#1 ** 2]` | `equal(v[1], 2.0)`, `POW(v[1], 2.0)` |
| `o100 sub` .. `o100 endsub [#1]` | `end) sub(100, function()` .. `do return result(v[1]) end end)`; the program continues with `more(function()` |
| `o<drill> call [1] [2]` | `call("drill", 1.0, 2.0)` |
| `o1 if [#1 GT 0]`, `o1 while [#1 GT 0]` | `if v[1] > 0.0 then`, `while v[1] > 0.0 do` |
| `o1 repeat [3]` | `for _ = 1, times(3.0) do` |
| `(MSG,text)`, `(DEBUG,x=#1)`, `(PRINT,..)`, `(LOG,..)` | `MSG("text")`, `DEBUG("x=%f", v[1])`, ... |
| `G1 @5 ^30` | `G1{radius=5, angle=30}` |
| `O0012` | `end) program(12, function()` (called by M98) |

Binding: brackets and functions; `**`; `*` `/` `MOD`; `+` `-`; comparisons; `AND` `OR` `XOR`; each from left to right.)";

constexpr std::string_view kCommandLines = R"(
### Lines

One command per line, the first; the following words are its parameters. `;` begins a comment. Commands and parameters that Klipper does not know or read have no effect; a warning reports each of them once,
with the count.

| line | Lua |
| --- | --- |
| `G1 X10 Y+5 F600` | `G1{x=10, y=5, f=600}` |
| `G21 G90 G94` | `G21()` (and a warning of G90 and G94) |
| `M6`, `X40` | nothing, and a warning |
| `SET_VELOCITY_LIMIT ACCEL=500` | `SET_VELOCITY_LIMIT{accel=500}` |)";

void add_statements(Page& page, const Dialect& dialect) {
    if (!dialect.text().has_o_words) return page.line("{}", kMacroStatements);
    page.line("{}", kFlowHeader);
    for (const lexer::FlowName& flow : lexer::kFlowNames)
        page.line("| {} | {} |", text::lower(flow.name), flow.meaning);
    page.line("{}", kFlowStatements);
}

void add_command_dialect(Page& page, const Dialect& dialect) {
    page.line("\n## {} (`--dialect {}`)\n", dialect.title(), dialect.name());
    add_letters(page, dialect);
    add_codes(page, dialect);
    page.line("### Commands with names\n");
    page.line("| command | parameters | meaning |");
    page.line("| --- | --- | --- |");
    for (const grammar::ExtendedCommand& command : dialect.rules().extended) {
        const std::string_view between = command.texts.empty() || command.parameters.empty() ? "" : " ";
        page.line("| {} | {}{}{} | {} |", command.name, command.texts, between, command.parameters,
                  command.meaning);
    }
    page.line("{}", kCommandLines);
}

}  // namespace

std::string language_page() {
    Page page;
    page.line("{}", kPageHeader);
    page.line("{}", kControllers);
    page.line("{}", grammar::controller_table());
    for (const Dialect* dialect : grammar::dialects()) {
        if (dialect->text().form == lexer::TextForm::command_lines) {
            add_command_dialect(page, *dialect);
        } else {
            add_dialect(page, *dialect);
            add_statements(page, *dialect);
        }
    }
    return page.release();
}

}  // namespace gsim::codegen
