#include "engine/src/machine/data_sections.h"

namespace gsim::engine {

namespace {

MachineData::Quantity to_quantity(machine::Quantity quantity) {
    switch (quantity) {
        case machine::Quantity::length: return MachineData::Quantity::length;
        case machine::Quantity::angle: return MachineData::Quantity::angle;
        case machine::Quantity::unknown: return MachineData::Quantity::unknown;
        case machine::Quantity::plain: return MachineData::Quantity::number;
        case machine::Quantity::integer: return MachineData::Quantity::integer;
        case machine::Quantity::text: break;
    }
    return MachineData::Quantity::text;
}

MachineData::Field to_data_field(const machine::DataField& field) {
    return {.name = field.name,
            .quantity = to_quantity(field.quantity),
            .meaning = field.meaning,
            .required = field.required,
            .may_be_unlimited = field.may_be_unlimited,
            .min = field.min,
            .max = field.max,
            .choices = {field.choices.begin(), field.choices.end()}};
}

}  // namespace

std::vector<MachineData::Section> data_sections(const machine::DataRules& rules) {
    std::vector<MachineData::Section> sections;
    for (const machine::DataSection each : machine::kDataSections) {
        const machine::SectionRules& of = rules.of(each);
        MachineData::Section section{.name = std::string(of.keyword),
                                     .title = std::string(of.title),
                                     .ids = std::string(of.ids),
                                     .has_unit = of.has_unit};
        for (const machine::DataField& field : of.fields) section.fields.push_back(to_data_field(field));
        sections.push_back(std::move(section));
    }
    return sections;
}

}  // namespace gsim::engine
