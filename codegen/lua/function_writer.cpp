#include "codegen/lua/function_writer.h"

#include <utility>

#include <fmt/format.h>

namespace gsim::codegen {

namespace {

constexpr std::uint32_t kLinesBetweenCuts = 5000;
constexpr std::uint32_t kMinLinesBetweenCuts = 256;  // so that the map stays small

}  // namespace

void FunctionWriter::begin(std::string head, std::string& line) {
    if (!line.empty() && line.back() != ' ') line += ' ';
    line += head;
    line += "function()";
    ProgramPart part;
    part.head = std::move(head);
    part.body_begin = written_bytes_ + line.size();
    part.first_line = line_number_;
    map_.push_back(std::move(part));
    line += ' ';
    last_cut_line_ = line_number_;
    open_ = true;
}

void FunctionWriter::begin_program(std::string_view name, std::string& line) {
    begin(fmt::format("program({}, ", name), line);
    program_begun_ = true;
}

void FunctionWriter::begin_sub(std::string_view name, std::string& line) {
    begin(fmt::format("sub({}, ", name), line);
}

void FunctionWriter::begin_remainder(std::string& line) {
    if (!program_begun_) return begin_program("nil", line);
    begin("more(", line);
}

void FunctionWriter::end(std::string& line) {
    map_.back().body_end = written_bytes_ + line.size();
    if (!line.empty() && line.back() != ' ') line += ' ';
    line += "end) ";
    open_ = false;
}

void FunctionWriter::end_line(std::uint64_t bytes, bool may_cut, bool plain) {
    written_bytes_ += bytes;
    ++line_number_;
    if (!open_ || !may_cut ||
        line_number_ - last_cut_line_ < (plain ? kLinesBetweenCuts : kMinLinesBetweenCuts))
        return;
    map_.back().cuts.push_back({written_bytes_, line_number_});
    last_cut_line_ = line_number_;
}

}  // namespace gsim::codegen
