#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "engine/api.h"
#include "engine/diagnostic.h"
#include "engine/host.h"
#include "engine/machine.h"

namespace gsim::engine {

/// Unit of lengths in machine data and tables of controllers.
enum class LengthUnit : std::uint8_t { mm, inch };

/// The data of a controller (docs/machine-data.md) as they are in their file, for display and changes:
/// offsets, points, tools, variables, aliases, zones. text() returns the text that was read; a change of an
/// entry changes the words of its line that have another value. A rejected call changes nothing.
///
/// Sections are named by the lines that begin them ("OFFSET"), fields as docs/machine-data.md has them
/// ("LENGTH"), both in any case; an id is the number of an entry, the code of a frame or the name of an
/// alias.
class GSIM_API MachineData {
  public:
    /// Output form of entries.
    enum class Format : std::uint8_t {
        text,  ///< In columns, for people.
        json,  ///< Each an object with "id", "unit" and its fields; null is a wall that is not there.
    };

    /// Kind of a value.
    enum class Quantity : std::uint8_t {
        length,   ///< In the unit of its entry.
        angle,    ///< deg
        unknown,  ///< A length or an angle: of an axis of a machine that is not known.
        number,   ///< Without unit.
        integer,  ///< An integer from `min` to `max`.
        text,     ///< A word; with choices, one of them.
    };
    /// One value of the entries of a section.
    struct Field {
        std::string name = {};
        Quantity quantity = Quantity::length;
        std::string meaning = {};       ///< For people: "length along Z".
        bool required = false;          ///< It is written even if it is 0 or no wall.
        bool may_be_unlimited = false;  ///< "-" is allowed: no such wall.
        int min = 0;
        int max = 0;
        std::vector<std::string> choices = {};  ///< The first one is the default.
    };
    struct Section {
        std::string name = {};   ///< "OFFSET"
        std::string title = {};  ///< For people: "Frames".
        std::string ids = {};    ///< Valid ids of entries: "1 to 99999".
        bool has_unit = false;   ///< Its entries have lengths.
        std::vector<Field> fields = {};
    };

    /// Creates data without entries. `name`: of the file, for messages. `machine`: names the axes that follow
    /// X, Y and Z, and has the ranges that lint_warnings() checks; null: not known. It may be destroyed
    /// before the data.
    explicit MachineData(std::string name, const Machine* machine = nullptr);
    /// Reads the data of a file; if the file does not exist: data without entries. Names are those of files
    /// alone.
    static tl::expected<MachineData, Error> open(const Host& host, const std::string& name,
                                                 const Machine* machine = nullptr,
                                                 const DiagnosticHandler& on_diagnostic = {});
    /// Reads the data of a text. `on_diagnostic` receives all errors of its lines, the returned error is the
    /// first one.
    static tl::expected<MachineData, Error> read(std::string_view text, std::string name,
                                                 const Machine* machine = nullptr,
                                                 const DiagnosticHandler& on_diagnostic = {});
    /// Reads the data of JSON as to_json() returns it.
    static tl::expected<MachineData, Error> from_json(std::string_view json, std::string name,
                                                      const Machine* machine = nullptr);
    MachineData(MachineData&&) noexcept;
    MachineData& operator=(MachineData&&) noexcept;
    ~MachineData();

    /// Returns the text of the file.
    std::string text() const;
    /// Returns all possible sections, with their fields for this machine.
    std::vector<Section> sections() const;
    /// Returns all entries in the form of list(). The failure: a word is not UTF-8, which list() shows as a
    /// replacement character.
    tl::expected<std::string, Error> to_json() const;
    /// Returns all entries, or those of a section, in full lines. As JSON: a list of the section's entries,
    /// or an object with a list for each section that has entries.
    tl::expected<std::string, Error> list(Format form, const std::string& section = {}) const;
    /// Returns an entry, or one value of it, in full lines. JSON of a missing value is null.
    tl::expected<std::string, Error> get(Format form, const std::string& section, const std::string& id,
                                         const std::string& field = {}) const;
    /// Returns lint warnings for readable data: aliases that a controller would reject, points and walls
    /// beyond the ranges of the machine, zones that no code switches on.
    std::vector<Diagnostic> lint_warnings() const;

    /// Changes an entry, or adds it at the end of its section. Each change is "FIELD=VALUE", the value as it
    /// is written in the file, in the unit of the entry; an empty one removes it. If `unit` is given and the
    /// entry has the other one, its other lengths are converted first.
    tl::expected<void, Error> set(const std::string& section, const std::string& id,
                                  std::span<const std::string> changes, std::optional<LengthUnit> unit = {});
    /// Sets the values of an entry to 0; an alias or a zone is removed, a point keeps its name.
    tl::expected<void, Error> reset(const std::string& section, const std::string& id);
    /// Does the same with all entries, or those of a section.
    tl::expected<void, Error> reset_all(const std::string& section = {});
    /// Writes all lengths in one unit.
    tl::expected<void, Error> convert(LengthUnit unit);

  private:
    struct State;
    explicit MachineData(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}  // namespace gsim::engine
