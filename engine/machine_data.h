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

/// Of lengths in machine data and tables of controls.
enum class LengthUnit : std::uint8_t { mm, inch };

/// The data of a controller (docs/machine-data.md) as they stand in their file, to be shown and changed:
/// offsets, points, tools, variables, aliases, zones. text() gives back what was read; a change of an entry
/// changes the words of its line that have another value. What is refused has changed nothing.
///
/// Sections are named by the lines that begin them ("OFFSET"), fields as docs/machine-data.md has them
/// ("LENGTH"), both in any case; an id is the number of an entry, the code of a frame or the name of an
/// alias.
class GSIM_API MachineData {
  public:
    /// How entries are shown.
    enum class Form : std::uint8_t {
        text,  ///< In columns, for people.
        json,  ///< Each an object with "id", "unit" and its fields; null is a wall that is not there.
    };

    /// What a value is.
    enum class Quantity : std::uint8_t {
        length,   ///< In the unit of its entry.
        angle,    ///< deg
        unknown,  ///< A length or an angle: of an axis of a machine that is not known.
        number,   ///< Without unit.
        whole,    ///< A whole number from `least` to `greatest`.
        text,     ///< A word; where there are choices, one of them.
    };
    /// One value of the entries of a section.
    struct Field {
        std::string name = {};
        Quantity quantity = Quantity::length;
        std::string meaning = {};  ///< For people: "length along Z".
        bool required = false;     ///< It is written even where it is 0 or no wall.
        bool may_be_open = false;  ///< "-" may stand for it: there is no such wall.
        int least = 0;
        int greatest = 0;
        std::vector<std::string> choices = {};  ///< The first one holds where none is given.
    };
    struct Section {
        std::string name = {};   ///< "OFFSET"
        std::string title = {};  ///< For people: "Frames".
        std::string ids = {};    ///< Which ids entries have: "1 to 99999".
        bool has_unit = false;   ///< Its entries have lengths.
        std::vector<Field> fields = {};
    };

    /// Data without entries. `name`: of the file, for messages. `machine`: names the axes behind X, Y and Z,
    /// and has the ranges that suspects() looks at; null: not known. It may go before the data.
    explicit MachineData(std::string name, const Machine* machine = nullptr);
    /// The data of a file; of a name that no file has: data without entries. Names are those of files alone.
    static tl::expected<MachineData, Failure> open(const Host& host, const std::string& name,
                                                   const Machine* machine = nullptr, const Tell& tell = {});
    /// The data of a text. `tell` gets all that is wrong with its lines, the failure has the first of it.
    static tl::expected<MachineData, Failure> read(std::string_view text, std::string name,
                                                   const Machine* machine = nullptr, const Tell& tell = {});
    /// The data of JSON as to_json() gives it.
    static tl::expected<MachineData, Failure> from_json(std::string_view json, std::string name,
                                                        const Machine* machine = nullptr);
    MachineData(MachineData&&) noexcept;
    MachineData& operator=(MachineData&&) noexcept;
    ~MachineData();

    /// The file.
    std::string text() const;
    /// All sections that there are, with their fields for this machine.
    std::vector<Section> sections() const;
    /// All entries, as list() has them. The failure: a word is not UTF-8, which list() shows as a replacement
    /// character.
    tl::expected<std::string, Failure> to_json() const;
    /// All entries, or those of a section, in whole lines. As JSON: a list of the section's entries, or an
    /// object with a list for each section that has some.
    tl::expected<std::string, Failure> list(Form form, const std::string& section = {}) const;
    /// An entry, or one value of it, in whole lines. JSON of a value that is not given is null.
    tl::expected<std::string, Failure> get(Form form, const std::string& section, const std::string& id,
                                           const std::string& field = {}) const;
    /// What is suspect in data that can be read: aliases that a control would refuse, points and walls beyond
    /// the ranges of the machine, zones that nothing switches on.
    std::vector<Diagnostic> suspects() const;

    /// Changes an entry, or adds it at the end of its section. Each change is "FIELD=VALUE", the value as it
    /// is written in the file, in the unit of the entry; an empty one takes it away. Where `unit` is given
    /// and the entry has the other one, its other lengths are converted first.
    tl::expected<void, Failure> set(const std::string& section, const std::string& id,
                                    std::span<const std::string> changes,
                                    std::optional<LengthUnit> unit = {});
    /// Sets the values of an entry to 0; an alias or a zone goes away, a point keeps its name.
    tl::expected<void, Failure> reset(const std::string& section, const std::string& id);
    /// The same with all entries, or those of a section.
    tl::expected<void, Failure> reset_all(const std::string& section = {});
    /// Writes all lengths in one unit.
    tl::expected<void, Failure> convert(LengthUnit unit);

  private:
    struct State;
    explicit MachineData(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}  // namespace gsim::engine
