#include "runtime/machine/machine_data_sections.h"

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

DataField required(std::string name, Quantity quantity) {
    return {.name = std::move(name), .quantity = quantity, .required = true};
}

DataField named(std::string name, Quantity quantity) {
    return {.name = std::move(name), .form = FieldForm::named, .quantity = quantity};
}

DataField named_whole(std::string name, int least, int greatest) {
    DataField field = named(std::move(name), Quantity::whole);
    field.least = least;
    field.greatest = greatest;
    return field;
}

DataField choice(std::string name, std::vector<std::string_view> choices) {
    return {.name = std::move(name),
            .form = FieldForm::choice,
            .quantity = Quantity::text,
            .choices = std::move(choices)};
}

std::vector<DataField> point_fields(std::span<const Axis> axes) {
    std::vector<DataField> fields;
    for (const char letter : {'X', 'Y', 'Z'}) fields.push_back(required({letter}, Quantity::length));
    for (const Axis& axis : axes) {
        if (axis.letter >= 'X' && axis.letter <= 'Z') continue;
        fields.push_back({.name = {axis.letter}, .quantity = quantity_of(axis.letter, axes)});
    }
    for (int number = 4; axes.empty() && number <= kMostAxes; ++number)
        fields.push_back({.name = fmt::format("AXIS{}", number), .quantity = Quantity::unknown});
    return fields;
}

std::vector<DataField> tool_fields(std::span<const Axis> axes) {
    std::vector<DataField> fields{
        required("LENGTH", Quantity::length), required("DIAMETER", Quantity::length),
        named("LENGTH_WEAR", Quantity::length), named("DIAMETER_WEAR", Quantity::length)};
    for (const char letter : {'X', 'Y', 'A', 'B', 'C', 'U', 'V', 'W'})
        fields.push_back(named({letter}, quantity_of(letter, axes)));
    fields.push_back(named("FRONT", Quantity::angle));
    fields.push_back(named("BACK", Quantity::angle));
    fields.push_back(named_whole("ORIENTATION", 0, kGreatestOrientation));
    fields.push_back(choice("KIND", {"", "CUTTER", "JET"}));
    return fields;
}

std::vector<DataField> wall_fields() {
    std::vector<DataField> fields;
    for (const char* name : {"XMIN", "XMAX", "YMIN", "YMAX", "ZMIN", "ZMAX"}) {
        DataField field = required(name, Quantity::length);
        field.required = name[0] != 'Z';
        field.may_be_open = true;
        fields.push_back(std::move(field));
    }
    return fields;
}

SectionRules points(std::string_view what, std::span<const Axis> axes) {
    return {.what = what, .has_unit = true, .holds_points = true, .fields = point_fields(axes)};
}

constexpr std::string_view kLackingWalls =
    "a zone has its number and its walls: Xmin, Xmax, Ymin, Ymax, and perhaps Zmin and Zmax";

SectionRules rules_of(DataSection section, std::span<const Axis> axes) {
    switch (section) {
        case DataSection::offset: return points("frame", axes);
        case DataSection::fixed: return points("fixed point", axes);
        case DataSection::reference: return points("reference point", axes);
        case DataSection::home: return points("home position", axes);
        case DataSection::tool:
            return {.what = "tool",
                    .lacking = "a tool has its number, its length and its diameter",
                    .has_unit = true,
                    .fields = tool_fields(axes)};
        case DataSection::variable:
            return {.what = "variable",
                    .lacking = "a variable has its number and its value",
                    .fields = {required("VALUE", Quantity::plain)}};
        case DataSection::alias:
            return {.what = "alias",
                    .lacking = "an alias has its name and its code",
                    .fields = {required("CODE", Quantity::text)}};
        case DataSection::security: {
            SectionRules zone{.what = "security zone", .lacking = kLackingWalls, .has_unit = true};
            zone.holds_zones = true;
            zone.fields = wall_fields();
            zone.fields.push_back(choice("KIND", {"ENTER", "LEAVE"}));
            zone.fields.push_back(choice("STATE", {"ON", "OFF"}));
            zone.fields.push_back(named_whole("SWITCH", 1, kGreatestSwitch));
            return zone;
        }
        case DataSection::working: break;
    }
    return {.what = "working zone",
            .lacking = kLackingWalls,
            .has_unit = true,
            .holds_zones = true,
            .fields = wall_fields()};
}

}  // namespace

std::optional<std::size_t> SectionRules::find(std::string_view name) const {
    const auto place = std::find_if(fields.begin(), fields.end(),
                                    [&](const DataField& field) { return field.name == name; });
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
