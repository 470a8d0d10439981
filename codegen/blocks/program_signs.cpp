#include "codegen/blocks/program_signs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "base/text/digits.h"
#include "codegen/blocks/plain_lines.h"

namespace gsim::codegen {

namespace {

/// Feature that one language has and the others do not have.
struct Sign {
    std::string_view text;      // as in the program
    std::string_view dialect;   // suggested one; empty: no dialect of ours reads it
    std::string_view language;  // as people call it
    bool sure = true;           // the other dialect has no such thing at all
};

constexpr std::string_view kNgcName = "rs274ngc";
constexpr std::string_view kAb9Name = "ab9";
constexpr std::string_view kNgcTitle = "RS274/NGC (LinuxCNC)";
constexpr std::string_view kAb9Title = "the 9/Series (and its relatives, as Fanuc and Haas)";

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::string blanks_removed(std::string_view text) {
    std::string out;
    std::copy_if(text.begin(), text.end(), std::back_inserter(out),
                 [](char c) { return c != ' ' && c != '\t' && c != '\r'; });
    return out;
}

// Returns the text after the name or number of an O-word; empty if a line has no O-word.
std::string_view behind_o(std::string_view line) {
    std::size_t at =
        line.starts_with("N") ? std::min(line.find_first_not_of("0123456789", 1), line.size()) : 0;
    if (at >= line.size() || line[at] != 'O') return {};
    ++at;
    if (at < line.size() && line[at] == '<') {
        at = std::min(line.find('>', at), line.size() - 1) + 1;
    } else {
        at = std::min(line.find_first_not_of("0123456789", at), line.size());
    }
    return line.substr(at);
}

constexpr std::array<std::string_view, 14> kOWords{"SUB",    "ENDSUB",    "CALL",   "IF",       "ELSEIF",
                                                   "ELSE",   "ENDIF",     "WHILE",  "ENDWHILE", "DO",
                                                   "REPEAT", "ENDREPEAT", "RETURN", "BREAK"};

// Returns true if the line contains `text` with a digit after it.
bool has_numbered(std::string_view line, std::string_view text) {
    for (std::size_t at = line.find(text); at != std::string_view::npos; at = line.find(text, at + 1)) {
        const std::size_t behind = at + text.size();
        if (behind < line.size() && (text::is_digit(line[behind]) || line[behind] == '#')) return true;
    }
    return false;
}

// Returns the feature of RS274/NGC in a line without blanks.
std::optional<Sign> ngc_sign(std::string_view line) {
    if (line.find("#<") != std::string_view::npos) return Sign{"#<name>", kNgcName, kNgcTitle};
    const std::string_view flow = behind_o(line);
    for (const std::string_view word : kOWords) {
        if (flow.starts_with(word)) return Sign{"an O-word", kNgcName, kNgcTitle};
    }
    if (line.find("EXISTS[") != std::string_view::npos) return Sign{"EXISTS", kNgcName, kNgcTitle};
    if (line.find("**") != std::string_view::npos) return Sign{"**", kNgcName, kNgcTitle};
    return std::nullopt;
}

std::optional<Sign> ab9_sign(std::string_view line) {
    if (has_numbered(line, "GOTO")) return Sign{"GOTO", kAb9Name, kAb9Title};
    if (behind_o(line).empty()) {
        if (line.find("WHILE[") != std::string_view::npos) return Sign{"WHILE", kAb9Name, kAb9Title};
        if (line.find("IF[") != std::string_view::npos) return Sign{"IF", kAb9Name, kAb9Title};
    }
    for (const std::string_view code : {"G65P", "G66P"}) {
        if (line.find(code) != std::string_view::npos)
            return Sign{code.substr(0, code.size() - 1), kAb9Name, kAb9Title};
    }
    for (const std::string_view corner : {",C", ",R", ",A"}) {
        if (has_numbered(line, corner)) return Sign{corner, kAb9Name, kAb9Title};
    }
    if (has_numbered(line, "M98P")) return Sign{"M98 P", kAb9Name, kAb9Title, false};
    // A program's number, by itself.
    if (line.size() > 1 && line.front() == 'O' && behind_o(line).empty() && text::is_digit(line[1]))
        return Sign{"O with a program's number", kAb9Name, kAb9Title, false};
    return std::nullopt;
}

// Returns a feature of a language that is no G-code.
std::optional<Sign> foreign_sign(std::string_view line) {
    if (line.find("BEGIN PGM") != std::string_view::npos)
        return Sign{"BEGIN PGM", "", "Heidenhain's own language"};
    for (const std::string_view word : {"DEF REAL", "DEF INT", "MSG(\"", "MCALL ", "CYCLE800", "CYCLE832"}) {
        if (line.find(word) != std::string_view::npos) return Sign{word, "", "the language of Sinumerik"};
    }
    return std::nullopt;
}

text::Diagnostic note_of(const lexer::Source& source, std::uint32_t line, const Sign& sign) {
    return {.severity = text::Severity::note,
            .kind = text::DiagnosticKind::dialect,
            .file = source.name(),
            .line = line,
            .text = fmt::format("{} is of {}", sign.text, sign.language),
            .hint = sign.dialect.empty() ? std::string("gsim does not read it")
                                         : fmt::format("try --dialect {}", sign.dialect)};
}

/// Statistics of the numbers of a program.
struct Numbers {
    int coordinates = 0;
    int fine = 0;    // coordinates with three or four decimals
    int finest = 0;  // with four
    int finer = 0;   // with more
    double extent = 0;
    double greatest_feed = 0;
    bool has_unit = false;

    void take(const PlainWord& word);
    bool look_like_inches() const;
};

void Numbers::take(const PlainWord& word) {
    constexpr double kInchCode = 20;
    constexpr double kMetricCode = 21;
    constexpr int kFine = 3;
    constexpr int kFinest = 4;
    if (word.letter == 'G') has_unit = has_unit || word.value == kInchCode || word.value == kMetricCode;
    if (word.letter == 'F') greatest_feed = std::max(greatest_feed, word.value);
    if (word.letter < 'X' || word.letter > 'Z') return;
    ++coordinates;
    extent = std::max(extent, std::abs(word.value));
    if (word.decimals == kFine || word.decimals == kFinest) ++fine;
    if (word.decimals == kFinest) ++finest;
    if (word.decimals > kFinest) ++finer;
}

bool Numbers::look_like_inches() const {
    constexpr double kFastest = 100;  // in/min; few mills cut so slowly in mm/min
    constexpr double kSmallPart = 10;
    constexpr double kPart = 40;
    constexpr int kFew = 3;
    constexpr int kShare = 4;
    if (has_unit || finer > 0 || greatest_feed <= 0 || greatest_feed > kFastest) return false;
    return (extent <= kSmallPart && fine >= kFew) ||
           (extent <= kPart && finest >= kFew && finest * kShare >= coordinates);
}

}  // namespace

std::optional<text::Diagnostic> find_dialect_hint(lexer::Source& source, const grammar::Dialect& read_as) {
    if (read_as.rules().style == lexer::Style::command_lines) return std::nullopt;
    const bool as_ngc = read_as.name() == kNgcName;
    std::optional<text::Diagnostic> unsure;
    bool has_own = false;
    PlainLines lines(source);
    while (lines.next()) {
        const std::string_view line = trimmed(lines.text());
        const std::string packed = blanks_removed(line);
        std::optional<Sign> sign = foreign_sign(line);
        if (!sign) sign = as_ngc ? ab9_sign(packed) : ngc_sign(packed);
        if (sign && sign->sure) return note_of(source, lines.number(), *sign);
        const std::optional<Sign> own = as_ngc ? ngc_sign(packed) : ab9_sign(packed);
        has_own = has_own || (own && own->sure);
        if (sign && !unsure) unsure = note_of(source, lines.number(), *sign);
    }
    return has_own ? std::nullopt : unsure;
}

std::optional<text::Diagnostic> find_inch_signs(lexer::Source& source) {
    Numbers numbers;
    PlainLines lines(source);
    while (!numbers.has_unit && lines.next()) {
        PlainWords words(lines.text());
        while (words.next()) numbers.take(words.word());
    }
    if (!numbers.look_like_inches()) return std::nullopt;
    return text::Diagnostic{
        .severity = text::Severity::warning,
        .kind = text::DiagnosticKind::units,
        .file = source.name(),
        .text =
            fmt::format("the program says neither G20 nor G21 and is read in mm, but looks like inches: its "
                        "coordinates are within {:.6g}, with up to {} decimals, its feeds within {:.6g}",
                        numbers.extent, numbers.finest > 0 ? 4 : 3, numbers.greatest_feed),
        .hint = "say G20 or G21, or units = \"inch\" or \"mm\" under [program] in the machine file"};
}

}  // namespace gsim::codegen
