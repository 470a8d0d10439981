#include "calibrate/geometry/suggest.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "calibrate/geometry/identify.h"
#include "calibrate/geometry/tip_errors.h"
#include "machine/model/joint_box.h"

namespace gsim::calibrate {

namespace {

constexpr double kMargin = 0.02;  // of a range, that poses keep from its ends
constexpr std::size_t kCandidatesPerPose = 8, kLeastCandidates = 300;
constexpr int kExchanges = 2;

MeasuredTip pose_at(const machine::Machine& machine, const machine::JointBox& box,
                    const rrs::JointPos& shares, bool orientation) {
    const rrs::JointPos joints = box.at(shares);
    MeasuredTip pose{.has_orientation = orientation};
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
        constexpr double kFine = 1000;  // people read and type them
        const double reading = machine::axis_value(machine.axes[i], joints[static_cast<Eigen::Index>(i)]);
        pose.readings.push_back(std::round(reading * kFine) / kFine);
    }
    return pose;
}

double within(double share) {
    return kMargin + (1 - 2 * kMargin) * share;
}

/// Returns candidates: half of them spread over the ranges, half at ends and middles, which show the largest
/// effects.
std::vector<MeasuredTip> candidates_of(const machine::Machine& machine, std::size_t count, bool orientation) {
    std::vector<MeasuredTip> list = spread_poses(machine, 1, count / 2, orientation);
    const machine::JointBox box = machine::joint_box(machine);
    const int joints = static_cast<int>(machine.axes.size());
    for (int i = 1; list.size() < count; ++i) {
        rrs::JointPos shares = machine::halton_point(i, joints);
        for (double& share : shares) share = within(std::round(2 * share) / 2);
        list.push_back(pose_at(machine, box, shares, orientation));
    }
    const TipFinder finder({.machine = machine, .scales = std::vector<double>(machine.axes.size(), 1)});
    for (MeasuredTip& pose : list) pose.tip = finder.tip(pose.readings);
    return list;
}

/// Selection of candidates by the determinant of their combined information.
class Design {
  public:
    /// `slopes`: `rows` for each candidate. Before any is chosen, deviations are of their usual size.
    Design(const Eigen::MatrixXd& slopes, Eigen::Index rows)
        : slopes_(slopes),
          rows_(rows),
          spread_(Eigen::MatrixXd::Identity(slopes.cols(), slopes.cols())),
          taken_(static_cast<std::size_t>(slopes.rows() / rows), false) {}

    void add(std::size_t candidate) {
        const auto part = part_of(candidate);
        const Eigen::MatrixXd to = spread_ * part.transpose();
        Eigen::MatrixXd inner = part * to;
        inner.diagonal().array() += 1;
        spread_.noalias() -= to * inner.llt().solve(to.transpose());
        taken_[candidate] = true;
    }
    void remove(std::size_t candidate) {
        const auto part = part_of(candidate);
        const Eigen::MatrixXd to = spread_ * part.transpose();
        Eigen::MatrixXd inner = -part * to;
        inner.diagonal().array() += 1;
        spread_.noalias() += to * inner.llt().solve(to.transpose());
        taken_[candidate] = false;
    }
    /// Returns the unused candidate that raises the determinant most.
    std::size_t best() const {
        std::size_t best = 0;
        double most = -1;
        for (std::size_t i = 0; i < taken_.size(); ++i) {
            if (taken_[i]) continue;
            const auto part = part_of(i);
            Eigen::MatrixXd inner = part * spread_ * part.transpose();
            inner.diagonal().array() += 1;
            const double gain = inner.llt().matrixLLT().diagonal().array().log().sum();
            if (gain <= most) continue;
            most = gain;
            best = i;
        }
        return best;
    }
    std::vector<std::size_t> chosen() const {
        std::vector<std::size_t> list;
        for (std::size_t i = 0; i < taken_.size(); ++i)
            if (taken_[i]) list.push_back(i);
        return list;
    }

  private:
    Eigen::MatrixXd part_of(std::size_t candidate) const {
        return slopes_.middleRows(static_cast<Eigen::Index>(candidate) * rows_, rows_);
    }

    const Eigen::MatrixXd& slopes_;
    Eigen::Index rows_;
    Eigen::MatrixXd spread_;  ///< Inverse of the chosen ones' information.
    std::vector<bool> taken_;
};

std::vector<std::size_t> best_of(const Eigen::MatrixXd& slopes, Eigen::Index rows, std::size_t count) {
    Design design(slopes, rows);
    for (std::size_t i = 0; i < count; ++i) design.add(design.best());
    bool changed = true;
    for (int pass = 0; pass < kExchanges && changed; ++pass) {
        changed = false;
        for (const std::size_t old : design.chosen()) {
            design.remove(old);
            const std::size_t better = design.best();
            design.add(better);
            changed = changed || better != old;
        }
    }
    return design.chosen();
}

}  // namespace

std::vector<MeasuredTip> spread_poses(const machine::Machine& machine, int first, std::size_t count,
                                      bool orientation) {
    const machine::JointBox box = machine::joint_box(machine);
    std::vector<MeasuredTip> list;
    for (int i = first; list.size() < count; ++i) {
        rrs::JointPos shares = machine::halton_point(i, static_cast<int>(machine.axes.size()));
        for (double& share : shares) share = within(share);
        list.push_back(pose_at(machine, box, shares, orientation));
    }
    return list;
}

tl::expected<std::vector<MeasuredTip>, std::string> suggest_poses(const machine::Machine& machine,
                                                                  std::size_t count, bool orientation,
                                                                  const DeviationChoice& choice) {
    const auto candidates =
        candidates_of(machine, std::max(kCandidatesPerPose * count, kLeastCandidates), orientation);
    const std::vector<Deviation> all = all_deviations(machine, choice);
    const DeviatedMachine deviated({.machine = machine, .scales = {}});
    const WeightedErrors errors(deviated, all, candidates, {});
    const Eigen::MatrixXd slopes =
        errors.slopes(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(all.size())));
    const Identified told = identify(slopes, all);
    if (told.chosen.empty()) return tl::unexpected<std::string>("no pose tells of any deviation");
    Eigen::MatrixXd wanted(slopes.rows(), static_cast<Eigen::Index>(told.chosen.size()));
    for (std::size_t i = 0; i < told.chosen.size(); ++i)
        wanted.col(static_cast<Eigen::Index>(i)) =
            slopes.col(static_cast<Eigen::Index>(told.chosen[i])) * usual_size(all[told.chosen[i]]);
    const Eigen::Index rows = errors.size(0);
    const auto needed = static_cast<std::size_t>(wanted.cols() / rows + 1);
    if (count < needed)
        return tl::unexpected(
            fmt::format("{} deviations of this machine can be told, which takes {} poses at least",
                        wanted.cols(), needed));
    std::vector<MeasuredTip> poses;
    for (const std::size_t i : best_of(wanted, rows, count)) poses.push_back(candidates[i]);
    return poses;
}

std::string pose_program(const std::vector<MeasuredTip>& poses, const machine::Machine& machine) {
    std::string text = "(poses to measure: clear the machine first, collisions are not looked at)\nG21 G90\n";
    for (std::size_t i = 0; i < poses.size(); ++i) {
        text += "G53 G0";
        for (std::size_t axis = 0; axis < machine.axes.size(); ++axis) {
            if (machine.axes[axis].carries != machine::Carries::nothing)
                text += fmt::format(" {}{:.3f}", machine.axes[axis].letter, poses[i].readings[axis]);
        }
        text += fmt::format("\nM0 (measure {})\n", i + 1);
    }
    return text + "M2\n";
}

}  // namespace gsim::calibrate
