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

/// The tables of a controller, in the order of a new file.
enum class DataSection { offset, fixed, reference, home, tool, variable, alias, security, working };

inline constexpr std::array kDataSections{DataSection::offset, DataSection::fixed,    DataSection::reference,
                                          DataSection::home,   DataSection::tool,     DataSection::variable,
                                          DataSection::alias,  DataSection::security, DataSection::working};

/// Number of the first values of a point: X, Y and Z.
inline constexpr std::size_t kSpaceAxes = 3;

/// Form of a value in its line.
enum class FieldForm {
    positional,   ///< By its position past the entry's number.
    named_field,  ///< NAME=VALUE, past the others.
    choice,       ///< One of several words that follow the values.
};

/// Meaning of a value.
enum class Quantity {
    length,   ///< In the unit of its entry.
    angle,    ///< deg
    unknown,  ///< A length or an angle: of an axis of a machine that is not known.
    plain,    ///< A number without unit.
    integer,  ///< An integer between two limits.
    text,
};

/// One value of an entry.
struct DataField {
    std::string name;  ///< Upper case.
    FieldForm form = FieldForm::positional;
    Quantity quantity = Quantity::length;
    bool required = false;
    bool may_be_unlimited = false;  ///< '-' may replace it: no such limit exists.
    bool is_name = false;           ///< For texts: unique in the section, regardless of case.
    int min = 0;                    ///< For integers.
    int max = 0;
    std::vector<std::string_view> choices = {};  ///< Upper case; the first one applies if none is given.
    std::string meaning = {};                    ///< For people: "angle of the front edge".
};

/// Rules for the entries of a section.
struct SectionRules {
    DataSection section = DataSection::offset;
    std::string_view keyword = {};          ///< The line that begins the section.
    std::string_view title = {};            ///< For people: "Fixed points".
    std::string_view what = {};             ///< An entry: "fixed point".
    std::string_view ids = {};              ///< Numbers, codes or names of entries: "1 to 99999".
    std::string_view missing_message = {};  ///< Message if required values are missing; for points: empty.
    bool has_unit = false;                  ///< INCH or METRIC may end a line.
    bool holds_points = false;              ///< X, Y, Z and the further axes of the machine.
    bool holds_zones = false;
    std::vector<DataField> fields = {};  ///< The positional ones first.

    /// Returns the index of the field with that (upper case) name.
    std::optional<std::size_t> find(std::string_view name) const;
    /// Returns the index of the field that is the entry's name, if it has one.
    std::optional<std::size_t> name_field() const;
    std::size_t positional() const;
};

/// The rules of all sections for a machine. Without axes the further values of points are called AXIS4 to
/// AXIS9.
class DataRules {
  public:
    explicit DataRules(std::span<const Axis> axes = {});

    const SectionRules& of(DataSection section) const { return sections_[static_cast<std::size_t>(section)]; }
    bool has_known_axes() const { return has_known_axes_; }

  private:
    std::array<SectionRules, kDataSections.size()> sections_;
    bool has_known_axes_ = false;
};

std::string_view keyword(DataSection section);
/// Returns the section that a keyword, in upper case, begins.
std::optional<DataSection> find_section(std::string_view keyword);

}  // namespace gsim::machine
