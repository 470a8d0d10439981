#include "codegen/lua/command_writer.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/letter_case.h"
#include "base/text/number.h"
#include "base/text/read_number.h"
#include "base/text/trimmed.h"
#include "codegen/lua/lua_text.h"

namespace gsim::codegen {

using grammar::Code;
using grammar::ExtendedCommand;
using lexer::DiagnosticKind;

namespace {

constexpr std::size_t kRemarkColumn = 56;
constexpr std::size_t kMaxNameLength = 40;  // of what is no command, in a message

bool accepts_key(const Code& code, std::string_view key) {
    if (key.size() != 1) return false;
    const bool is_axis = key == "X" || key == "Y" || key == "Z";
    return (is_axis && code.axes != grammar::AxisUse::none) ||
           code.words.find(key[0]) != std::string_view::npos;
}

bool has_word(std::string_view words, std::string_view word) {
    return fmt::format(" {} ", words).find(fmt::format(" {} ", word)) != std::string::npos;
}

/// Returns a number of the text in Lua's form: Lua has no sign '+'.
std::string_view strip_plus(std::string_view number) {
    return number.substr(!number.empty() && number.front() == '+' ? 1 : 0);
}

}  // namespace

CommandWriter::CommandWriter(const grammar::Dialect& dialect, lexer::Diagnostics& diagnostics,
                             LuaSpool& spool, bool annotate)
    : dialect_(dialect), diagnostics_(diagnostics), spool_(spool), annotate_(annotate) {
    for (const Code& code : dialect.codes()) codes_.emplace(grammar::code_name(code), &code);
}

void CommandWriter::write(lexer::Source& source, std::string_view source_name) {
    begin_file(source_name);
    SourceLines lines(source);
    while (!diagnostics_.full() && lines.next()) write_line(lines);
    if (diagnostics_.full()) return;
    parts_.end(code_);
    end_line();
    warn_of_ignored();
}

void CommandWriter::begin_file(std::string_view source_name) {
    std::string head = fmt::format("local _ENV = require \"{}\" ", dialect_.rules().lua_module);
    parts_.begin_program("nil", head);
    head += fmt::format("-- from {}; line n there is line n+1 here", lexer::printable(source_name));
    spool_.write_head(head);
    parts_.end_line(spool_.size(), false, true);
}

void CommandWriter::write_line(const SourceLines& lines) {
    line_ = lines.at(1).line;
    if (lines.too_long()) {
        diagnostics_.error(lines.at(1), DiagnosticKind::too_large,
                           fmt::format("the line has more than {} bytes", lexer::kMaxLineBytes));
        return;
    }
    const CommandLine line = command_line(lines.text());
    const bool has_effect = line.command.empty() || write_command(lines, line);
    if (annotate_ || !has_effect) {
        comment_ = lexer::printable(text::trimmed(lines.text(), kLineBlanks));
    } else if (!line.remark.empty()) {
        comment_ = fmt::format("({})", lexer::printable(line.remark));
    }
    end_line();
}

/// Returns true if the line has an effect.
bool CommandWriter::write_command(const SourceLines& lines, const CommandLine& line) {
    const auto code = codes_.find(line.command);
    if (code != codes_.end() && code->second->support == grammar::Support::full) {
        write_code(lines, line, *code->second);
        return true;
    }
    const auto extended = dialect_.rules().extended;
    const auto command = std::find_if(extended.begin(), extended.end(),
                                      [&](const ExtendedCommand& one) { return one.name == line.command; });
    if (command != extended.end()) {
        write_extended(lines, line, *command);
        return true;
    }
    const std::string name = lexer::printable(std::string_view(line.command).substr(0, kMaxNameLength));
    record_ignored(
        code != codes_.end()
            ? fmt::format("{} ({}) is not simulated: no effect", name, code->second->meaning)
            : fmt::format("{} is not a motion or dwell command of {}: no effect", name, dialect_.title()),
        lines.at(line.column));
    return false;
}

void CommandWriter::write_code(const SourceLines& lines, const CommandLine& line, const Code& code) {
    const std::string name = grammar::code_name(code);
    std::vector<Parameter> read;
    for (const Parameter& parameter : line.parameters) {
        const auto same = std::find_if(read.begin(), read.end(),
                                       [&](const Parameter& one) { return one.key == parameter.key; });
        if (!accepts_key(code, parameter.key)) {
            const bool is_command = parameter.key == "G" || parameter.key == "M";
            record_ignored(is_command
                               ? fmt::format("{} reads one command per line: {}{} after {} has no effect",
                                             dialect_.title(), parameter.key, parameter.value, name)
                               : fmt::format("{} does not read {} of {}: no effect", dialect_.title(),
                                             parameter.key, name),
                           lines.at(parameter.column));
        } else if (same == read.end()) {
            read.push_back(parameter);
        } else {
            record_ignored(
                fmt::format("{} is given twice after {}: the last one is used", parameter.key, name),
                lines.at(parameter.column));
            *same = parameter;
        }
    }
    write_call(lines, grammar::lua_name(code), read, "");
}

void CommandWriter::write_extended(const SourceLines& lines, const CommandLine& line,
                                   const ExtendedCommand& command) {
    std::vector<Parameter> given;
    if (!named_parameters(line, given)) {
        diagnostics_.error(lines.at(line.column), DiagnosticKind::syntax,
                           fmt::format("{} requires its parameters as NAME=VALUE", command.name));
        return;
    }
    std::vector<Parameter> read;
    for (const Parameter& parameter : given) {
        if (has_word(command.parameters, parameter.key) || has_word(command.texts, parameter.key)) {
            read.push_back(parameter);
        } else {
            record_ignored(fmt::format("{} does not read {} of {}: no effect", dialect_.title(),
                                       lexer::printable(parameter.key), command.name),
                           lines.at(parameter.column));
        }
    }
    write_call(lines, command.name, read, command.texts);
}

void CommandWriter::write_call(const SourceLines& lines, std::string_view name,
                               const std::vector<Parameter>& parameters, std::string_view texts) {
    code_ += name;
    if (parameters.empty()) {
        code_ += "()";
        return;
    }
    std::string_view between = "{";
    for (const auto& [key, value, column] : parameters) {
        text::append_format(code_, "{}{}=", between, text::lower(key));
        between = ", ";
        if (has_word(texts, key)) {
            write_lua_string(value, code_);
        } else if (text::parse_number(value)) {
            code_ += strip_plus(value);
        } else {
            diagnostics_.error(lines.at(column), DiagnosticKind::number,
                               fmt::format("'{}' after {} is not a number, which ends the program",
                                           lexer::printable(value), key));
        }
    }
    code_ += '}';
}

void CommandWriter::record_ignored(std::string message, const lexer::Location& at) {
    IgnoredText& ignored = ignored_.try_emplace(std::move(message), IgnoredText{at, 0}).first->second;
    ++ignored.count;
}

/// Warns in the order of the source.
void CommandWriter::warn_of_ignored() {
    std::vector<std::pair<std::string, IgnoredText>> all(ignored_.begin(), ignored_.end());
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return a.second.first.line < b.second.first.line; });
    for (const auto& [message, ignored] : all) {
        diagnostics_.warning(ignored.first, DiagnosticKind::code_idle,
                             fmt::format("{} ({} in total)", message, ignored.count));
    }
}

void CommandWriter::end_line() {
    while (!code_.empty() && code_.back() == ' ') code_.pop_back();
    if (!comment_.empty()) {
        code_.append(code_.size() < kRemarkColumn ? kRemarkColumn - code_.size() : 1, ' ');
        code_ += "-- ";
        code_ += comment_;
        comment_.clear();
    }
    code_ += '\n';
    spool_.write(code_);
    parts_.end_line(code_.size(), true, true);
    code_.clear();
}

}  // namespace gsim::codegen
