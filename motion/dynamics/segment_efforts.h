#pragma once

#include <functional>
#include <vector>

#include "motion/dynamics/dynamics.h"
#include "motion/segment/segment.h"

namespace gsim::dynamics {

/// Results of the motors in a part of a motion, for each joint.
struct EffortSums {
    explicit EffortSums(int joints);

    rrs::JointPos squares;        ///< Squared effort over time: N2 s or (Nm)2 s.
    rrs::JointPos drive_j;        ///< Work of the motor at the machine,
    rrs::JointPos regenerated_j;  ///< and of the machine at the motor; 0 or greater, both.
    rrs::JointPos friction_j;     ///< Work of friction at the joint.

    EffortSums& operator+=(const EffortSums& other);
};

/// An instant of a segment.
struct EffortSample {
    double t_s = 0;  ///< Since the start of the segment.
    Dynamics::Motion motion;
    Efforts efforts;
    rrs::JointPos powers_w;
};

/// Integration over segments by their closed forms. Efforts are smooth between the ends of the parts of the
/// time laws and the positions where joints turn back. In between, each part is integrated by the rule of
/// Lobatto with its extension of Kronrod (Gander, Gautschi: Adaptive Quadrature - Revisited, BIT 40, 2000),
/// and halved until both agree.
class SegmentEfforts {
  public:
    /// Takes `dynamics`, which must outlive this object.
    explicit SegmentEfforts(const Dynamics& dynamics) : dynamics_(dynamics) {}

    using SampleHandler = std::function<void(const EffortSample&)>;

    /// Returns the sums of a segment. `visit` receives each instant that is evaluated, including the ends of
    /// each smooth part (from inside, if accelerations jump); in no order.
    EffortSums sums(const motion::Segment& segment, const SampleHandler& visit);

    /// Returns those instants in the order of time.
    std::vector<EffortSample> samples(const motion::Segment& segment);

    /// Returns an instant of a segment. Joints at standstill have no friction.
    EffortSample at(const motion::Segment& segment, double t_s) const;

  private:
    /// All integrated values in sequence.
    using Integrand = Eigen::Array<double, Eigen::Dynamic, 1, Eigen::ColMajor, 4 * rrs::kMaxJoints, 1>;
    struct Part {
        double from_s;
        double to_s;
        rrs::JointPos sense;  ///< Sense of the joints in its middle.
    };

    void split(const motion::Segment& segment);
    EffortSample at(const motion::Segment& segment, double t_s, const rrs::JointPos& sense) const;
    Integrand integrand(const motion::Segment& segment, double t_s, const Part& part,
                        const SampleHandler& visit) const;
    void add(const motion::Segment& segment, const Part& part, int halvings, const SampleHandler& visit,
             int& remaining_parts, Integrand& sum) const;
    bool is_converged(const Integrand& coarse, const Integrand& fine, double time_s) const;
    void add_standstill(const motion::Segment& segment, const SampleHandler& visit, EffortSums& sums) const;

    const Dynamics& dynamics_;
    std::vector<double> ends_s_;  // of the parts of the segment that is gone through
};

}  // namespace gsim::dynamics
