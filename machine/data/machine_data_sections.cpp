#include "machine/data/machine_data_sections.h"

#include <algorithm>

#include <fmt/format.h>

namespace gsim::machine {

namespace {

using std::string_view_literals::operator""sv;

constexpr std::array kKeywords{"OFFSET"sv,   "FIXED"sv, "REFERENCE"sv, "HOME"sv,   "TOOL"sv,
                               "VARIABLE"sv, "ALIAS"sv, "SECURITY"sv,  "WORKING"sv};
static_assert(kKeywords.size() == kDataSections.size());

constexpr int kMostAxes = 9;
constexpr int kGreatestSwitch = 99;
constexpr int kGreatestOrientation = 9;

Quantity quantity_of(char letter, std::span<const Axis> axes) {
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

DataField named(std::string name, Quantity quantity, std::string meaning) {
    DataField field = positional(std::move(name), quantity, std::move(meaning));
    field.form = FieldForm::named;
    return field;
}

DataField named_whole(std::string name, int least, int greatest, std::string meaning) {
    DataField field = named(std::move(name), Quantity::whole, std::move(meaning));
    field.least = least;
    field.greatest = greatest;
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
        fields.push_back(positional({axis.letter}, quantity_of(axis.letter, axes),
                                    meaning(fmt::format("axis {}", axis.letter))));
    }
    for (int number = 4; axes.empty() && number <= kMostAxes; ++number) {
        fields.push_back(positional(fmt::format("AXIS{}", number), Quantity::unknown,
                                    meaning(fmt::format("the machine's axis {}", number))));
    }
    return fields;
}

std::vector<DataField> tool_fields(std::span<const Axis> axes) {
    std::vector<DataField> fields{required("LENGTH", Quantity::length, "length along Z"),
                                  required("DIAMETER", Quantity::length, "diameter"),
                                  named("LENGTH_WEAR", Quantity::length, "is added to the length"),
                                  named("DIAMETER_WEAR", Quantity::length, "is added to the diameter")};
    for (const char letter : {'X', 'Y', 'A', 'B', 'C', 'U', 'V', 'W'})
        fields.push_back(
            named({letter}, quantity_of(letter, axes), fmt::format("offset along axis {}", letter)));
    fields.push_back(named("FRONT", Quantity::angle, "front angle of a turning tool"));
    fields.push_back(named("BACK", Quantity::angle, "back angle of a turning tool"));
    fields.push_back(named_whole("ORIENTATION", 0, kGreatestOrientation,
                                 "which way the edge of a turning tool looks, 0 to 9"));
    fields.push_back(choice("KIND", {"", "CUTTER", "JET"}, "CUTTER or JET; empty: not said"));
    return fields;
}

std::vector<DataField> wall_fields() {
    std::vector<DataField> fields;
    for (const char letter : {'X', 'Y', 'Z'}) {
        for (const bool lower : {true, false}) {
            DataField field =
                required(fmt::format("{}{}", letter, lower ? "MIN" : "MAX"), Quantity::length,
                         fmt::format("{} wall on axis {}, in machine coordinates; - where there is none",
                                     lower ? "lower" : "upper", letter));
            field.required = letter != 'Z';
            field.may_be_open = true;
            fields.push_back(std::move(field));
        }
    }
    return fields;
}

constexpr std::string_view kNumbers = "1 to 99999";

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
    SectionRules rules = points(title, what, kNumbers, "the point", axes);
    DataField name = named("NAME", Quantity::text, "what scripts call it: letters, digits and _");
    name.is_name = true;
    rules.fields.push_back(std::move(name));
    return rules;
}

constexpr std::string_view kLackingWalls =
    "a zone has its number and its walls: Xmin, Xmax, Ymin, Ymax, and perhaps Zmin and Zmax";

SectionRules zones(std::string_view title, std::string_view what, std::string_view ids) {
    return {.title = title,
            .what = what,
            .ids = ids,
            .lacking = kLackingWalls,
            .has_unit = true,
            .holds_zones = true,
            .fields = wall_fields()};
}

SectionRules security_zones() {
    SectionRules rules = zones("Security zones", "security zone", kNumbers);
    rules.fields.push_back(
        choice("KIND", {"ENTER", "LEAVE"}, "ENTER: the tool must not enter it; LEAVE: it must not leave it"));
    rules.fields.push_back(choice("STATE", {"ON", "OFF"}, "OFF: not in force at the start"));
    rules.fields.push_back(
        named_whole("SWITCH", 1, kGreatestSwitch, "the number by which programs switch it, 1 to 99"));
    return rules;
}

SectionRules rules_of(DataSection section, std::span<const Axis> axes) {
    switch (section) {
        case DataSection::offset:
            return points("Frames", "frame", "54 to 59, 59.1 to 59.3, 505 to 599", "the frame's origin",
                          axes);
        case DataSection::fixed: return named_points("Fixed points", "fixed point", axes);
        case DataSection::reference: return named_points("Reference points", "reference point", axes);
        case DataSection::home:
            return points("Home positions", "home position", "2 to 4", "the home position", axes);
        case DataSection::tool:
            return {.title = "Tools",
                    .what = "tool",
                    .ids = kNumbers,
                    .lacking = "a tool has its number, its length and its diameter",
                    .has_unit = true,
                    .fields = tool_fields(axes)};
        case DataSection::variable:
            return {.title = "Variables",
                    .what = "variable",
                    .ids = kNumbers,
                    .lacking = "a variable has its number and its value",
                    .fields = {required("VALUE", Quantity::plain, "value at the start")}};
        case DataSection::alias:
            return {.title = "Aliases",
                    .what = "alias",
                    .ids = "a name",
                    .lacking = "an alias has its name and its code",
                    .fields = {required("CODE", Quantity::text, "the code it stands for")}};
        case DataSection::security: return security_zones();
        case DataSection::working: break;
    }
    return zones("Working zone", "working zone", "1");
}

}  // namespace

std::optional<std::size_t> SectionRules::find(std::string_view name) const {
    const auto place = std::find_if(fields.begin(), fields.end(),
                                    [&](const DataField& field) { return field.name == name; });
    if (place == fields.end()) return std::nullopt;
    return static_cast<std::size_t>(place - fields.begin());
}

std::optional<std::size_t> SectionRules::name_field() const {
    const auto place =
        std::find_if(fields.begin(), fields.end(), [](const DataField& field) { return field.is_name; });
    if (place == fields.end()) return std::nullopt;
    return static_cast<std::size_t>(place - fields.begin());
}

std::size_t SectionRules::positional() const {
    return static_cast<std::size_t>(std::count_if(fields.begin(), fields.end(), [](const DataField& field) {
        return field.form == FieldForm::positional;
    }));
}

DataRules::DataRules(std::span<const Axis> axes) : axes_known_(!axes.empty()) {
    for (const DataSection section : kDataSections) {
        SectionRules& rules = sections_[static_cast<std::size_t>(section)];
        rules = rules_of(section, axes);
        rules.section = section;
        rules.keyword = keyword(section);
    }
}

std::string_view keyword(DataSection section) {
    return kKeywords[static_cast<std::size_t>(section)];
}

std::optional<DataSection> section_named(std::string_view keyword) {
    const auto place = std::find(kKeywords.begin(), kKeywords.end(), keyword);
    if (place == kKeywords.end()) return std::nullopt;
    return kDataSections[static_cast<std::size_t>(place - kKeywords.begin())];
}

}  // namespace gsim::machine
