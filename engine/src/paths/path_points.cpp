#include "engine/src/paths/path_points.h"

#include <set>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/letter_case.h"
#include "machine/model/secondary_homes.h"

namespace gsim::engine {

namespace {

using path::MachinePoint;

constexpr std::size_t kMaxListed = 10;

/// A section of the machine data.
struct Points {
    const std::map<int, machine::AxisValues>& values;
    const std::map<int, std::string>& names;
};

Points machine_points(const machine::MachineData& data, MachinePoint::Kind kind) {
    if (kind == MachinePoint::Kind::fixed) return {data.fixed, data.fixed_names};
    return {data.references, data.reference_names};
}

std::string list_points(const Points& points) {
    std::vector<std::string> texts;
    for (const auto& [number, values] : points.values) {
        if (texts.size() == kMaxListed) break;
        const auto name = points.names.find(number);
        texts.push_back(name == points.names.end() ? fmt::format("{}", number)
                                                   : fmt::format("{} ({})", number, name->second));
    }
    if (texts.empty()) return "none are defined";
    const std::size_t more = points.values.size() - texts.size();
    return fmt::format("available: {}{}", text::joined(texts, ", "),
                       more > 0 ? fmt::format(" and {} more", more) : "");
}

// Names are not case-sensitive.
const machine::AxisValues* find_point(const Points& points, const MachinePoint& point) {
    int number = point.number;
    for (const auto& [each, name] : points.names) {
        if (!point.alias.empty() && text::lower(name) == text::lower(point.alias)) number = each;
    }
    const auto found = points.values.find(number);
    return found == points.values.end() ? nullptr : &found->second;
}

class PointCompleter {
  public:
    PointCompleter(const PointTables& tables, const codegen::Post& post)
        : tables_(tables),
          post_(post),
          homes_(machine::secondary_homes(tables.machine,
                                          tables.data == nullptr ? decltype(homes_)() : tables.data->homes)) {
        for (const machine::Axis& axis : tables.machine.axes) homes_[1][axis.letter] = axis.home;
    }

    std::optional<gsim::Error> complete(MachinePoint& point) {
        const bool is_home = point.kind == MachinePoint::Kind::reference && point.alias.empty();
        if (auto error = is_home ? check_home_word(point) : check_point_word(point)) return error;
        return is_home ? complete_home(point) : complete_point(point);
    }

    std::vector<std::string> notes() const {
        if (unknown_.empty()) return {};
        return {
            fmt::format("neither the machine file nor machine data define the positions of the reference "
                        "points {}; Z moves there first, as if it moved up",
                        text::joined(unknown_, ", "))};
    }

  private:
    std::optional<gsim::Error> complete_home(MachinePoint& point) {
        const auto home = homes_.find(point.number);
        if (home == homes_.end()) {
            unknown_.insert(point.number);
        } else {
            point.axes = moved(home->second);
        }
        return std::nullopt;
    }

    std::optional<gsim::Error> complete_point(MachinePoint& point) const {
        if (tables_.data == nullptr)
            return fmt::format("the position of {} is not defined; give the machine data with --machine-data",
                               path::point_title(point));
        const Points points = machine_points(*tables_.data, point.kind);
        const machine::AxisValues* values = find_point(points, point);
        if (values == nullptr)
            return fmt::format("{} is not defined in {}; {}", path::point_title(point), tables_.data_name,
                               list_points(points));
        point.axes = moved(*values);
        return std::nullopt;
    }

    std::optional<gsim::Error> check_point_word(const MachinePoint& point) const {
        if (!post_.offsets.machine.empty()) return std::nullopt;
        return fmt::format(
            "the post '{}' has no word for machine coordinates ([offsets] machine), which are required to "
            "move to {}",
            post_.name, path::point_title(point));
    }
    std::optional<gsim::Error> check_home_word(const MachinePoint& point) const {
        const std::size_t count = post_.references.go.size();
        if (static_cast<std::size_t>(point.number) <= count) return std::nullopt;
        if (count == 0)
            return fmt::format("the post '{}' has no words for reference points ([reference_points] go)",
                               post_.name);
        return fmt::format("the post '{}' has no word for {} ([reference_points] go); it has 1 to {}",
                           post_.name, path::point_title(point), count);
    }

    // X, Y, Z and the rotary axes, which paths move.
    machine::AxisValues moved(const machine::AxisValues& values) const {
        machine::AxisValues found;
        for (const machine::Axis& axis : tables_.machine.axes) {
            const bool is_rotary = axis.kind == machine::AxisKind::rotary;
            const auto value = values.find(axis.letter);
            const bool is_moved = is_rotary || (axis.letter >= 'X' && axis.letter <= 'Z');
            if (is_moved && value != values.end()) found.insert(*value);
        }
        return found;
    }

    const PointTables& tables_;
    const codegen::Post& post_;
    std::map<int, machine::AxisValues> homes_;
    std::set<int> unknown_;
};

}  // namespace

Result<std::vector<std::string>> complete_points(path::PathFile& file, const PointTables& tables,
                                                 const codegen::Post& post) {
    PointCompleter completer(tables, post);
    for (std::size_t i = 0; i < file.program.paths.size(); ++i) {
        std::vector<path::Target>& targets = file.program.paths[i].targets;
        for (std::size_t target = 0; target < targets.size(); ++target) {
            auto* point = std::get_if<MachinePoint>(&targets[target]);
            if (point == nullptr) continue;
            if (const auto error = completer.complete(*point))
                return tl::unexpected(file.with_location({i, target}, error->message));
        }
    }
    return completer.notes();
}

}  // namespace gsim::engine
