#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "analysis/check/machine_check.h"
#include "base/text/format.h"
#include "base/text/number.h"
#include "base/units.h"
#include "machine/model/group_motion.h"

namespace gsim::check {

namespace {

using cell::Verdict;

// Removes everything that a terminal would take as a command, because names come from files of untrusted
// users.
std::string sanitized(std::string_view text) {
    std::string out(text);
    for (char& c : out) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    }
    return out;
}

const char* inverse_name(machine::InverseKind kind) {
    switch (kind) {
        case machine::InverseKind::gantry: return "gantry (closed form)";
        case machine::InverseKind::numeric: return "numeric";
        case machine::InverseKind::none: break;
    }
    return "none";
}

std::string number_or_dash(double value) {
    return std::isfinite(value) ? fmt::format("{:.6g}", text::unsigned_zero(value)) : "-";
}

class Text {
  public:
    explicit Text(const MachineCheck& check) : check_(check), machine_(check.machine) {}

    std::string release() {
        head();
        axes();
        groups();
        motions();
        inverse();
        singular();
        pair_findings();
        for (const std::string& note : check_.notes) add("note       {}\n", note);
        verdict();
        return std::move(text_);
    }

  private:
    template <typename... Args>
    void add(fmt::format_string<Args...> format, Args&&... args) {
        text::append_format(text_, format, std::forward<Args>(args)...);
    }

    std::string letters(const std::vector<int>& joints) const {
        std::vector<char> list;
        list.reserve(joints.size());
        for (const int joint : joints) list.push_back(machine_.axes[static_cast<std::size_t>(joint)].letter);
        return text::joined(list, " ");
    }

    void head() {
        add("machine    {}\n", sanitized(machine_.name));
        add("controller {}\n", sanitized(machine_.controller.model));
        add("inverse    {}{}\n", inverse_name(machine_.inverse),
            check_.has_head ? ", a head that turns the tool about its TCP" : "");
    }

    void axes() {
        add("\naxis  kind    carries        min        max       home  speed (/s)  accel. (/s2)\n");
        for (const machine::Axis& axis : machine_.axes) {
            const bool linear = axis.kind == machine::AxisKind::linear;
            add("{}     {:<7} {:<7} {:>10} {:>10} {:>10.6g} {:>11} {:>13}\n", axis.letter,
                linear ? "mm" : "deg", machine::name(axis.carries), number_or_dash(axis.min),
                number_or_dash(axis.max), text::unsigned_zero(axis.home), number_or_dash(axis.max_speed),
                number_or_dash(axis.max_acceleration));
        }
        const Eigen::Vector3d tcp = check_.home.translation();
        add("\nhome       TCP at {} {} {} mm in the work frame\n", text::fixed(tcp.x(), 3),
            text::fixed(tcp.y(), 3), text::fixed(tcp.z(), 3));
    }

    void groups() {
        for (const machine::AxisGroup& group : machine_.groups) {
            const bool work = machine_.axes[group.axes.front()].carries == machine::CarriedPart::work;
            std::vector<char> letters;
            for (const std::size_t axis : group.axes) letters.push_back(machine_.axes[axis].letter);
            add("group      {}: {} ({}), {}\n", group.name, text::joined(letters, " "),
                work ? "work" : "tool", machine::name(group.motion));
        }
    }

    void motions() {
        for (const AxisMotion& motion : check_.motions) add("motion     {}\n", to_message(motion));
        for (const std::string& message : check_.left_handed) add("error      {}\n", message);
    }

    void inverse() {
        const InverseCheck& inverse = check_.inverse;
        if (inverse.poses == 0) return;
        add("inverse    {} random poses, within {:.1e} mm and {:.1e} deg: ", inverse.poses, inverse.worst_mm,
            inverse.worst_rad * kDegPerRad);
        if (inverse.is_consistent()) return add("all solved\n");
        add("{} without a solution, {} out of range, {} inaccurate\n", inverse.unsolved, inverse.out_of_range,
            inverse.inaccurate_count);
        add("           first at {}\n", axis_values_text(machine_, inverse.first_bad));
        if (!inverse.message.empty()) add("           {}\n", sanitized(inverse.message));
    }

    void singular() {
        for (const SingularRange& range : check_.singular.ranges) {
            const machine::Axis& axis = machine_.axes[static_cast<std::size_t>(range.joint)];
            add("singular   {} {} .. {} deg, for all values of the other axes: {} are aligned\n", axis.letter,
                text::fixed(machine::axis_value(axis, range.low), 2),
                text::fixed(machine::axis_value(axis, range.high), 2), letters(range.aligned_joints));
        }
        add("singular   {:.2f} % of random configurations are near a singularity\n",
            100 * check_.singular.near_share);
    }

    void pair_findings() {
        if (check_.bodies.empty()) return;
        add("bodies     {}; pairs {}: {} can touch, {} undecided, {} cannot touch\n", check_.bodies.size(),
            check_.pair_findings.size(), check_.count(Verdict::contact), check_.count(Verdict::undecided),
            check_.count(Verdict::free));
        for (const Verdict verdict : {Verdict::contact, Verdict::undecided, Verdict::free}) {
            for (const cell::PairFinding& pair_finding : check_.pair_findings) {
                if (pair_finding.verdict == verdict) add_pair(pair_finding);
            }
        }
    }

    void add_pair(const cell::PairFinding& pair_finding) {
        const std::string pair = fmt::format("{} and {}", sanitized(check_.bodies[pair_finding.items.first]),
                                             sanitized(check_.bodies[pair_finding.items.second]));
        const std::string at = axis_values_text(machine_, pair_finding.joints);
        switch (pair_finding.verdict) {
            case Verdict::contact:
                return add("touch      {}: in {:.1f} % of the samples, for example {}\n", pair,
                           100 * pair_finding.contact_share, at);
            case Verdict::undecided:
                return add("undecided  {}: min distance found {:.3f} mm, at {}\n", pair,
                           pair_finding.nearest_mm, at);
            case Verdict::free:
                return add("free       {}: min distance found {:.3f} mm\n", pair, pair_finding.nearest_mm);
        }
    }

    void verdict() {
        if (check_.is_clean()) return add("clean: no errors found\n");
        add("found:");
        const char* before = " ";
        const auto item = [&](std::size_t count, const char* what) {
            if (count == 0) return;
            add("{}{} {}", before, count, what);
            before = ", ";
        };
        item(check_.count(Verdict::contact), "pairs can touch");
        item(check_.count(Verdict::undecided), "pairs are undecided");
        item(check_.left_handed.size(), "left-handed sets of axes");
        if (!check_.inverse.is_consistent()) add("{}the inverse is inconsistent", before);
        add("\n");
    }

    const MachineCheck& check_;
    const machine::Machine& machine_;
    std::string text_;
};

}  // namespace

std::string to_text(const MachineCheck& check) {
    return Text(check).release();
}

}  // namespace gsim::check
