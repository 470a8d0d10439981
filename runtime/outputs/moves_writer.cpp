#include "runtime/outputs/moves_writer.h"

#include <iterator>

#include "base/text/format.h"
#include "base/text/json_text.h"
#include "runtime/report/limit_name.h"

namespace gsim::simulation {

namespace {

using text::append_json_string;
using text::append_number;
using text::append_text;

void append_key(fmt::memory_buffer& out, char letter) {
    out.push_back('"');
    out.push_back(letter);
    append_text(out, "\":");
}

bool is_arc(MoveKind kind) {
    return kind == MoveKind::arc_cw || kind == MoveKind::arc_ccw;
}

}  // namespace

MovesWriter::MovesWriter(TextStream& out, const machine::Machine& machine,
                         const std::vector<std::string>& files)
    : out_(out), machine_(machine), files_(files) {}

void MovesWriter::on_move(const RecordedMove& move) {
    fmt::memory_buffer& out = out_.buffer();
    const MoveInfo& info = move.info;
    text::append_format(out, R"({{"n":{},"file":{},"line":{},"kind":"{}","to":{{)", move.n,
                        file_text(info.location.file), info.location.line, name(info.kind));
    append_target(move.end);
    append_text(out, "}");
    if (is_arc(info.kind)) append_arc(move);
    append_text(out, R"(,"feed":)");
    if (info.kind == MoveKind::rapid || info.kind == MoveKind::dwell) {
        append_text(out, "null");
    } else {
        append_number(out, info.feed_per_min);
    }
    append_text(out, R"(,"start_s":)");
    append_number(out, move.start_s);
    append_text(out, R"(,"end_s":)");
    append_number(out, move.end_s);
    append_limit(move);
    if (move.deviation_mm > 0) {
        append_text(out, R"(,"deviation_mm":)");
        append_number(out, move.deviation_mm);
    }
    if (info.out_of_range != 0) append_axes_out_of_range(info.out_of_range);
    append_text(out, "}");
    out_.end_line();
}

void MovesWriter::append_target(const rrs::JointPos& joints) {
    fmt::memory_buffer& out = out_.buffer();
    for (std::size_t i = 0; i < machine_.axes.size(); ++i) {
        const machine::Axis& axis = machine_.axes[i];
        if (i > 0) out.push_back(',');
        append_key(out, axis.letter);
        append_number(out, axis_value(axis, joints[static_cast<Eigen::Index>(i)]));
    }
}

void MovesWriter::append_arc(const RecordedMove& move) {
    fmt::memory_buffer& out = out_.buffer();
    append_text(out, R"(,"center":)");
    if (move.arc) {
        append_center(move);
    } else {
        append_text(out, "null");
    }
    append_text(out, R"(,"normal":{)");
    append_normal(move.info.normal);
    append_text(out, R"(},"plane":)");
    if (const auto plane = main_plane(move.info.normal)) {
        text::append_format(out, R"("{}")", name(*plane));
    } else {
        append_text(out, "null");
    }
    text::append_format(out, R"(,"turns":{})", move.info.turns);
}

void MovesWriter::append_normal(const Eigen::Vector3d& normal) {
    fmt::memory_buffer& out = out_.buffer();
    for (Eigen::Index i = 0; i < 3; ++i) {
        if (i > 0) out.push_back(',');
        append_key(out, static_cast<char>('X' + i));
        append_number(out, normal[i]);
    }
}

void MovesWriter::append_center(const RecordedMove& move) {
    fmt::memory_buffer& out = out_.buffer();
    char separator = '{';
    for (std::size_t i = 0; i < move.position_joints.size(); ++i) {
        const int joint = move.position_joints[i];
        if (joint < 0 || static_cast<std::size_t>(joint) >= machine_.axes.size()) continue;
        const machine::Axis& axis = machine_.axes[static_cast<std::size_t>(joint)];
        out.push_back(separator);
        separator = ',';
        append_key(out, axis.letter);
        append_number(out, axis_value(axis, move.arc->center[static_cast<Eigen::Index>(i)]));
    }
    append_text(out, separator == '{' ? "{}" : "}");
}

void MovesWriter::append_limit(const RecordedMove& move) {
    fmt::memory_buffer& out = out_.buffer();
    append_text(out, R"(,"limited_by":)");
    if (!move.limited_by) return append_text(out, "null");
    out.push_back('"');
    append_text(out, describe(*move.limited_by, machine_));
    out.push_back('"');
}

void MovesWriter::append_axes_out_of_range(std::uint16_t joints) {
    fmt::memory_buffer& out = out_.buffer();
    append_text(out, R"(,"beyond":[)");
    bool first = true;
    for (std::size_t joint = 0; joint < machine_.axes.size(); ++joint) {
        if ((joints >> joint & 1U) == 0) continue;
        text::append_format(out, R"({}"{}")", first ? "" : ",", machine_.axes[joint].letter);
        first = false;
    }
    out.push_back(']');
}

const std::string& MovesWriter::file_text(std::size_t file) {
    static const std::string unknown = "null";
    while (file_texts_.size() <= file && file_texts_.size() < files_.size()) {
        fmt::memory_buffer text;
        append_json_string(text, files_[file_texts_.size()]);
        file_texts_.push_back(fmt::to_string(text));
    }
    return file < file_texts_.size() ? file_texts_[file] : unknown;
}

}  // namespace gsim::simulation
