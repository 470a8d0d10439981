#include "codegen/blocks/program_hints.h"

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
struct DialectFeature {
    std::string_view text;      // as in the program
    std::string_view dialect;   // suggested one; empty: no dialect of ours reads it
    std::string_view language;  // as people call it
    bool is_exclusive = true;   // the other dialect has no such thing at all
};

constexpr std::string_view kNgcName = "rs274ngc";
constexpr std::string_view kAb9Name = "ab9";
constexpr std::string_view kNgcTitle = "RS274/NGC (LinuxCNC)";
constexpr std::string_view kAb9Title = "the 9/Series (and related controllers, such as Fanuc and Haas)";

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::string without_blanks(std::string_view text) {
    std::string out;
    std::copy_if(text.begin(), text.end(), std::back_inserter(out),
                 [](char c) { return c != ' ' && c != '\t' && c != '\r'; });
    return out;
}

// Returns the text that follows the name or number of an O-word; empty if a line has no O-word.
std::string_view text_after_o(std::string_view line) {
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

// Returns true if the line contains `text` followed by a digit or '#'.
bool has_numbered(std::string_view line, std::string_view text) {
    for (std::size_t at = line.find(text); at != std::string_view::npos; at = line.find(text, at + 1)) {
        const std::size_t after = at + text.size();
        if (after < line.size() && (text::is_digit(line[after]) || line[after] == '#')) return true;
    }
    return false;
}

// Returns the feature of RS274/NGC in a line without blanks.
std::optional<DialectFeature> ngc_feature(std::string_view line) {
    if (line.find("#<") != std::string_view::npos) return DialectFeature{"#<name>", kNgcName, kNgcTitle};
    const std::string_view flow = text_after_o(line);
    for (const std::string_view word : kOWords) {
        if (flow.starts_with(word)) return DialectFeature{"an O-word", kNgcName, kNgcTitle};
    }
    if (line.find("EXISTS[") != std::string_view::npos) return DialectFeature{"EXISTS", kNgcName, kNgcTitle};
    if (line.find("**") != std::string_view::npos) return DialectFeature{"**", kNgcName, kNgcTitle};
    return std::nullopt;
}

std::optional<DialectFeature> ab9_feature(std::string_view line) {
    if (has_numbered(line, "GOTO")) return DialectFeature{"GOTO", kAb9Name, kAb9Title};
    if (text_after_o(line).empty()) {
        if (line.find("WHILE[") != std::string_view::npos)
            return DialectFeature{"WHILE", kAb9Name, kAb9Title};
        if (line.find("IF[") != std::string_view::npos) return DialectFeature{"IF", kAb9Name, kAb9Title};
    }
    for (const std::string_view code : {"G65P", "G66P"}) {
        if (line.find(code) != std::string_view::npos)
            return DialectFeature{code.substr(0, code.size() - 1), kAb9Name, kAb9Title};
    }
    for (const std::string_view corner : {",C", ",R", ",A"}) {
        if (has_numbered(line, corner)) return DialectFeature{corner, kAb9Name, kAb9Title};
    }
    if (has_numbered(line, "M98P")) return DialectFeature{"M98 P", kAb9Name, kAb9Title, false};
    // A program's number, by itself.
    if (line.size() > 1 && line.front() == 'O' && text_after_o(line).empty() && text::is_digit(line[1]))
        return DialectFeature{"O with a program number", kAb9Name, kAb9Title, false};
    return std::nullopt;
}

// Returns a feature of a language that is no G-code.
std::optional<DialectFeature> foreign_feature(std::string_view line) {
    if (line.find("BEGIN PGM") != std::string_view::npos)
        return DialectFeature{"BEGIN PGM", "", "the language of Heidenhain"};
    for (const std::string_view word : {"DEF REAL", "DEF INT", "MSG(\"", "MCALL ", "CYCLE800", "CYCLE832"}) {
        if (line.find(word) != std::string_view::npos)
            return DialectFeature{word, "", "the language of Sinumerik"};
    }
    return std::nullopt;
}

text::Diagnostic make_note(const lexer::Source& source, std::uint32_t line, const DialectFeature& feature) {
    return {.severity = text::Severity::note,
            .kind = text::DiagnosticKind::dialect,
            .file = source.name(),
            .line = line,
            .text = fmt::format("{} belongs to {}", feature.text, feature.language),
            .hint = feature.dialect.empty() ? std::string("gsim does not support it")
                                            : fmt::format("try --dialect {}", feature.dialect)};
}

/// Statistics of the numbers of a program.
struct NumberStatistics {
    int coordinates = 0;
    int fine = 0;                 // coordinates with three or four decimals
    int four_decimals_count = 0;  // with four
    int more_decimals_count = 0;  // with more
    double extent = 0;
    double max_feed = 0;
    bool has_unit = false;

    void add_word(const PlainWord& word);
    bool looks_like_inches() const;
};

void NumberStatistics::add_word(const PlainWord& word) {
    constexpr double kInchCode = 20;
    constexpr double kMetricCode = 21;
    constexpr int kCoarseDecimals = 3;
    constexpr int kFineDecimals = 4;
    if (word.letter == 'G') has_unit = has_unit || word.value == kInchCode || word.value == kMetricCode;
    if (word.letter == 'F') max_feed = std::max(max_feed, word.value);
    if (word.letter < 'X' || word.letter > 'Z') return;
    ++coordinates;
    extent = std::max(extent, std::abs(word.value));
    if (word.decimals == kCoarseDecimals || word.decimals == kFineDecimals) ++fine;
    if (word.decimals == kFineDecimals) ++four_decimals_count;
    if (word.decimals > kFineDecimals) ++more_decimals_count;
}

bool NumberStatistics::looks_like_inches() const {
    constexpr double kMaxInchFeed = 100;  // in/min; few mills cut so slowly in mm/min
    constexpr double kSmallExtent = 10;
    constexpr double kMediumExtent = 40;
    constexpr int kMinFineCount = 3;
    constexpr int kFineFraction = 4;
    if (has_unit || more_decimals_count > 0 || max_feed <= 0 || max_feed > kMaxInchFeed) return false;
    return (extent <= kSmallExtent && fine >= kMinFineCount) ||
           (extent <= kMediumExtent && four_decimals_count >= kMinFineCount &&
            four_decimals_count * kFineFraction >= coordinates);
}

}  // namespace

std::optional<text::Diagnostic> find_dialect_hint(lexer::Source& source,
                                                  const grammar::Dialect& current_dialect) {
    if (current_dialect.text().form == lexer::TextForm::command_lines) return std::nullopt;
    const bool has_o_words = current_dialect.text().has_o_words;
    std::optional<text::Diagnostic> uncertain_note;
    bool has_native_feature = false;
    PlainLines lines(source);
    while (lines.next()) {
        const std::string_view line = trimmed(lines.text());
        const std::string compacted = without_blanks(line);
        std::optional<DialectFeature> feature = foreign_feature(line);
        if (!feature) feature = has_o_words ? ab9_feature(compacted) : ngc_feature(compacted);
        if (feature && feature->is_exclusive) return make_note(source, lines.number(), *feature);
        const std::optional<DialectFeature> detected =
            has_o_words ? ngc_feature(compacted) : ab9_feature(compacted);
        has_native_feature = has_native_feature || (detected && detected->is_exclusive);
        if (feature && !uncertain_note) uncertain_note = make_note(source, lines.number(), *feature);
    }
    return has_native_feature ? std::nullopt : uncertain_note;
}

std::optional<text::Diagnostic> find_inch_hint(lexer::Source& source) {
    NumberStatistics numbers;
    PlainLines lines(source);
    while (!numbers.has_unit && lines.next()) {
        PlainWords words(lines.text());
        while (words.next()) numbers.add_word(words.word());
    }
    if (!numbers.looks_like_inches()) return std::nullopt;
    return text::Diagnostic{
        .severity = text::Severity::warning,
        .kind = text::DiagnosticKind::units,
        .file = source.name(),
        .text =
            fmt::format("the program has neither G20 nor G21 and is read in mm, but seems to be in inches: "
                        "its coordinates are within {:.6g}, with up to {} decimals, its feeds within {:.6g}",
                        numbers.extent, numbers.four_decimals_count > 0 ? 4 : 3, numbers.max_feed),
        .hint = "add G20 or G21, or set units = \"inch\" or \"mm\" under [program] in the machine file"};
}

}  // namespace gsim::codegen
