#include "engine/src/machine/data_json.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "base/text/json.h"

namespace gsim::engine {

using machine::DataField;
using machine::DataRow;
using machine::DataSection;
using machine::FieldForm;
using machine::MachineDataDocument;
using machine::Quantity;
using machine::SectionRules;
using nlohmann::ordered_json;

namespace {

ordered_json value_to_json(const DataField& field, const std::string& value) {
    if (field.quantity == Quantity::text) return value;
    if (field.quantity == Quantity::integer) return machine::parse_number<int>(value).value_or(0);
    const auto number = machine::parse_number<double>(value);
    return number ? ordered_json(*number) : ordered_json();
}

/// A builder for the lines of a file from the entries of JSON.
class JsonReader {
  public:
    JsonReader(std::string file_name, std::span<const machine::Axis> axes)
        : file_name_(std::move(file_name)), axes_(axes), rules_(axes) {}

    Result<MachineDataDocument> read(const ordered_json& json) {
        if (!json.is_object()) return error("this must be a JSON object with a list for each section");
        for (const auto& [name, entries] : json.items()) {
            const auto section = machine::find_section(name);
            if (!section) return error(fmt::format("'{}' is not a section", machine::printable_word(name)));
            if (!entries.is_array()) return error(fmt::format("{} is not a list", name));
            text_ += fmt::format("{}\n", name);
            for (const ordered_json& entry : entries) {
                if (auto result = add(rules_.of(*section), entry); !result)
                    return tl::unexpected(std::move(result.error()));
            }
        }
        auto document = MachineDataDocument::read(text_ + "ENDFILE\n", file_name_, axes_);
        if (!document) return tl::unexpected(std::move(document.error().front()));
        return *std::move(document);
    }

  private:
    Unexpected error(std::string_view message) const {
        return Unexpected(fmt::format("{}: {}", file_name_, message));
    }

    Unexpected error(const SectionRules& rules, std::string_view id, std::string_view message) const {
        return error(fmt::format("{} {}: {}", rules.keyword, machine::printable_word(id), message));
    }

    Result<void> add(const SectionRules& rules, const ordered_json& entry) {
        const auto id = entry.is_object() ? entry.find("id") : entry.end();
        if (!entry.is_object() || id == entry.end() || !(id->is_string() || id->is_number_integer()))
            return error(fmt::format("an entry of {} must be an object with an \"id\"", rules.keyword));
        DataRow row;
        row.id = id->is_string() ? id->get<std::string>() : id->dump();
        row.values.resize(rules.fields.size());
        for (const auto& [name, value] : entry.items()) {
            if (name == "id") continue;
            if (auto set = set_value(rules, row, name, value); !set)
                return error(rules, row.id, set.error().message);
        }
        return add_line(rules, row);
    }

    static Result<void> set_value(const SectionRules& rules, DataRow& row, const std::string& name,
                                  const ordered_json& value) {
        if (name == "unit" && rules.has_unit) {
            if (value != "inch" && value != "metric")
                return Unexpected("the unit must be \"inch\" or \"metric\"");
            row.unit = value == "inch" ? machine::LengthUnit::inch : machine::LengthUnit::metric;
            return {};
        }
        const auto index = rules.find(name);
        if (!index)
            return Unexpected(fmt::format("{} has no '{}'", rules.keyword, machine::printable_word(name)));
        const DataField& field = rules.fields[*index];
        std::string& text = row.values[*index];
        if (value.is_null() && field.may_be_unlimited) {
            text.assign(1, '-');
        } else if (field.quantity == Quantity::text ? value.is_string() : value.is_number()) {
            text = value.is_string()           ? value.get<std::string>()
                   : value.is_number_integer() ? value.dump()
                                               : machine::number_text(value.get<double>());
        } else {
            return Unexpected(
                fmt::format("{} is not a {}", name, field.quantity == Quantity::text ? "string" : "number"));
        }
        if (machine::is_data_word(text)) return {};
        return Unexpected(fmt::format("{}: '{}' must be one word", name, machine::printable_word(text)));
    }

    Result<void> add_line(const SectionRules& rules, const DataRow& row) {
        const auto end = row.values.begin() + static_cast<std::ptrdiff_t>(rules.positional());
        const auto gap = std::find(row.values.begin(), end, "");
        if (std::any_of(gap, end, [](const std::string& value) { return !value.empty(); })) {
            const auto field = static_cast<std::size_t>(gap - row.values.begin());
            return error(rules, row.id,
                         fmt::format("{} is missing, but later values are given", rules.fields[field].name));
        }
        if (!machine::is_data_word(row.id)) return error(rules, row.id, "the id must be one word");
        const std::string line = machine::row_line(rules, row);
        const auto read = machine::read_row(rules, machine::data_words(line));
        if (!read) return error(rules, row.id, read.error().message);
        if (!keys_.insert(machine::data_key(rules.section, read->row.id)).second)
            return error(rules, row.id, "it is given twice");
        if (const auto name = machine::name_key(rules, read->row); name && !keys_.insert(*name).second)
            return error(rules, row.id, "its NAME is already used by another entry");
        text_ += fmt::format("{}\n", line);
        return {};
    }

    std::string file_name_;
    std::span<const machine::Axis> axes_;
    machine::DataRules rules_;
    std::set<std::string> keys_;
    std::string text_ = "NCFILE\n";
};

}  // namespace

ordered_json row_to_json(const SectionRules& rules, const DataRow& row) {
    ordered_json json{{"id", row.id}};
    if (rules.has_unit) json["unit"] = row.unit == machine::LengthUnit::inch ? "inch" : "metric";
    for (std::size_t i = 0; i < rules.fields.size(); ++i) {
        if (!row.values[i].empty())
            json[rules.fields[i].name] = value_to_json(rules.fields[i], row.values[i]);
    }
    return json;
}

ordered_json data_to_json(const MachineDataDocument& document) {
    ordered_json json = ordered_json::object();
    for (const DataSection section : machine::kDataSections) {
        const SectionRules& rules = document.rules().of(section);
        for (const DataRow& row : document.rows(section))
            json[std::string(rules.keyword)].push_back(row_to_json(rules, row));
    }
    return json;
}

Result<MachineDataDocument> data_from_json(std::string_view text, const std::string& file_name,
                                           std::span<const machine::Axis> axes) {
    try {
        return JsonReader(file_name, axes).read(text::parse_json<ordered_json>(text));
    } catch (const ordered_json::parse_error& error) {
        return Unexpected(fmt::format("{}: byte {}: this is not valid JSON", file_name, error.byte));
    } catch (const ordered_json::out_of_range&) {
        return Unexpected(fmt::format("{}: a number is too large: the max is about 1e308", file_name));
    }
}

}  // namespace gsim::engine
