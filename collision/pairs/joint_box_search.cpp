#include "collision/pairs/joint_box_search.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>

#include "collision/pairs/separation.h"

namespace gsim::cell {

using Eigen::Vector3d;

namespace {

constexpr int kSamples = 1024;
constexpr int kMaxConvexParts = 50'000;  // of the box, for one pair of convex bodies ...
constexpr int kMaxMeshParts = 5'000;     // ... or with a mesh, because its distances take longer
constexpr double kUnbounded_mm = std::numeric_limits<double>::infinity();

/// Part of the joint box: its middle, half its size, and a lower bound of the distance in it.
struct JointBoxPart {
    rrs::JointPos middle;
    rrs::JointPos half;
    double lower_mm;

    bool operator<(const JointBoxPart& other) const { return lower_mm > other.lower_mm; }  // nearest first
};

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

constexpr double kCoaxial = 1e-9;  // of a direction, and of mm

// Returns true if a body next to a joint looks the same at all values of the joint.
bool is_symmetric_about(const Body& body, const LinkFrames& links, const JointAxis& axis) {
    const Convex* convex = body.shape->convex();
    if (convex == nullptr || convex->core == Convex::Core::box || axis.kind == rrs::JointKind::prismatic)
        return false;
    const Eigen::Isometry3d pose = body.pose_in_world(links);
    const auto is_along = [&](const Eigen::Vector3d& vector) {
        return axis.direction.cross(vector).norm() < kCoaxial;
    };
    const bool sphere = convex->core == Convex::Core::points && convex->point_count == 1;
    return is_along(pose.translation() - axis.point_mm) && (sphere || is_along(pose.linear().col(2)));
}

// Returns the joints that change the distance of two bodies. The joint next to a body does not if the body is
// round about it.
std::vector<int> moving_joints(const BodyPair& bodies, const kinematics::Kinematics& kinematics,
                               const rrs::JointPos& home) {
    const LinkFrames links = link_frames(kinematics, home);
    const std::vector<JointAxis> axes = joint_axes(kinematics, home);
    const auto has_no_effect = [&](const Body& body, int joint) {
        return is_symmetric_about(body, links, axes[static_cast<std::size_t>(joint)]);
    };
    std::vector<int> joints = bodies.between;
    while (joints.size() > 1 && has_no_effect(bodies.first, joints.front())) joints.erase(joints.begin());
    while (joints.size() > 1 && has_no_effect(bodies.second, joints.back())) joints.pop_back();
    return joints;
}

class PairSearch {
  public:
    PairSearch(const kinematics::Kinematics& kinematics, const CandidatePair& pair,
               const machine::JointBox& box, const rrs::JointPos& home)
        : kinematics_(kinematics),
          bodies_(pair.bodies),
          joints_(moving_joints(pair.bodies, kinematics, home)),
          reversed_joints_(joints_.rbegin(), joints_.rend()),
          box_(box),
          home_(home),
          finding_{pair.items, Verdict::undecided, kUnbounded_mm, home, 0} {}

    PairFinding run() {
        sample();
        if (finding_.contact_share == 0) descend();
        if (finding_.nearest_mm <= kContactTolerance_mm) {
            finding_.verdict = Verdict::contact;
        } else {
            divide();
        }
        return finding_;
    }

  private:
    // Keeps joints that do not change the distance at home.
    rrs::JointPos sample_joints(int number) const {
        rrs::JointPos joints = home_;
        const rrs::JointPos shares = machine::halton_point(number, static_cast<int>(joints_.size()));
        Eigen::Index i = 0;
        for (const int joint : joints_)
            joints[joint] = box_.low[joint] + shares[i++] * (box_.high[joint] - box_.low[joint]);
        return joints;
    }

    // Sums up shares of the joints' ranges.
    double distance_from_home(const rrs::JointPos& joints) const {
        double sum = 0;
        for (const int joint : joints_) {
            const double range = box_.high[joint] - box_.low[joint];
            if (range > 0) sum += std::abs(joints[joint] - home_[joint]) / range;
        }
        return sum;
    }

    void sample() {
        int contacts = 0;
        double home_distance = kUnbounded_mm;
        for (int number = 0; number <= kSamples; ++number) {
            const rrs::JointPos joints = number == 0 ? home_ : sample_joints(number);
            const double cutoff_mm = contacts > 0 ? 2 * kContactTolerance_mm : finding_.nearest_mm;
            const DistanceBounds current = bodies_.distance_at(link_frames(kinematics_, joints), cutoff_mm);
            if (current.upper_mm <= kContactTolerance_mm) {
                ++contacts;
                const double distance = distance_from_home(joints);
                if (distance >= home_distance) continue;
                home_distance = distance;
                finding_.nearest_mm = current.upper_mm;
                finding_.joints = joints;
            } else if (contacts == 0) {
                note(current.upper_mm, joints);
            }
        }
        finding_.contact_share = static_cast<double>(contacts) / (kSamples + 1);
    }

    // Descends from the nearest sample, joint by joint, in steps that are halved if none leads nearer.
    void descend() {
        for (double share = 0.125; share > 1e-5 && finding_.nearest_mm > kContactTolerance_mm;) {
            const double before = finding_.nearest_mm;
            for (const int joint : joints_) {
                for (const double sense : {-share, share}) {
                    rrs::JointPos joints = finding_.joints;
                    const double distance = sense * (box_.high[joint] - box_.low[joint]);
                    joints[joint] = std::clamp(joints[joint] + distance, box_.low[joint], box_.high[joint]);
                    const LinkFrames links = link_frames(kinematics_, joints);
                    note(bodies_.distance_at(links, finding_.nearest_mm).upper_mm, joints);
                }
            }
            if (finding_.nearest_mm > 0.99 * before) share /= 2;
        }
    }

    void note(double distance_mm, const rrs::JointPos& joints) {
        if (!(distance_mm < finding_.nearest_mm)) return;
        finding_.nearest_mm = distance_mm;
        finding_.joints = joints;
    }

    void divide() {
        std::priority_queue<JointBoxPart> waiting;
        JointBoxPart full_box{home_, rrs::JointPos::Zero(home_.size()), 0};
        for (const int joint : joints_) {
            full_box.middle[joint] = (box_.low[joint] + box_.high[joint]) / 2;
            full_box.half[joint] = (box_.high[joint] - box_.low[joint]) / 2;
        }
        const bool meshes =
            bodies_.first.shape->triangles() != nullptr || bodies_.second.shape->triangles() != nullptr;
        waiting.push(full_box);
        for (int parts = meshes ? kMaxMeshParts : kMaxConvexParts; !waiting.empty() && parts > 0; --parts) {
            const JointBoxPart next = waiting.top();
            waiting.pop();
            const auto [joint, lower_mm] = evaluate(next);
            if (finding_.verdict == Verdict::contact) return;
            if (lower_mm > kContactTolerance_mm) continue;
            for (const double side : {-0.5, 0.5}) {
                JointBoxPart part = next;
                part.lower_mm = lower_mm;
                part.middle[joint] += side * next.half[joint];
                part.half[joint] /= 2;
                waiting.push(std::move(part));
            }
        }
        if (waiting.empty()) finding_.verdict = Verdict::free;
    }

    struct BoxCheck {
        int joint;  ///< Joint at which to divide the part.
        double lower_mm;
    };

    BoxCheck evaluate(const JointBoxPart& part) {
        const LinkFrames links = link_frames(kinematics_, part.middle);
        const std::vector<JointAxis> axes = joint_axes(kinematics_, part.middle);
        const BoundingSphere first = bodies_.first.ball(links);
        const BoundingSphere second = bodies_.second.ball(links);
        JointTravel travel;
        for (const int joint : joints_) travel.distance[static_cast<std::size_t>(joint)] = part.half[joint];
        const ChainMotion chain(axes, travel);
        const double travel_mm =
            std::min(chain.bound(first, joints_).travel_mm, chain.bound(second, reversed_joints_).travel_mm);
        const Gap current = shape_distance_at(links, travel_mm + 2 * kContactTolerance_mm);
        if (current.upper_mm < travel_mm + 2 * kContactTolerance_mm) note(current.upper_mm, part.middle);
        if (current.upper_mm <= kContactTolerance_mm) finding_.verdict = Verdict::contact;
        BoxCheck found{joints_.front(), std::max(part.lower_mm, current.lower_mm - travel_mm)};
        if (current.upper_mm <= kContactTolerance_mm || found.lower_mm > kContactTolerance_mm) return found;
        // Direction from the second body to the first, at their nearest points.
        const Vector3d across =
            (bodies_.second.pose_in_world(links).linear() * (current.on_first - current.on_second))
                .normalized();
        const JointPart axes_of_part{axes, part.half};
        const std::vector<double> first_travels_mm = travels_along_mm(first, axes_of_part, joints_, across);
        std::vector<double> second_travels_mm =
            travels_along_mm(second, axes_of_part, reversed_joints_, -across);
        std::reverse(second_travels_mm.begin(), second_travels_mm.end());
        const bool first_is_smaller = sum(first_travels_mm) < sum(second_travels_mm);
        const std::vector<double>& min = first_is_smaller ? first_travels_mm : second_travels_mm;
        const double gap_mm = distance_along_mm(bodies_.first, bodies_.second, links, across);
        found.lower_mm = std::max(found.lower_mm, gap_mm - sum(min));
        found.joint =
            joints_[static_cast<std::size_t>(std::max_element(min.begin(), min.end()) - min.begin())];
        return found;
    }

    // Returns the gap in the frame of the second body.
    Gap shape_distance_at(const LinkFrames& links, double cutoff_mm) const {
        const Eigen::Isometry3d pose =
            bodies_.second.pose_in_world(links).inverse() * bodies_.first.pose_in_world(links);
        return shape_distance(*bodies_.first.shape, pose, *bodies_.second.shape, cutoff_mm);
    }

    const kinematics::Kinematics& kinematics_;
    const BodyPair& bodies_;
    std::vector<int> joints_;  ///< Those that change the distance of the two.
    std::vector<int> reversed_joints_;
    const machine::JointBox& box_;
    const rrs::JointPos& home_;
    PairFinding finding_;
};

}  // namespace

std::vector<PairFinding> search_joint_box(const Cell& cell, const machine::Machine& machine,
                                          const machine::JointBox& box) {
    const auto kinematics = machine::make_kinematics(machine);
    const rrs::JointPos home = machine::home_position(machine);
    std::vector<PairFinding> findings;
    for (const CandidatePair& pair : candidate_pairs(cell, *kinematics)) {
        if (!pair.includes_jet) findings.push_back(PairSearch(*kinematics, pair, box, home).run());
    }
    return findings;
}

}  // namespace gsim::cell
