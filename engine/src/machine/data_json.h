#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/text/json.h"
#include "machine/data/machine_data_document.h"

namespace gsim::engine {

/// Returns an entry of machine data as JSON: "id", "unit" if the section has lengths, and the fields by their
/// names; null is a missing wall.
nlohmann::ordered_json row_to_json(const machine::SectionRules& rules, const machine::DataRow& row);

/// Returns all entries: an object with a list for each section that is not empty. It does not contain
/// remarks.
nlohmann::ordered_json data_to_json(const machine::MachineDataDocument& document);

/// Returns the inverse conversion, as a separate file. The error is a message that begins with `file_name`.
Result<machine::MachineDataDocument> data_from_json(std::string_view text, const std::string& file_name,
                                                    std::span<const machine::Axis> axes);

}  // namespace gsim::engine
