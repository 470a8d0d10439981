#include "calibrate/geometry/pose_selection.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "calibrate/geometry/identification.h"
#include "calibrate/geometry/tcp_errors.h"
#include "machine/model/joint_box.h"

namespace gsim::calibrate {

namespace {

constexpr double kMargin = 0.02;  // of a range, that poses keep from its ends
constexpr std::size_t kCandidatesPerPose = 8, kMinCandidates = 300;
constexpr int kMaxExchangePasses = 2;

MeasuredTcp pose_at(const machine::Machine& machine, const machine::JointBox& box,
                    const rrs::JointPos& shares, bool orientation) {
    const rrs::JointPos joints = box.at(shares);
    MeasuredTcp pose{.has_orientation = orientation};
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
        constexpr double kRoundingPerUnit = 1000;  // people read and type them
        const double reading_options =
            machine::axis_value(machine.axes[i], joints[static_cast<Eigen::Index>(i)]);
        pose.readings.push_back(std::round(reading_options * kRoundingPerUnit) / kRoundingPerUnit);
    }
    return pose;
}

double with_margin(double share) {
    return kMargin + (1 - 2 * kMargin) * share;
}

/// Returns candidates: half of them spread over the ranges, half at ends and middles, which show the largest
/// effects.
std::vector<MeasuredTcp> make_candidates(const machine::Machine& machine, std::size_t count,
                                         bool orientation) {
    std::vector<MeasuredTcp> list = spread_poses(machine, 1, count / 2, orientation);
    const machine::JointBox box = machine::joint_box(machine);
    const int joints = static_cast<int>(machine.axes.size());
    for (int i = 1; list.size() < count; ++i) {
        rrs::JointPos shares = machine::halton_point(i, joints);
        for (double& share : shares) share = with_margin(std::round(2 * share) / 2);
        list.push_back(pose_at(machine, box, shares, orientation));
    }
    const TcpCalculator calculator(
        {.machine = machine, .scales = std::vector<double>(machine.axes.size(), 1)});
    for (MeasuredTcp& pose : list) pose.tcp = calculator.tcp(pose.readings);
    return list;
}

/// Selection of candidates by the determinant of their combined information.
class Design {
  public:
    /// `slopes`: `rows` for each candidate. Before any is chosen, deviations are of their usual size.
    Design(const Eigen::MatrixXd& slopes, Eigen::Index rows)
        : slopes_(slopes),
          rows_(rows),
          covariance_(Eigen::MatrixXd::Identity(slopes.cols(), slopes.cols())),
          is_selected_(static_cast<std::size_t>(slopes.rows() / rows), false) {}

    void add(std::size_t candidate) {
        const auto part = rows_of_candidate(candidate);
        const Eigen::MatrixXd to = covariance_ * part.transpose();
        Eigen::MatrixXd inner = part * to;
        inner.diagonal().array() += 1;
        covariance_.noalias() -= to * inner.llt().solve(to.transpose());
        is_selected_[candidate] = true;
    }
    void remove(std::size_t candidate) {
        const auto part = rows_of_candidate(candidate);
        const Eigen::MatrixXd to = covariance_ * part.transpose();
        Eigen::MatrixXd inner = -part * to;
        inner.diagonal().array() += 1;
        covariance_.noalias() += to * inner.llt().solve(to.transpose());
        is_selected_[candidate] = false;
    }
    /// Returns the unused candidate that raises the determinant most.
    std::size_t best() const {
        std::size_t best = 0;
        double max = -1;
        for (std::size_t i = 0; i < is_selected_.size(); ++i) {
            if (is_selected_[i]) continue;
            const auto part = rows_of_candidate(i);
            Eigen::MatrixXd inner = part * covariance_ * part.transpose();
            inner.diagonal().array() += 1;
            const double log_determinant_gain = inner.llt().matrixLLT().diagonal().array().log().sum();
            if (log_determinant_gain <= max) continue;
            max = log_determinant_gain;
            best = i;
        }
        return best;
    }
    std::vector<std::size_t> selected() const {
        std::vector<std::size_t> list;
        for (std::size_t i = 0; i < is_selected_.size(); ++i)
            if (is_selected_[i]) list.push_back(i);
        return list;
    }

  private:
    Eigen::MatrixXd rows_of_candidate(std::size_t candidate) const {
        return slopes_.middleRows(static_cast<Eigen::Index>(candidate) * rows_, rows_);
    }

    const Eigen::MatrixXd& slopes_;
    Eigen::Index rows_;
    Eigen::MatrixXd covariance_;  ///< Inverse of the chosen ones' information.
    std::vector<bool> is_selected_;
};

std::vector<std::size_t> select_best_poses(const Eigen::MatrixXd& slopes, Eigen::Index rows,
                                           std::size_t count) {
    Design design(slopes, rows);
    for (std::size_t i = 0; i < count; ++i) design.add(design.best());
    bool changed = true;
    for (int pass = 0; pass < kMaxExchangePasses && changed; ++pass) {
        changed = false;
        for (const std::size_t old : design.selected()) {
            design.remove(old);
            const std::size_t replacement = design.best();
            design.add(replacement);
            changed = changed || replacement != old;
        }
    }
    return design.selected();
}

}  // namespace

std::vector<MeasuredTcp> spread_poses(const machine::Machine& machine, int first, std::size_t count,
                                      bool orientation) {
    const machine::JointBox box = machine::joint_box(machine);
    std::vector<MeasuredTcp> list;
    for (int i = first; list.size() < count; ++i) {
        rrs::JointPos shares = machine::halton_point(i, static_cast<int>(machine.axes.size()));
        for (double& share : shares) share = with_margin(share);
        list.push_back(pose_at(machine, box, shares, orientation));
    }
    return list;
}

Result<std::vector<MeasuredTcp>> suggest_poses(const machine::Machine& machine, std::size_t count,
                                               bool orientation, const DeviationOptions& deviation_options) {
    const auto candidates =
        make_candidates(machine, std::max(kCandidatesPerPose * count, kMinCandidates), orientation);
    const std::vector<Deviation> all = all_deviations(machine, deviation_options);
    const DeviatedMachine deviated({.machine = machine, .scales = {}});
    const WeightedErrors errors(deviated, all, candidates, {});
    const Eigen::MatrixXd slopes =
        errors.slopes(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(all.size())));
    const Identification identified = identify(slopes, all);
    if (identified.selected.empty()) return Unexpected("no pose determines a deviation");
    Eigen::MatrixXd determined_slopes(slopes.rows(), static_cast<Eigen::Index>(identified.selected.size()));
    for (std::size_t i = 0; i < identified.selected.size(); ++i)
        determined_slopes.col(static_cast<Eigen::Index>(i)) =
            slopes.col(static_cast<Eigen::Index>(identified.selected[i])) *
            typical_size(all[identified.selected[i]]);
    const Eigen::Index rows = errors.size(0);
    const auto needed = static_cast<std::size_t>(determined_slopes.cols() / rows + 1);
    if (count < needed)
        return Unexpected(
            fmt::format("{} deviations of this machine can be determined, which requires at least {} poses",
                        determined_slopes.cols(), needed));
    std::vector<MeasuredTcp> poses;
    for (const std::size_t i : select_best_poses(determined_slopes, rows, count))
        poses.push_back(candidates[i]);
    return poses;
}

std::string pose_program(const std::vector<MeasuredTcp>& poses, const machine::Machine& machine) {
    std::string text = "(poses to measure: clear the machine first, collisions are not checked)\nG21 G90\n";
    for (std::size_t i = 0; i < poses.size(); ++i) {
        text += "G53 G0";
        for (std::size_t axis = 0; axis < machine.axes.size(); ++axis) {
            if (machine.axes[axis].carries != machine::CarriedPart::none)
                text += fmt::format(" {}{:.3f}", machine.axes[axis].letter, poses[i].readings[axis]);
        }
        text += fmt::format("\nM0 (measure {})\n", i + 1);
    }
    return text + "M2\n";
}

}  // namespace gsim::calibrate
