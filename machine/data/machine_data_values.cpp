#include "machine/data/machine_data_values.h"

#include <string>

#include "machine/data/machine_data_words.h"

namespace gsim::machine {

namespace {

int id_number(const std::string& id) {
    return parse_number<int>(id).value_or(0);
}

/// Reader and writer of the values of one row by the names of their fields.
class NamedValues {
  public:
    NamedValues(const SectionRules& rules, const DataRow& row) : rules_(rules), row_(row) {}

    double number(std::string_view name) const { return row_.number(rules_, *rules_.find(name)); }
    const std::string& text(std::string_view name) const { return row_.values[*rules_.find(name)]; }

  private:
    const SectionRules& rules_;
    const DataRow& row_;
};

class RowWriter {
  public:
    RowWriter(const SectionRules& rules, std::string id) : rules_(rules) {
        row_.id = std::move(id);
        row_.values.resize(rules.fields.size());
    }

    void set(std::string_view name, std::string text) { row_.values[*rules_.find(name)] = std::move(text); }
    void set(std::string_view name, double value) { set(name, number_text(value)); }
    void set_nonzero(std::string_view name, double value) {
        if (value != 0) set(name, value);
    }
    DataRow release() { return std::move(row_); }

  private:
    const SectionRules& rules_;
    DataRow row_;
};

AxisValues axis_values(const SectionRules& rules, const DataRow& row, bool has_known_axes) {
    AxisValues values;
    for (std::size_t i = 0; i < rules.positional(); ++i) {
        if (i >= kSpaceAxes && (row.values[i].empty() || !has_known_axes)) break;
        values[rules.fields[i].name[0]] = row.number(rules, i);
    }
    return values;
}

DataRow point_row(const SectionRules& rules, std::string id, const AxisValues& point) {
    RowWriter row(rules, std::move(id));
    std::size_t count = kSpaceAxes;
    for (std::size_t i = count; i < rules.positional(); ++i) {
        const DataField& field = rules.fields[i];
        if (field.quantity != Quantity::unknown && point.contains(field.name[0])) count = i + 1;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const auto value = point.find(rules.fields[i].name[0]);
        row.set(rules.fields[i].name, value == point.end() ? 0 : value->second);
    }
    return row.release();
}

bool is_tool_offset(const DataField& field) {
    return field.form == FieldForm::named_field && field.name.size() == 1;
}

Tool make_tool(const SectionRules& rules, const DataRow& row) {
    const NamedValues values(rules, row);
    Tool tool;
    tool.length_mm = values.number("LENGTH");
    tool.diameter_mm = values.number("DIAMETER");
    tool.length_wear_mm = values.number("LENGTH_WEAR");
    tool.diameter_wear_mm = values.number("DIAMETER_WEAR");
    tool.front_angle_deg = values.number("FRONT");
    tool.back_angle_deg = values.number("BACK");
    tool.orientation = static_cast<int>(values.number("ORIENTATION"));
    if (values.text("KIND") == "CUTTER") tool.kind = ToolKind::cutter;
    if (values.text("KIND") == "JET") tool.kind = ToolKind::jet;
    for (std::size_t i = 0; i < rules.fields.size(); ++i) {
        if (is_tool_offset(rules.fields[i]) && !row.values[i].empty())
            tool.offsets[rules.fields[i].name[0]] = row.number(rules, i);
    }
    return tool;
}

DataRow tool_row(const SectionRules& rules, int number, const Tool& tool) {
    RowWriter row(rules, std::to_string(number));
    row.set("LENGTH", tool.length_mm);
    row.set("DIAMETER", tool.diameter_mm);
    row.set_nonzero("LENGTH_WEAR", tool.length_wear_mm);
    row.set_nonzero("DIAMETER_WEAR", tool.diameter_wear_mm);
    row.set_nonzero("FRONT", tool.front_angle_deg);
    row.set_nonzero("BACK", tool.back_angle_deg);
    row.set_nonzero("ORIENTATION", tool.orientation);
    if (tool.kind != ToolKind::unspecified) row.set("KIND", tool.kind == ToolKind::jet ? "JET" : "CUTTER");
    for (const auto& [letter, value] : tool.offsets) {
        const auto field = rules.find(std::string_view(&letter, 1));
        if (field && is_tool_offset(rules.fields[*field])) row.set(rules.fields[*field].name, value);
    }
    return row.release();
}

Zone make_zone(const SectionRules& rules, const DataRow& row) {
    Zone zone;
    zone.number = id_number(row.id);
    for (std::size_t axis = 0; axis < zone.limits.size(); ++axis) {
        const std::size_t low = 2 * axis;
        if (row.values[low].empty() || row.values[low] == kNoLimit) continue;
        zone.limits[axis] = ZoneLimits{row.number(rules, low), row.number(rules, low + 1)};
    }
    if (rules.section == DataSection::working) {
        zone.kind = ZoneKind::working;
        return zone;
    }
    const NamedValues values(rules, row);
    if (values.text("KIND") == "LEAVE") zone.kind = ZoneKind::leave_forbidden;
    zone.active_at_start = values.text("STATE") != "OFF";
    if (!values.text("SWITCH").empty()) zone.switch_number = id_number(values.text("SWITCH"));
    return zone;
}

DataRow zone_row(const SectionRules& rules, const Zone& zone) {
    RowWriter row(rules, std::to_string(zone.number));
    for (std::size_t axis = 0; axis < zone.limits.size(); ++axis) {
        const auto& limits = zone.limits[axis];
        const std::size_t low = 2 * axis;
        if (!limits && !rules.fields[low].required) continue;
        row.set(rules.fields[low].name, limits ? number_text(limits->min_mm) : std::string(kNoLimit));
        row.set(rules.fields[low + 1].name, limits ? number_text(limits->max_mm) : std::string(kNoLimit));
    }
    if (rules.section == DataSection::working) return row.release();
    row.set("KIND", zone.kind == ZoneKind::leave_forbidden ? "LEAVE" : "ENTER");
    if (!zone.active_at_start) row.set("STATE", "OFF");
    if (zone.switch_number) row.set("SWITCH", std::to_string(*zone.switch_number));
    return row.release();
}

template <typename Points>
std::vector<DataRow> point_rows(const SectionRules& rules, const Points& points) {
    std::vector<DataRow> rows;
    rows.reserve(points.size());
    for (const auto& [id, values] : points) {
        if constexpr (std::is_same_v<typename Points::key_type, int>) {
            rows.push_back(point_row(rules, std::to_string(id), values));
        } else {
            rows.push_back(point_row(rules, id, values));
        }
    }
    return rows;
}

using Names = std::map<int, std::string>;

std::vector<DataRow> named_point_rows(const SectionRules& rules, const std::map<int, AxisValues>& points,
                                      const Names& names) {
    std::vector<DataRow> rows = point_rows(rules, points);
    const std::size_t field = rules.name_field().value();
    for (DataRow& row : rows) {
        const auto name = names.find(id_number(row.id));
        if (name != names.end()) row.values[field] = name->second;
    }
    return rows;
}

void add_name(Names& names, int number, const SectionRules& rules, const DataRow& row) {
    const std::string& name = row.values[rules.name_field().value()];
    if (!name.empty()) names[number] = name;
}

std::vector<DataRow> tool_rows(const MachineData& data, const SectionRules& rules) {
    std::vector<DataRow> rows;
    rows.reserve(data.tools.size());
    for (const auto& [number, tool] : data.tools) rows.push_back(tool_row(rules, number, tool));
    return rows;
}

std::vector<DataRow> variable_rows(const MachineData& data) {
    std::vector<DataRow> rows;
    rows.reserve(data.variables.size());
    for (const auto& [number, value] : data.variables)
        rows.push_back({.id = std::to_string(number), .values = {number_text(value)}});
    return rows;
}

std::vector<DataRow> alias_rows(const MachineData& data) {
    std::vector<DataRow> rows;
    rows.reserve(data.aliases.size());
    for (const auto& [name, code] : data.aliases) rows.push_back({.id = name, .values = {code}});
    return rows;
}

std::vector<DataRow> zone_rows(const MachineData& data, const SectionRules& rules) {
    std::vector<DataRow> rows;
    rows.reserve(data.security_zones.size());
    for (const auto& [number, zone] : data.security_zones) rows.push_back(zone_row(rules, zone));
    return rows;
}

}  // namespace

void add_row(MachineData& data, const SectionRules& rules, const DataRow& row, bool has_known_axes) {
    const int number = id_number(row.id);
    switch (rules.section) {
        case DataSection::offset: data.offsets[row.id] = axis_values(rules, row, has_known_axes); break;
        case DataSection::fixed:
            data.fixed[number] = axis_values(rules, row, has_known_axes);
            add_name(data.fixed_names, number, rules, row);
            break;
        case DataSection::reference:
            data.references[number] = axis_values(rules, row, has_known_axes);
            add_name(data.reference_names, number, rules, row);
            break;
        case DataSection::home: data.homes[number] = axis_values(rules, row, has_known_axes); break;
        case DataSection::tool: data.tools[number] = make_tool(rules, row); break;
        case DataSection::variable: data.variables[number] = row.number(rules, 0); break;
        case DataSection::alias: data.aliases[row.id] = row.values[0]; break;
        case DataSection::security: data.security_zones[number] = make_zone(rules, row); break;
        case DataSection::working: data.working_zone = make_zone(rules, row); break;
    }
}

std::vector<DataRow> section_rows(const MachineData& data, const SectionRules& rules) {
    switch (rules.section) {
        case DataSection::offset: return point_rows(rules, data.offsets);
        case DataSection::fixed: return named_point_rows(rules, data.fixed, data.fixed_names);
        case DataSection::reference: return named_point_rows(rules, data.references, data.reference_names);
        case DataSection::home: return point_rows(rules, data.homes);
        case DataSection::tool: return tool_rows(data, rules);
        case DataSection::variable: return variable_rows(data);
        case DataSection::alias: return alias_rows(data);
        case DataSection::security: return zone_rows(data, rules);
        case DataSection::working: break;
    }
    if (!data.working_zone) return {};
    return {zone_row(rules, *data.working_zone)};
}

}  // namespace gsim::machine
