#include "machine/data/machine_data_sections.h"

#include <algorithm>

#include <fmt/format.h>

namespace gsim::machine {

namespace {

using std::string_view_literals::operator""sv;

constexpr std::array kKeywords{"OFFSET"sv,   "FIXED"sv, "REFERENCE"sv, "HOME"sv,   "TOOL"sv,
                               "VARIABLE"sv, "ALIAS"sv, "SECURITY"sv,  "WORKING"sv};
static_assert(kKeywords.size() == kDataSections.size());

constexpr int kMaxPointAxes = 9;
constexpr int kMaxSwitch = 99;
constexpr int kMaxOrientation = 9;

Quantity to_quantity(char letter, std::span<const Axis> axes) {
    const auto known =
        std::find_if(axes.begin(), axes.end(), [&](const Axis& axis) { return axis.letter == letter; });
    const bool rotary =
        known == axes.end() ? letter >= 'A' && letter <= 'C' : known->kind == AxisKind::rotary;
    return rotary ? Quantity::angle : Quantity::length;
}

DataField positional(std::string name, Quantity quantity, std::string meaning) {
    return {.name = std::move(name), .quantity = quantity, .meaning = std::move(meaning)};
}

DataField required(std::string name, Quantity quantity, std::string meaning) {
    DataField field = positional(std::move(name), quantity, std::move(meaning));
    field.required = true;
    return field;
}

DataField named_field(std::string name, Quantity quantity, std::string meaning) {
    DataField field = positional(std::move(name), quantity, std::move(meaning));
    field.form = FieldForm::named_field;
    return field;
}

DataField named_integer(std::string name, int min, int max, std::string meaning) {
    DataField field = named_field(std::move(name), Quantity::integer, std::move(meaning));
    field.min = min;
    field.max = max;
    return field;
}

DataField choice(std::string name, std::vector<std::string_view> choices, std::string meaning) {
    return {.name = std::move(name),
            .form = FieldForm::choice,
            .quantity = Quantity::text,
            .choices = std::move(choices),
            .meaning = std::move(meaning)};
}

/// `point` names the object at the point.
std::vector<DataField> point_fields(std::string_view point, std::span<const Axis> axes) {
    const auto meaning = [point](std::string_view axis) {
        return fmt::format("{} on {}, in machine coordinates", point, axis);
    };
    std::vector<DataField> fields;
    for (const char letter : {'X', 'Y', 'Z'})
        fields.push_back(required({letter}, Quantity::length, meaning(fmt::format("axis {}", letter))));
    for (const Axis& axis : axes) {
        if (axis.letter >= 'X' && axis.letter <= 'Z') continue;
        fields.push_back(positional({axis.letter}, to_quantity(axis.letter, axes),
                                    meaning(fmt::format("axis {}", axis.letter))));
    }
    for (int number = 4; axes.empty() && number <= kMaxPointAxes; ++number) {
        fields.push_back(positional(fmt::format("AXIS{}", number), Quantity::unknown,
                                    meaning(fmt::format("axis {} of the machine", number))));
    }
    return fields;
}

std::vector<DataField> tool_fields(std::span<const Axis> axes) {
    std::vector<DataField> fields{required("LENGTH", Quantity::length, "length along Z"),
                                  required("DIAMETER", Quantity::length, "diameter"),
                                  named_field("LENGTH_WEAR", Quantity::length, "added to the length"),
                                  named_field("DIAMETER_WEAR", Quantity::length, "added to the diameter")};
    for (const char letter : {'X', 'Y', 'A', 'B', 'C', 'U', 'V', 'W'})
        fields.push_back(
            named_field({letter}, to_quantity(letter, axes), fmt::format("offset along axis {}", letter)));
    fields.push_back(named_field("FRONT", Quantity::angle, "front angle of a turning tool"));
    fields.push_back(named_field("BACK", Quantity::angle, "back angle of a turning tool"));
    fields.push_back(named_integer("ORIENTATION", 0, kMaxOrientation,
                                   "orientation of the edge of a turning tool, 0 to 9"));
    fields.push_back(choice("KIND", {"", "CUTTER", "JET"}, "CUTTER or JET; empty: not specified"));
    return fields;
}

std::vector<DataField> wall_fields() {
    std::vector<DataField> fields;
    for (const char letter : {'X', 'Y', 'Z'}) {
        for (const bool lower : {true, false}) {
            DataField field = required(fmt::format("{}{}", letter, lower ? "MIN" : "MAX"), Quantity::length,
                                       fmt::format("{} limit on axis {}, in machine coordinates; - for none",
                                                   lower ? "lower" : "upper", letter));
            field.required = letter != 'Z';
            field.may_be_unlimited = true;
            fields.push_back(std::move(field));
        }
    }
    return fields;
}

constexpr std::string_view kNumberRange = "1 to 99999";

SectionRules points(std::string_view title, std::string_view what, std::string_view ids,
                    std::string_view point, std::span<const Axis> axes) {
    return {.title = title,
            .what = what,
            .ids = ids,
            .has_unit = true,
            .holds_points = true,
            .fields = point_fields(point, axes)};
}

SectionRules named_points(std::string_view title, std::string_view what, std::span<const Axis> axes) {
    SectionRules rules = points(title, what, kNumberRange, "the point", axes);
    DataField name = named_field("NAME", Quantity::text, "its name in scripts: letters, digits and _");
    name.is_name = true;
    rules.fields.push_back(std::move(name));
    return rules;
}

constexpr std::string_view kMissingWalls =
    "a zone needs its number and its limits: Xmin, Xmax, Ymin, Ymax, and optionally Zmin and Zmax";

SectionRules zones(std::string_view title, std::string_view what, std::string_view ids) {
    return {.title = title,
            .what = what,
            .ids = ids,
            .missing_message = kMissingWalls,
            .has_unit = true,
            .holds_zones = true,
            .fields = wall_fields()};
}

SectionRules security_zones() {
    SectionRules rules = zones("Security zones", "security zone", kNumberRange);
    rules.fields.push_back(
        choice("KIND", {"ENTER", "LEAVE"},
               "ENTER: the tool must not enter the zone; LEAVE: the tool must not leave it"));
    rules.fields.push_back(choice("STATE", {"ON", "OFF"}, "OFF: not active at the start"));
    rules.fields.push_back(
        named_integer("SWITCH", 1, kMaxSwitch, "the number that programs switch it by, 1 to 99"));
    return rules;
}

SectionRules section_rules(DataSection section, std::span<const Axis> axes) {
    switch (section) {
        case DataSection::offset:
            return points("Frames", "frame", "54 to 59, 59.1 to 59.3, 505 to 599", "the origin of the frame",
                          axes);
        case DataSection::fixed: return named_points("Fixed points", "fixed point", axes);
        case DataSection::reference: return named_points("Reference points", "reference point", axes);
        case DataSection::home:
            return points("Home positions", "home position", "2 to 4", "the home position", axes);
        case DataSection::tool:
            return {.title = "Tools",
                    .what = "tool",
                    .ids = kNumberRange,
                    .missing_message = "a tool needs its number, its length and its diameter",
                    .has_unit = true,
                    .fields = tool_fields(axes)};
        case DataSection::variable:
            return {.title = "Variables",
                    .what = "variable",
                    .ids = kNumberRange,
                    .missing_message = "a variable needs its number and its value",
                    .fields = {required("VALUE", Quantity::plain, "value at the start")}};
        case DataSection::alias:
            return {.title = "Aliases",
                    .what = "alias",
                    .ids = "a name",
                    .missing_message = "an alias needs its name and its code",
                    .fields = {required("CODE", Quantity::text, "the code that it replaces")}};
        case DataSection::security: return security_zones();
        case DataSection::working: break;
    }
    return zones("Working zone", "working zone", "1");
}

}  // namespace

std::optional<std::size_t> SectionRules::find(std::string_view name) const {
    const auto found_field = std::find_if(fields.begin(), fields.end(),
                                          [&](const DataField& field) { return field.name == name; });
    if (found_field == fields.end()) return std::nullopt;
    return static_cast<std::size_t>(found_field - fields.begin());
}

std::optional<std::size_t> SectionRules::name_field() const {
    const auto found_field =
        std::find_if(fields.begin(), fields.end(), [](const DataField& field) { return field.is_name; });
    if (found_field == fields.end()) return std::nullopt;
    return static_cast<std::size_t>(found_field - fields.begin());
}

std::size_t SectionRules::positional() const {
    return static_cast<std::size_t>(std::count_if(fields.begin(), fields.end(), [](const DataField& field) {
        return field.form == FieldForm::positional;
    }));
}

DataRules::DataRules(std::span<const Axis> axes) : has_known_axes_(!axes.empty()) {
    for (const DataSection section : kDataSections) {
        SectionRules& rules = sections_[static_cast<std::size_t>(section)];
        rules = section_rules(section, axes);
        rules.section = section;
        rules.keyword = keyword(section);
    }
}

std::string_view keyword(DataSection section) {
    return kKeywords[static_cast<std::size_t>(section)];
}

std::optional<DataSection> find_section(std::string_view keyword) {
    const auto found_field = std::find(kKeywords.begin(), kKeywords.end(), keyword);
    if (found_field == kKeywords.end()) return std::nullopt;
    return kDataSections[static_cast<std::size_t>(found_field - kKeywords.begin())];
}

}  // namespace gsim::machine
