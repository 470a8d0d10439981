#pragma once

#include <span>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "base/text/json.h"
#include "machine/data/machine_data_document.h"

namespace gsim::engine {

/// An entry of machine data as JSON: "id", "unit" where the section has lengths, and the fields by their
/// names; null is a wall that is not there.
nlohmann::ordered_json row_to_json(const machine::SectionRules& rules, const machine::DataRow& row);

/// All entries: an object with a list for each section that is not empty. Remarks are not in it.
nlohmann::ordered_json data_to_json(const machine::MachineDataDocument& document);

/// The way back, as a file of its own. The error is a sentence that begins with `file_name`.
tl::expected<machine::MachineDataDocument, std::string> data_from_json(std::string_view text,
                                                                       const std::string& file_name,
                                                                       std::span<const machine::Axis> axes);

}  // namespace gsim::engine
