#include "engine/src/run/segment_columns.h"

#include <utility>

#include "motion/planner/planner_setup.h"
#include "runtime/monitors/part_tip.h"
#include "runtime/outputs/tip_curve.h"
#include "runtime/simulator/setup_of_machine.h"

namespace gsim::engine {

namespace {

using Eigen::Vector3d;

/// Tolerance of the drawn path, in mm.
constexpr double kDrawn_mm = 0.01;
/// Number of vertices at which a chunk is delivered: a helix may have any number of them.
constexpr std::size_t kMostVertices = std::size_t{1} << 18U;

void put(std::vector<double>& values, const Vector3d& vector) {
    values.insert(values.end(), vector.data(), vector.data() + 3);
}

void put(std::vector<double>& values, const motion::TimeLaw& law) {
    values.insert(values.end(), {law.length(), law.duration_s(), law.end_speed(),
                                 static_cast<double>(law.pieces().size())});
    for (const motion::LawPiece& piece : law.pieces())
        values.insert(values.end(), {piece.duration_s, piece.s0, piece.v0, piece.a0, piece.jerk});
}

void put(std::vector<double>& values, const motion::Arc& arc, const std::array<int, 3>& joints) {
    for (const int joint : joints) values.push_back(joint);
    put(values, arc.center);
    put(values, arc.u);
    put(values, arc.v);
    values.insert(values.end(), {arc.radius_mm, arc.end_radius_mm, arc.sweep_rad});
    put(values, arc.lift);
}

void put(std::vector<double>& values, const motion::OrientationArc& way) {
    values.insert(values.end(),
                  {static_cast<double>(way.turn_joint()), static_cast<double>(way.tilt_joint())});
    const auto constants = way.constants();
    values.insert(values.end(), constants.begin(), constants.end());
}

// Each number fits into its bits of SegmentColumns::flags.
#define GSIM_SEGMENT_KIND(name, number, constant) static_assert((number) <= SegmentFlags::kKind);
#include "base/kinds/segment_kind.def"
#define GSIM_MOVE_KIND(name, number, constant) static_assert((number) < 16);
#include "base/kinds/move_kind.def"
#define GSIM_LIMIT_KIND(name, number, words) static_assert((number) < 16);
#include "base/kinds/limit_kind.def"
static_assert(rrs::kMaxJoints < 32);

std::uint32_t forms_of(const motion::Segment& segment) {
    std::uint32_t flags = static_cast<std::uint32_t>(segment.kind);
    if (segment.kind == motion::SegmentKind::circular) flags |= SegmentFlags::kArc;
    if (segment.orientation) flags |= SegmentFlags::kOrientation;
    if (segment.beside) flags |= SegmentFlags::kBeside;
    if (segment.joints_go_apart()) flags |= SegmentFlags::kApart;
    return flags;
}

std::uint32_t flags_of(const motion::Segment& segment, const simulation::MoveInfo& info) {
    std::uint32_t flags = forms_of(segment);
    if (info.jet_on) flags |= SegmentFlags::kProcessOn;
    if (info.timed) flags |= SegmentFlags::kTimed;
    flags |= static_cast<std::uint32_t>(info.kind) << SegmentFlags::kMoveKindShift;
    flags |= static_cast<std::uint32_t>(segment.limited_by.kind) << SegmentFlags::kLimitShift;
    flags |= static_cast<std::uint32_t>(segment.limited_by.joint + 1) << SegmentFlags::kLimitAxisShift;
    return flags;
}

void put_record(std::vector<double>& values, const motion::Segment& segment) {
    values.insert(values.end(), segment.start.data(), segment.start.data() + segment.start.size());
    values.insert(values.end(), segment.end.data(), segment.end.data() + segment.end.size());
    put(values, segment.lead);
    if (segment.kind == motion::SegmentKind::circular) put(values, segment.arc, segment.position_joints);
    if (segment.orientation) put(values, *segment.orientation);
    values.push_back(static_cast<double>(segment.followers().size()));
    for (const motion::Follower& follower : segment.followers()) {
        values.insert(values.end(), {static_cast<double>(follower.joint), follower.sign});
        put(values, follower.law);
    }
    if (segment.joints_go_apart()) values.push_back(segment.apart & ~motion::kApart);
    if (!segment.beside) return;
    values.insert(values.end(), {static_cast<double>(forms_of(*segment.beside)), segment.beside->duration_s});
    put_record(values, *segment.beside);
}

class ColumnsOut final : public simulation::RunOutput {
  public:
    ColumnsOut(TakeColumns take, const machine::Machine& machine, const std::vector<Vector3d>& tips_mm)
        : take_(std::move(take)),
          setup_(simulation::setup_of_machine(machine)),
          tips_mm_(tips_mm),
          tip_(setup_, tips_mm.front()) {}

    using RunOutput::take;
    void begin(const rrs::JointPos& start) override { add_vertex(tip_.at(start), 0); }
    void take(const motion::Segment& segment, const simulation::MoveInfo& info) override {
        if (info.tip != tip_number_) {
            change_tip(info.tip);
            add_vertex(tip_.at(segment.start), segment.start_s);
        }
        add_row(segment, info);
        put_record(columns_.values, segment);
        if (segment.kind != motion::SegmentKind::rest) draw(segment);
        ++in_chunk_;
        if (in_chunk_ == kColumnChunk || columns_.vertex_s.size() > kMostVertices) hand_out();
    }
    void end(double) override { hand_out(); }

  private:
    void change_tip(std::uint16_t number) {
        tip_number_ = number;
        tip_ = simulation::PartTip(setup_, tips_mm_[number]);
    }

    void add_row(const motion::Segment& segment, const simulation::MoveInfo& info) {
        const bool has_feed = info.kind != simulation::MoveKind::rapid &&
                              info.kind != simulation::MoveKind::dwell && !info.timed;
        columns_.start_s.push_back(segment.start_s);
        columns_.duration_s.push_back(segment.duration_s);
        columns_.length_mm.push_back(segment.length_mm);
        columns_.feed_per_min.push_back(has_feed ? info.feed_per_min : 0);
        columns_.deviation_mm.push_back(segment.deviation_mm);
        columns_.line.push_back(info.place.line);
        columns_.file.push_back(info.place.file);
        columns_.flags.push_back(flags_of(segment, info));
        columns_.tip.push_back(info.tip);
        columns_.record.push_back(static_cast<std::uint32_t>(columns_.values.size()));
    }

    void draw(const motion::Segment& segment) {
        tip_.stand_at(segment.start);
        simulation::add_tip_way(
            segment, tip_, kDrawn_mm,
            [&](const Vector3d& point_mm, double t_s) { add_vertex(point_mm, segment.start_s + t_s); },
            [] { return true; });
    }

    void add_vertex(const Vector3d& point_mm, double time_s) {
        for (const double value : point_mm) columns_.vertex_mm.push_back(static_cast<float>(value));
        columns_.vertex_s.push_back(static_cast<float>(time_s));
        columns_.vertex_segment.push_back(in_chunk_);
    }

    void hand_out() {
        take_(columns_);
        const std::uint64_t next = columns_.first + in_chunk_;
        columns_ = {};
        columns_.first = next;
        in_chunk_ = 0;
    }

    TakeColumns take_;
    motion::PlannerSetup setup_;
    const std::vector<Vector3d>& tips_mm_;
    simulation::PartTip tip_;
    std::uint16_t tip_number_ = 0;
    SegmentColumns columns_;
    std::uint32_t in_chunk_ = 0;
};

}  // namespace

std::unique_ptr<simulation::RunOutput> hand_out_columns(TakeColumns take, const machine::Machine& machine,
                                                        const std::vector<Vector3d>& tips_mm) {
    return std::make_unique<ColumnsOut>(std::move(take), machine, tips_mm);
}

}  // namespace gsim::engine
