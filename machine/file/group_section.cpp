#include "machine/file/group_section.h"

#include <algorithm>
#include <array>

#include "base/text/format.h"
#include "machine/model/group_motion.h"

namespace gsim::machine {

using base::FirstError;
using base::TomlSection;
using base::TomlWriter;

using std::string_view_literals::operator""sv;

namespace {

constexpr std::array kGroupKeys{"name"sv, "axes"sv, "motion"sv};
constexpr std::array kMotionNames{"synchronous"sv, "coordinated"sv,
                                  "independent"sv};  // in the order of GroupMotion
// Parts of a pose in addition to the groups: {x=, y=, z=, roll=, pitch=, yaw=}.
constexpr std::array kPoseComponents{"x"sv, "y"sv, "z"sv, "roll"sv, "pitch"sv, "yaw"sv};

bool is_group_name(std::string_view name) {
    const auto is_letter = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    };
    return !name.empty() && is_letter(name[0]) && std::all_of(name.begin(), name.end(), [&](char c) {
        return is_letter(c) || (c >= '0' && c <= '9');
    });
}

class GroupReader {
  public:
    GroupReader(FirstError& error, Machine& machine) : error_(error), machine_(machine) {}

    void read(const toml::table& table) {
        TomlSection section(error_, table, "[[group]]", kGroupKeys);
        AxisGroup group;
        group.name = read_name(section);
        read_axes(section, table, group);
        group.motion = static_cast<GroupMotion>(section.choice("motion", 0, kMotionNames));
        check_motion(section, group);
        machine_.groups.push_back(std::move(group));
    }

  private:
    std::string read_name(TomlSection& section) {
        std::string name = section.text("name");
        if (!is_group_name(name)) {
            section.fail("name", "'name' must be letters, digits and _, and must not begin with a digit");
        } else if (std::find(kPoseComponents.begin(), kPoseComponents.end(), name) != kPoseComponents.end()) {
            section.fail("name",
                         fmt::format("'{}' is a component of a pose; a group needs another name", name));
        }
        const auto same = [&](const AxisGroup& other) { return other.name == name; };
        if (std::any_of(machine_.groups.begin(), machine_.groups.end(), same))
            section.fail("name", fmt::format("two groups have the name '{}'; names must be unique", name));
        return name;
    }

    void read_axes(TomlSection& section, const toml::table& table, AxisGroup& group) {
        if (section.require("axes") == nullptr) return;
        const toml::array* letters = table.get_as<toml::array>("axes");
        if (letters == nullptr || letters->empty())
            return section.fail("axes", "'axes' must be a list of axis letters, such as [\"C\"]");
        for (const toml::node& node : *letters) read_axis(node, group);
        const auto carries = [&](std::size_t axis) { return machine_.axes[axis].carries; };
        const bool differ = std::any_of(group.axes.begin(), group.axes.end(), [&](std::size_t axis) {
            return carries(axis) != carries(group.axes.front());
        });
        if (differ)
            section.fail(
                "axes",
                "some of these axes carry the tool and some the work; a group must carry only one of them");
    }

    void read_axis(const toml::node& node, AxisGroup& group) {
        const auto letter = node.value<std::string_view>();
        const auto axis = letter && letter->size() == 1 ? machine_.find((*letter)[0]) : std::nullopt;
        const auto where = node.source().begin;
        if (!axis) {
            std::string letters;
            for (const Axis& one : machine_.axes) letters += fmt::format(" {}", one.letter);
            return error_.report(where,
                                 fmt::format("'axes' must contain axis letters of this machine:{}", letters));
        }
        for (const AxisGroup& other : machine_.groups) {
            if (std::find(other.axes.begin(), other.axes.end(), *axis) == other.axes.end()) continue;
            return error_.report(
                where, fmt::format("axis {} is already in the group '{}'; it may be in only one group",
                                   *letter, other.name));
        }
        if (std::find(group.axes.begin(), group.axes.end(), *axis) != group.axes.end())
            return error_.report(where, fmt::format("axis {} is given twice", *letter));
        group.axes.push_back(*axis);
    }

    void check_motion(TomlSection& section, const AxisGroup& group) {
        if (group.motion != GroupMotion::coordinated || machine_.inverse == InverseKind::numeric) return;
        section.fail("motion",
                     "'motion = \"coordinated\"' needs 'inverse = \"numeric\"'; if X, Y and Z carry the TCP, "
                     "G43.4 coordinates all axes");
    }

    FirstError& error_;
    Machine& machine_;
};

}  // namespace

std::string_view name(GroupMotion motion) {
    return kMotionNames[static_cast<std::size_t>(motion)];
}

void read_groups(FirstError& error, TomlSection& file, Machine& machine) {
    if (!file.has("group")) return;
    GroupReader reader(error, machine);
    std::size_t grouped_axes = 0;
    for (const toml::table* table : file.tables("group")) {
        reader.read(*table);
        grouped_axes += machine.groups.back().axes.size();
    }
    if (machine.inverse == InverseKind::numeric && grouped_axes == machine.axes.size())
        file.fail("group",
                  "all axes are in groups; the axes that move the tool to a pose must not be in a group");
}

void print_groups(TomlWriter& out, const Machine& machine) {
    for (const AxisGroup& group : machine.groups) {
        out.section("[[group]]");
        out.line("name", base::toml_string(group.name));
        std::vector<std::string> letters;
        for (const std::size_t axis : group.axes)
            letters.push_back(base::toml_string({&machine.axes[axis].letter, 1}));
        out.line("axes", fmt::format("[{}]", text::joined(letters, ", ")));
        if (group.motion != GroupMotion{}) out.line("motion", base::toml_string(name(group.motion)));
    }
}

}  // namespace gsim::machine
