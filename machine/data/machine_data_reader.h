#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "machine/data/machine_data.h"
#include "machine/data/machine_data_row.h"

namespace gsim::machine {

/// A line of a file, as it is.
struct DataLine {
    enum class Kind { other, section, entry, left_out, end };  ///< other: empty, a remark, or NCFILE.

    std::string text;
    std::string end;  ///< "\n", "\r\n", or empty at the end of the file.
    Kind kind = Kind::other;
    DataSection section = DataSection::offset;  ///< For keywords of sections, entries and '...'.
    std::string id;                             ///< For entries.
};

/// A valid file.
struct ParsedData {
    std::vector<DataLine> lines;
    MachineData data;
};

/// Reads a complete file. Each error is "file:line:column: message", at most one per line and 100 in total,
/// in the order of the lines.
tl::expected<ParsedData, std::vector<Error>> read_data_lines(std::string_view text,
                                                             std::string_view file_name,
                                                             const DataRules& rules);

}  // namespace gsim::machine
