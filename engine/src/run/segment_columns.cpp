#include "engine/src/run/segment_columns.h"

#include <utility>

#include "motion/planner/planner_setup.h"
#include "runtime/monitors/workpiece_tcp.h"
#include "runtime/outputs/tcp_curve.h"
#include "runtime/simulator/make_planner_setup.h"

namespace gsim::engine {

namespace {

using Eigen::Vector3d;

/// Tolerance of the drawn path, in mm.
constexpr double kDrawTolerance_mm = 0.01;
/// Number of vertices at which a chunk is delivered: a helix may have any number of them.
constexpr std::size_t kMaxVertices = std::size_t{1} << 18U;

void append(std::vector<double>& values, const Vector3d& vector) {
    values.insert(values.end(), vector.data(), vector.data() + 3);
}

void append(std::vector<double>& values, const motion::TimeLaw& law) {
    values.insert(values.end(), {law.length(), law.duration_s(), law.end_speed(),
                                 static_cast<double>(law.sections().size())});
    for (const motion::LawSection& section : law.sections())
        values.insert(values.end(), {section.duration_s, section.s0, section.v0, section.a0, section.jerk});
}

void append(std::vector<double>& values, const motion::Arc& arc, const std::array<int, 3>& joints) {
    for (const int joint : joints) values.push_back(joint);
    append(values, arc.center);
    append(values, arc.u);
    append(values, arc.v);
    values.insert(values.end(), {arc.radius_mm, arc.end_radius_mm, arc.sweep_rad});
    append(values, arc.lift);
}

void append(std::vector<double>& values, const motion::OrientationArc& orientation_arc) {
    values.insert(values.end(), {static_cast<double>(orientation_arc.turn_joint()),
                                 static_cast<double>(orientation_arc.tilt_joint())});
    const auto constants = orientation_arc.constants();
    values.insert(values.end(), constants.begin(), constants.end());
}

// Each number fits into its bits of SegmentColumns::flags.
#define GSIM_SEGMENT_KIND(name, number, constant) static_assert((number) <= SegmentFlags::kKindMask);
#include "base/kinds/segment_kind.def"
#define GSIM_MOVE_KIND(name, number, constant) static_assert((number) < 16);
#include "base/kinds/move_kind.def"
#define GSIM_LIMIT_KIND(name, number, words) static_assert((number) < 16);
#include "base/kinds/limit_kind.def"
static_assert(rrs::kMaxJoints < 32);

std::uint32_t form_flags(const motion::Segment& segment) {
    std::uint32_t flags = static_cast<std::uint32_t>(segment.kind);
    if (segment.kind == motion::SegmentKind::circular) flags |= SegmentFlags::kArc;
    if (segment.orientation) flags |= SegmentFlags::kOrientation;
    if (segment.superimposed) flags |= SegmentFlags::kBeside;
    if (segment.is_uncoordinated()) flags |= SegmentFlags::kApart;
    return flags;
}

std::uint32_t segment_flags(const motion::Segment& segment, const simulation::MoveInfo& info) {
    std::uint32_t flags = form_flags(segment);
    if (info.process_on) flags |= SegmentFlags::kProcessOn;
    if (info.timed) flags |= SegmentFlags::kTimed;
    flags |= static_cast<std::uint32_t>(info.kind) << SegmentFlags::kMoveKindShift;
    flags |= static_cast<std::uint32_t>(segment.limited_by.kind) << SegmentFlags::kLimitShift;
    flags |= static_cast<std::uint32_t>(segment.limited_by.joint + 1) << SegmentFlags::kLimitAxisShift;
    return flags;
}

void append_record(std::vector<double>& values, const motion::Segment& segment) {
    values.insert(values.end(), segment.start.data(), segment.start.data() + segment.start.size());
    values.insert(values.end(), segment.end.data(), segment.end.data() + segment.end.size());
    append(values, segment.master);
    if (segment.kind == motion::SegmentKind::circular) append(values, segment.arc, segment.position_joints);
    if (segment.orientation) append(values, *segment.orientation);
    values.push_back(static_cast<double>(segment.followers().size()));
    for (const motion::Follower& follower : segment.followers()) {
        values.insert(values.end(), {static_cast<double>(follower.joint), follower.sign});
        append(values, follower.law);
    }
    if (segment.is_uncoordinated()) values.push_back(segment.uncoordinated & ~motion::kApart);
    if (!segment.superimposed) return;
    values.insert(values.end(),
                  {static_cast<double>(form_flags(*segment.superimposed)), segment.superimposed->duration_s});
    append_record(values, *segment.superimposed);
}

class ColumnsOutput final : public simulation::RunOutput {
  public:
    ColumnsOutput(ColumnsHandler on_segment, const machine::Machine& machine,
                  const std::vector<Vector3d>& tcp_offsets_mm)
        : handler_(std::move(on_segment)),
          setup_(simulation::make_planner_setup(machine)),
          tcp_offsets_mm_(tcp_offsets_mm),
          tcp_(setup_, tcp_offsets_mm.front()) {}

    void begin(const rrs::JointPos& start) override { add_vertex(tcp_.at(start), 0); }
    void on_segment(const motion::Segment& segment, const simulation::MoveInfo& info) override {
        if (info.tcp != tcp_index_) {
            change_tcp(info.tcp);
            add_vertex(tcp_.at(segment.start), segment.start_s);
        }
        add_row(segment, info);
        append_record(columns_.values, segment);
        if (segment.kind != motion::SegmentKind::rest) draw(segment);
        ++segments_in_chunk_;
        if (segments_in_chunk_ == kColumnChunk || columns_.vertex_s.size() > kMaxVertices) deliver();
    }
    void end(double) override { deliver(); }

  private:
    void change_tcp(std::uint16_t number) {
        tcp_index_ = number;
        tcp_ = simulation::WorkpieceTcp(setup_, tcp_offsets_mm_[number]);
    }

    void add_row(const motion::Segment& segment, const simulation::MoveInfo& info) {
        const bool has_feed = info.kind != simulation::MoveKind::rapid &&
                              info.kind != simulation::MoveKind::dwell && !info.timed;
        columns_.start_s.push_back(segment.start_s);
        columns_.duration_s.push_back(segment.duration_s);
        columns_.length_mm.push_back(segment.length_mm);
        columns_.feed_per_min.push_back(has_feed ? info.feed_per_min : 0);
        columns_.deviation_mm.push_back(segment.deviation_mm);
        columns_.line.push_back(info.location.line);
        columns_.file.push_back(info.location.file);
        columns_.flags.push_back(segment_flags(segment, info));
        columns_.tcp.push_back(info.tcp);
        columns_.record.push_back(static_cast<std::uint32_t>(columns_.values.size()));
    }

    void draw(const motion::Segment& segment) {
        tcp_.set_position(segment.start);
        simulation::add_tcp_path(
            segment, tcp_, kDrawTolerance_mm,
            [&](const Vector3d& point_mm, double t_s) { add_vertex(point_mm, segment.start_s + t_s); },
            [] { return true; });
    }

    void add_vertex(const Vector3d& point_mm, double time_s) {
        for (const double value : point_mm) columns_.vertex_mm.push_back(static_cast<float>(value));
        columns_.vertex_s.push_back(static_cast<float>(time_s));
        columns_.vertex_segment.push_back(segments_in_chunk_);
    }

    void deliver() {
        handler_(columns_);
        const std::uint64_t next = columns_.first + segments_in_chunk_;
        columns_ = {};
        columns_.first = next;
        segments_in_chunk_ = 0;
    }

    ColumnsHandler handler_;
    motion::PlannerSetup setup_;
    const std::vector<Vector3d>& tcp_offsets_mm_;
    simulation::WorkpieceTcp tcp_;
    std::uint16_t tcp_index_ = 0;
    SegmentColumns columns_;
    std::uint32_t segments_in_chunk_ = 0;
};

}  // namespace

std::unique_ptr<simulation::RunOutput> make_columns_output(ColumnsHandler on_segment,
                                                           const machine::Machine& machine,
                                                           const std::vector<Vector3d>& tcp_offsets_mm) {
    return std::make_unique<ColumnsOutput>(std::move(on_segment), machine, tcp_offsets_mm);
}

}  // namespace gsim::engine
