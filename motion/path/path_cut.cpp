// Cuts a tool path into lines of the joints; declared in tool_path.h.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/text/number.h"
#include "base/units.h"
#include "motion/path/tool_path.h"
#include "motion/planner/range_check.h"

namespace gsim::motion {

namespace {

constexpr double kShareOfTolerance = 0.95;  // checks at only the quarters may miss the worst
constexpr double kAngleTolerance_rad = 1e-4;
constexpr double kLargestTurn_rad = 0.2;  // of a sub-segment, before any check of it
constexpr int kMostCutHalvings = 30;      // of such a sub-segment
constexpr std::size_t kMostPathPieces = 200'000;
constexpr double kNoBend = 2e-9;  // mm or rad between a chord and its curve: what inverses leave

/// Part of the path that may be a line of the joints or have to be halved, by shares of the path.
struct UncutPiece {
    double from = 0;
    double to = 0;
    int halvings = 0;
};

class Cutter {
  public:
    Cutter(const ToolPath& path, const PlannerSetup& setup, const rrs::JointPos& start)
        : path_(path), setup_(setup), from_(start) {}

    tl::expected<std::vector<PathPiece>, PlanError> run() {
        fill();
        while (!ahead_.empty()) {
            const UncutPiece next = ahead_.back();
            ahead_.pop_back();
            if (Planned taken = take(next); !taken) return tl::unexpected(std::move(taken.error()));
        }
        return with_bends_of_neighbours();
    }

  private:
    void fill() {
        const double turns = path_.way().kind == SegmentKind::circular ? path_.way().arc.sweep_rad : 0.0;
        const double count = std::ceil((turns + path_.turn_rad()) / kLargestTurn_rad);
        const int stretches = static_cast<int>(std::clamp(count, 1.0, 1e5));
        for (int i = stretches; i > 0; --i)
            ahead_.push_back({static_cast<double>(i - 1) / stretches, static_cast<double>(i) / stretches, 0});
    }

    Planned take(const UncutPiece& uncut) {
        const double middle = (uncut.from + uncut.to) / 2;
        const auto mid = path_.joints_at(middle, from_);
        if (!mid) return unreachable(mid.error(), middle);
        const auto end = path_.joints_at(uncut.to, *mid);
        if (!end) return unreachable(end.error(), uncut.to);
        if (Planned checked = check_target_ranges(setup_, *end); !checked) return checked;
        if (follows(uncut, *mid, *end)) return add(uncut, *mid, *end);
        if (uncut.halvings >= kMostCutHalvings) return jump(uncut, *end);
        ahead_.push_back({middle, uncut.to, uncut.halvings + 1});
        ahead_.push_back({uncut.from, middle, uncut.halvings + 1});
        return {};
    }

    bool follows(const UncutPiece& uncut, const rrs::JointPos& mid, const rrs::JointPos& end) const {
        for (const double share : {0.25, 0.5, 0.75}) {
            const rrs::CartPos pose = path_.seen(from_ + share * (end - from_));
            const Eigen::Vector3d wanted = path_.way().at(uncut.from + share * (uncut.to - uncut.from));
            const double off_mm = (pose * path_.tip_mm() - wanted).norm();
            if (!(off_mm <= kShareOfTolerance * setup_.controller.tcp_tolerance_mm)) return false;
            if (share != 0.5) continue;
            const Eigen::Quaterniond there(pose.linear());
            if (!(there.angularDistance(Eigen::Quaterniond(path_.seen(mid).linear())) <=
                  kAngleTolerance_rad)) {
                return false;
            }
        }
        return true;
    }

    Planned add(const UncutPiece& uncut, const rrs::JointPos& mid, const rrs::JointPos& end) {
        if (pieces_.size() >= kMostPathPieces) {
            return refused(rrs::Status::RRS_INVALID_PARAMETER,
                           fmt::format("The way of the tool would take more than {} lines of the joints.",
                                       kMostPathPieces));
        }
        PathPiece piece;
        piece.share = uncut.to - uncut.from;
        piece.end = end;
        piece.bend = (from_ - 2 * mid + end).cwiseAbs();
        const double length = piece.share * path_.length();
        for (double& bend : piece.bend) bend = bend > kNoBend ? 4 * bend / (length * length) : 0;
        pieces_.push_back(std::move(piece));
        from_ = end;
        return {};
    }

    /// The larger curvature holds on both of two neighbours if it changes fast between them.
    std::vector<PathPiece> with_bends_of_neighbours() const {
        std::vector<PathPiece> pieces = pieces_;
        for (std::size_t i = 1; i < pieces.size(); ++i) {
            pieces[i].bend = pieces[i].bend.cwiseMax(pieces_[i - 1].bend);
            pieces[i - 1].bend = pieces[i - 1].bend.cwiseMax(pieces_[i].bend);
        }
        return pieces;
    }

    std::string place(double share) const {
        const Eigen::Vector3d point = path_.way().at(share);
        return fmt::format("at X{} Y{} Z{} of the work frame", text::fixed(point.x(), 3),
                           text::fixed(point.y(), 3), text::fixed(point.z(), 3));
    }

    Planned unreachable(const std::string& why, double share) const {
        return refused(rrs::Status::RRS_NO_SOLUTION,
                       fmt::format("The tool cannot follow its way {}: {}", place(share), why));
    }

    Planned jump(const UncutPiece& uncut, const rrs::JointPos& end) const {
        Eigen::Index joint = 0;
        (end - from_).cwiseAbs().maxCoeff(&joint);
        const bool rotary = setup_.role(static_cast<int>(joint)) == JointRole::rotary;
        return refused(
            rrs::Status::RRS_NO_SOLUTION,
            fmt::format("The way of the tool passes a singular place {}, where joint {} (counted from 0) "
                        "would jump by {:.3g} {}; lead it round that place, or move by joints.",
                        place(uncut.to), joint,
                        std::abs(end[joint] - from_[joint]) * (rotary ? kDegPerRad : 1.0),
                        rotary ? "deg" : "mm"));
    }

    const ToolPath& path_;
    const PlannerSetup& setup_;
    rrs::JointPos from_;
    std::vector<UncutPiece> ahead_;  ///< The next one at the back.
    std::vector<PathPiece> pieces_;
};

}  // namespace

tl::expected<std::vector<PathPiece>, PlanError> cut(const ToolPath& path, const PlannerSetup& setup,
                                                    const rrs::JointPos& start) {
    if (!(path.length() > 0)) return std::vector<PathPiece>();
    return Cutter(path, setup, start).run();
}

}  // namespace gsim::motion
