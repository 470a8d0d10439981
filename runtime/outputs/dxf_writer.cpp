#include "runtime/outputs/dxf_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/json_text.h"
#include "base/units.h"
#include "runtime/outputs/tcp_curve.h"
#include "runtime/simulator/make_planner_setup.h"

namespace gsim::simulation {

using Eigen::Vector3d;
using motion::Segment;
using motion::SegmentKind;

namespace {

constexpr double kTurn_rad = 2 * std::numbers::pi;
constexpr double kPointTolerance_mm = 1e-9;
constexpr double kStraightness_mm = 1e-7;    // off a line, by rounding
constexpr double kLevelTolerance_mm = 1e-6;  // as drawing readers accept it
constexpr double kRigidityTolerance = 1e-9;
constexpr int kMinSteps = 8;
constexpr std::size_t kMaxPolylinePoints = 10'000;  // points of one polyline

constexpr std::array<std::string_view, 3> kDxfLayers{"RAPID", "FEED", "CUT"};
constexpr std::array<int, 3> kDxfColours{3, 5, 1};  // green, blue, red
constexpr std::string_view kSlopedLayerSuffix = "_Z";

constexpr int kPolyline3d = 8;
constexpr int kVertex3d = 32;

Vector3d point_on_arc(const Vector3d& center_mm, double radius_mm, double angle_rad) {
    return center_mm + radius_mm * Vector3d(std::cos(angle_rad), std::sin(angle_rad), 0);
}

}  // namespace

DxfWriter::DxfWriter(TextStream& out, const machine::Machine& machine, std::uint64_t max_points)
    : out_(out),
      max_points_(max_points),
      setup_(make_planner_setup(machine)),
      tcp_(setup_, Vector3d::Zero()) {}

// --- Groups: a line with the code, a line with the value ---

void DxfWriter::write(int code, std::string_view value) {
    text::append_format(out_.buffer(), "{}\n{}", code, value);
    out_.end_line();
}

void DxfWriter::write(int code, double value) {
    constexpr double kMinNonZero = 5e-13;
    const double visible_value = std::abs(value) < kMinNonZero ? 0 : value;  // no -0
    text::append_format(out_.buffer(), "{}\n{:.12f}", code, visible_value);
    out_.end_line();
}

void DxfWriter::write_point(int code, const Vector3d& point_mm) {
    constexpr int kGroupCodeStep = 10;
    for (const double value : point_mm) {
        write(code, value);
        code += kGroupCodeStep;
    }
}

void DxfWriter::begin(const rrs::JointPos& /*start*/) {
    text::append_text(out_.buffer(),
                      "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n"
                      "0\nSECTION\n2\nTABLES\n"
                      "0\nTABLE\n2\nLTYPE\n70\n1\n"
                      "0\nLTYPE\n2\nCONTINUOUS\n70\n0\n3\nSolid line\n72\n65\n73\n0\n40\n0.0\n0\nENDTAB\n");
    text::append_format(out_.buffer(), "0\nTABLE\n2\nLAYER\n70\n{}\n", 2 * kDxfLayers.size());
    for (std::size_t i = 0; i < kDxfLayers.size(); ++i) {
        for (const std::string_view height : {std::string_view(), kSlopedLayerSuffix}) {
            text::append_format(out_.buffer(), "0\nLAYER\n2\n{}{}\n70\n0\n62\n{}\n6\nCONTINUOUS\n",
                                kDxfLayers[i], height, kDxfColours[i]);
        }
    }
    text::append_text(out_.buffer(), "0\nENDTAB\n0\nENDSEC\n0\nSECTION\n2\nENTITIES");
    out_.end_line();
}

void DxfWriter::end(double /*end_s*/) {
    flush();
    write(0, "ENDSEC");
    write(0, "EOF");
}

// --- Segments ---

void DxfWriter::on_segment(const Segment& segment, const MoveInfo& info) {
    if (segment.kind == SegmentKind::rest || is_truncated()) return;
    const Layer layer = info.kind == MoveKind::rapid ? Layer::rapid
                        : info.process_on            ? Layer::cut
                                                     : Layer::feed;
    if (layer != layer_ || segment.target_id != target_id_) flush();
    layer_ = layer;
    target_id_ = segment.target_id;
    tcp_.set_position(segment.start);
    if (const auto flat_arc = find_flat_arc(segment)) return add(*flat_arc);
    add_curve(segment);
}

/// Returns the TCP at these values of the position joints, with all others as at the segment's start.
Vector3d DxfWriter::tcp_at(const Segment& segment, const Vector3d& position_mm) const {
    rrs::JointPos joints = segment.start;
    for (std::size_t axis = 0; axis < segment.position_joints.size(); ++axis) {
        const int joint = segment.position_joints[axis];
        if (joint >= 0) joints[joint] = position_mm[static_cast<Eigen::Index>(axis)];
    }
    return tcp_.at(joints);
}

/// Returns the arc of the TCP in a segment, if it is one about an axis along Z.
std::optional<DxfWriter::FlatArc> DxfWriter::find_flat_arc(const Segment& segment) const {
    const motion::Arc& arc = segment.arc;
    if (segment.kind != SegmentKind::circular || segment.superimposed) return std::nullopt;
    if (std::abs(arc.end_radius_mm - arc.radius_mm) > kTolerance_mm) return std::nullopt;
    const Vector3d center = tcp_at(segment, arc.center);
    const Vector3d u = tcp_at(segment, arc.center + arc.u) - center;
    const Vector3d v = tcp_at(segment, arc.center + arc.v) - center;
    const bool is_rigid = std::abs(u.norm() - 1) < kRigidityTolerance &&
                          std::abs(v.norm() - 1) < kRigidityTolerance &&
                          std::abs(u.dot(v)) < kRigidityTolerance;
    if (!is_rigid || std::abs(u.z()) > kRigidityTolerance || std::abs(v.z()) > kRigidityTolerance)
        return std::nullopt;
    FlatArc flat_arc{.center_mm = center, .radius_mm = (arc.radius_mm + arc.end_radius_mm) / 2};
    flat_arc.from_rad = std::atan2(u.y(), u.x());
    flat_arc.sweep_rad = u.cross(v).z() > 0 ? arc.sweep_rad : -arc.sweep_rad;
    return follows_arc(segment, flat_arc) ? std::optional(flat_arc) : std::nullopt;
}

/// Returns true if the TCP moves along the arc; it does not on a helix, or if another joint moves it as well.
bool DxfWriter::follows_arc(const Segment& segment, const FlatArc& flat_arc) const {
    for (int i = 1; i <= kMinSteps; ++i) {
        const Vector3d tcp = tcp_.at(segment.position_at(segment.duration_s * i / kMinSteps));
        const Vector3d offset = tcp - flat_arc.center_mm;
        const double radial_error_mm = std::abs(offset.head<2>().norm() - flat_arc.radius_mm);
        if (std::abs(offset.z()) > kLevelTolerance_mm || radial_error_mm > kTolerance_mm) return false;
    }
    const Vector3d end =
        point_on_arc(flat_arc.center_mm, flat_arc.radius_mm, flat_arc.from_rad + flat_arc.sweep_rad);
    return (tcp_.at(segment.end_position()) - end).norm() < kTolerance_mm;
}

/// Merges arcs of one move that continue each other.
void DxfWriter::add(const FlatArc& flat_arc) {
    const auto continues = [&] {
        const bool same = (flat_arc_->center_mm - flat_arc.center_mm).norm() < kStraightness_mm &&
                          std::abs(flat_arc_->radius_mm - flat_arc.radius_mm) < kStraightness_mm &&
                          (flat_arc_->sweep_rad > 0) == (flat_arc.sweep_rad > 0);
        const double end_rad = flat_arc_->from_rad + flat_arc_->sweep_rad;
        return same && std::abs(std::remainder(end_rad - flat_arc.from_rad, kTurn_rad)) * flat_arc.radius_mm <
                           kStraightness_mm;
    };
    if (flat_arc_ && continues()) {
        flat_arc_->sweep_rad += flat_arc.sweep_rad;
        return;
    }
    flush();
    ++drawn_points_;
    flat_arc_ = flat_arc;
}

void DxfWriter::add_curve(const Segment& segment) {
    if (flat_arc_) flush();
    if (points_.empty()) points_.push_back(tcp_.at(segment.start));
    add_tcp_path(
        segment, tcp_, kTolerance_mm,
        [this](const Vector3d& point_mm, double /*t_s*/) { add_point(point_mm); },
        [this] { return !is_truncated(); });
}

/// Merges a line that continues straight.
void DxfWriter::add_point(const Vector3d& point_mm) {
    ++drawn_points_;
    if ((point_mm - points_.back()).norm() < kPointTolerance_mm) return;
    const std::size_t count = points_.size();
    if (count >= 2 && point_line_distance(points_.back(), points_[count - 2], point_mm) < kStraightness_mm) {
        points_.back() = point_mm;
        return;
    }
    points_.push_back(point_mm);
    if (points_.size() < kMaxPolylinePoints) return;
    flush();
    points_.push_back(point_mm);
}

// --- Entities ---

void DxfWriter::flush() {
    if (flat_arc_) write_flat_arc();
    if (points_.size() == 2) write_line();
    if (points_.size() > 2) write_polyline();
    flat_arc_.reset();
    points_.clear();
}

void DxfWriter::begin_entity(std::string_view kind, bool level) {
    write(0, kind);
    write(8,
          fmt::format("{}{}", kDxfLayers[static_cast<std::size_t>(layer_)], level ? "" : kSlopedLayerSuffix));
}

void DxfWriter::write_line() {
    begin_entity("LINE", std::abs(points_[1].z() - points_[0].z()) < kLevelTolerance_mm);
    write_point(10, points_[0]);
    write_point(11, points_[1]);
}

void DxfWriter::write_polyline() {
    const auto [low, high] = std::minmax_element(
        points_.begin(), points_.end(), [](const Vector3d& a, const Vector3d& b) { return a.z() < b.z(); });
    const bool level = high->z() - low->z() < kLevelTolerance_mm;
    begin_entity("POLYLINE", level);
    write(66, "1");
    write_point(10, Vector3d::Zero());
    write(70, std::to_string(kPolyline3d));
    for (const Vector3d& point : points_) {
        begin_entity("VERTEX", level);
        write_point(10, point);
        write(70, std::to_string(kVertex3d));
    }
    begin_entity("SEQEND", level);
}

/// Writes all full turns as one circle, and the remainder as an arc, which DXF has counter-clockwise.
void DxfWriter::write_flat_arc() {
    const double sweep_rad = std::abs(flat_arc_->sweep_rad);
    const double turns = std::floor(sweep_rad / kTurn_rad + kRigidityTolerance);
    if (turns > 0) {
        begin_entity("CIRCLE", true);
        write_point(10, flat_arc_->center_mm);
        write(40, flat_arc_->radius_mm);
    }
    const double remaining_rad = sweep_rad - turns * kTurn_rad;
    if (remaining_rad * flat_arc_->radius_mm < kStraightness_mm) return;
    const double from_rad =
        flat_arc_->sweep_rad > 0 ? flat_arc_->from_rad : flat_arc_->from_rad - remaining_rad;
    begin_entity("ARC", true);
    write_point(10, flat_arc_->center_mm);
    write(40, flat_arc_->radius_mm);
    write(50, from_rad / kRadPerDeg);
    write(51, (from_rad + remaining_rad) / kRadPerDeg);
}

}  // namespace gsim::simulation
