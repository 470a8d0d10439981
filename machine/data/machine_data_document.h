#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "base/error.h"
#include "machine/data/machine_data_reader.h"

namespace gsim::machine {

/// Machine data as they are in their file, to be displayed, changed and saved, as in the preprocessor form of
/// a controller. text() returns the bytes that were read. A change of an entry changes only its line, and in
/// it only the words with another value. A change that would make an invalid file returns a message and
/// changes nothing.
class MachineDataDocument {
  public:
    /// Creates a file without entries, for a machine with these axes (none: not known).
    explicit MachineDataDocument(std::span<const Axis> axes = {});

    /// Reads a file; each error is "file:line:column: message", as in read_data_lines().
    static tl::expected<MachineDataDocument, std::vector<Error>> read(std::string_view text,
                                                                      std::string_view file_name,
                                                                      std::span<const Axis> axes = {});

    std::string text() const;
    const MachineData& data() const { return data_; }
    const DataRules& rules() const { return rules_; }

    /// Returns the entries of a section as they are written, in the order of their lines.
    std::vector<DataRow> rows(DataSection section) const;
    /// Returns one entry, or nothing if it does not exist. Names of aliases count without regard to case.
    std::optional<DataRow> find(DataSection section, std::string_view id) const;
    struct SourceLocation {
        std::size_t line = 1;
        std::size_t column = 1;
    };
    /// Returns the position of an entry, or of its field of that index. The entry must exist; a field without
    /// a word counts as the entry.
    SourceLocation location(DataSection section, std::string_view id,
                            std::optional<std::size_t> field = {}) const;

    /// A field by its (upper case) name, and its new value as it is to be written, in the unit of the entry;
    /// an empty value removes it.
    using FieldValues = std::vector<std::pair<std::string, std::string>>;

    /// Changes an entry, or adds it at the end of its section; missing values are then 0, or no limit. If
    /// `unit` is given and the entry has the other one, its other lengths are converted first.
    Result<void> set(DataSection section, std::string_view id, const FieldValues& values,
                     std::optional<LengthUnit> unit = {});
    /// Removes an entry from the file, with its line.
    Result<void> erase(DataSection section, std::string_view id);
    /// Sets the numbers of an entry to 0. Removes named values, except the name of a point. Removes an alias
    /// or a zone completely.
    Result<void> reset(DataSection section, std::string_view id);
    /// Runs reset() on all entries of a section.
    Result<void> reset_all(DataSection section);
    /// Writes all lengths in one unit. Their meaning stays the same, to 15 digits.
    Result<void> convert(LengthUnit unit);
    /// Changes the file so that it contains these data. Entries keep their units.
    Result<void> update(const MachineData& data);

  private:
    // Defined in machine_data_edit.cpp: changes of lines_, without a check of the complete file.
    std::optional<std::size_t> find_line(DataSection section, std::string_view id) const;
    ParsedRow row_at(std::size_t line) const;
    Result<void> edit(std::size_t line, const FieldValues& values);
    Result<void> convert_line(std::size_t line, LengthUnit unit);
    Result<void> add(const SectionRules& rules, DataRow row, const FieldValues& values);
    std::size_t section_end(DataSection section);
    void insert_line(std::size_t before, std::string text, DataLine::Kind kind, DataSection section);
    void erase_line(std::size_t line);
    Result<void> reset_line(std::size_t line);

    // Defined in machine_data_update.cpp.
    Result<void> update_section(const SectionRules& rules, const MachineData& data);
    Result<void> update_entry(const SectionRules& rules, const DataRow& before, const DataRow& after);

    /// Runs a change of lines_ and reads the result; undoes the change if the file is invalid.
    template <typename Change>
    Result<void> attempt(Change change);

    DataRules rules_;
    std::vector<DataLine> lines_;
    MachineData data_;
};

}  // namespace gsim::machine
