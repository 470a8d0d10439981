#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "machine/model/machine.h"

namespace gsim::machine {

/// The tables of a controller, in the order in which a new file has them.
enum class DataSection { offset, fixed, reference, home, tool, variable, alias, security, working };

inline constexpr std::array kDataSections{DataSection::offset, DataSection::fixed,    DataSection::reference,
                                          DataSection::home,   DataSection::tool,     DataSection::variable,
                                          DataSection::alias,  DataSection::security, DataSection::working};

/// X, Y and Z, the first values of a point.
inline constexpr std::size_t kSpaceAxes = 3;

/// How a value stands in its line.
enum class FieldForm {
    positional,  ///< By its place behind the number of the entry.
    named,       ///< NAME=VALUE, behind the others.
    choice,      ///< One of several words, behind the values.
};

/// What a value is.
enum class Quantity {
    length,   ///< In the unit of its entry.
    angle,    ///< deg
    unknown,  ///< A length or an angle: of an axis of a machine that is not known.
    plain,    ///< A number without unit.
    whole,    ///< A whole number between two limits.
    text,
};

/// One value of an entry.
struct DataField {
    std::string name;  ///< Upper case.
    FieldForm form = FieldForm::positional;
    Quantity quantity = Quantity::length;
    bool required = false;
    bool may_be_open = false;  ///< '-' may stand for it: there is no such limit.
    bool is_name = false;      ///< Of texts: no other entry of the section has it, in any case.
    int least = 0;             ///< Of whole numbers.
    int greatest = 0;
    std::vector<std::string_view> choices = {};  ///< Upper case; the first one holds where none is given.
    std::string meaning = {};                    ///< For people: "angle of the front edge".
};

/// What the entries of a section are.
struct SectionRules {
    DataSection section = DataSection::offset;
    std::string_view keyword = {};  ///< The line that begins the section.
    std::string_view title = {};    ///< For people: "Fixed points".
    std::string_view what = {};     ///< An entry: "fixed point".
    std::string_view ids = {};      ///< Which numbers, codes or names entries have: "1 to 99999".
    std::string_view lacking = {};  ///< The sentence where required values are missing; for points: empty.
    bool has_unit = false;          ///< INCH or METRIC may end a line.
    bool holds_points = false;      ///< X, Y, Z and the further axes of the machine.
    bool holds_zones = false;
    std::vector<DataField> fields = {};  ///< The positional ones first.

    /// Index of the field with that (upper case) name.
    std::optional<std::size_t> find(std::string_view name) const;
    /// Index of the field that is the entry's name, where there is one.
    std::optional<std::size_t> name_field() const;
    std::size_t positional() const;
};

/// The rules of all sections for a machine; without axes the further values of points are called AXIS4 to
/// AXIS9.
class DataRules {
  public:
    explicit DataRules(std::span<const Axis> axes = {});

    const SectionRules& of(DataSection section) const { return sections_[static_cast<std::size_t>(section)]; }
    bool axes_known() const { return axes_known_; }

  private:
    std::array<SectionRules, kDataSections.size()> sections_;
    bool axes_known_ = false;
};

std::string_view keyword(DataSection section);
/// The section that a keyword begins, in upper case.
std::optional<DataSection> section_named(std::string_view keyword);

}  // namespace gsim::machine
