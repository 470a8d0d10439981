#include "machine/data/machine_data.h"

#include <fmt/format.h>

#include "base/os/input_file.h"
#include "machine/data/machine_data_reader.h"
#include "machine/data/machine_data_values.h"

namespace gsim::machine {

Result<MachineData> read_machine_data(std::string_view text, std::string_view file_name,
                                      std::span<const Axis> axes) {
    auto read = read_data_lines(text, file_name, DataRules(axes));
    if (!read) return tl::unexpected(std::move(read.error().front()));
    return std::move(read->data);
}

Result<MachineData> load_machine_data(const std::filesystem::path& path, std::span<const Axis> axes,
                                      os::NameSource name_source) {
    return os::read_text_file(path, name_source).and_then([&](const std::string& text) {
        return read_machine_data(text, path.string(), axes);
    });
}

std::string write_machine_data(const MachineData& data, std::span<const Axis> axes) {
    const DataRules all(axes);
    std::string text = "NCFILE\n";
    for (const DataSection section : kDataSections) {
        const SectionRules& rules = all.of(section);
        const std::vector<DataRow> rows = section_rows(data, rules);
        if (rows.empty()) continue;
        text += fmt::format("{}\n", rules.keyword);
        for (const DataRow& row : rows) text += fmt::format("{}\n", row_line(rules, row));
    }
    return text + "ENDFILE\n";
}

}  // namespace gsim::machine
