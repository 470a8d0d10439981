#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/planar/point.h"

namespace gsim::drawing {

/// A pair of lines of a DXF file: what the value means, and the value.
struct Group {
    int code = 0;
    std::string_view value;
    std::size_t line = 0;  ///< Line of the value.
};

/// An error in a file; thrown only within the readers.
struct DrawingFault {
    std::size_t line = 0;
    std::string sentence;
};

/// Reads the groups of a DXF file in sequence; a copy continues from the same position.
class GroupReader {
  public:
    explicit GroupReader(std::string_view text) : text_(text) {}

    /// Returns the next group, nothing at the end of the text. Throws DrawingFault for an invalid group.
    std::optional<Group> next();
    /// Returns the next group without consuming it.
    std::optional<Group> peek() const { return GroupReader(*this).next(); }
    std::size_t line() const { return line_; }

  private:
    std::string_view take_line();

    std::string_view text_;
    std::size_t offset_ = 0;
    std::size_t line_ = 0;  // lines read
};

/// The groups of one entity, from its kind to the next code 0.
class GroupList {
  public:
    /// Reads the entity that begins with `first`.
    void read(Group first, GroupReader& reader);

    std::string_view kind() const { return kind_.value; }
    std::size_t line() const { return kind_.line; }
    const std::vector<Group>& groups() const { return groups_; }
    std::optional<std::string_view> text(int code) const;
    /// Throws DrawingFault if the value is not a finite number.
    double number(int code, double otherwise) const;
    double number(int code) const;  ///< Throws also if it is missing.
    int whole(int code, int otherwise) const;
    geometry::Point point(int code) const;  ///< x at `code`, y ten above.

  private:
    Group kind_;
    std::vector<Group> groups_;
};

/// Throws DrawingFault if the value is not a finite number.
double number_of(const Group& group);

}  // namespace gsim::drawing
