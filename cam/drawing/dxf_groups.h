#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "geometry/planar/point.h"

namespace gsim::drawing {

/// A pair of lines of a DXF file: what the value means, and the value.
struct Group {
    int code = 0;
    std::string_view value;
    std::size_t line = 0;  ///< Line of the value.
};

/// Reads the groups of a DXF file in sequence; a copy continues from the same position. Only the reader of
/// the file catches the errors that it throws.
class GroupReader {
  public:
    explicit GroupReader(std::string_view text) : text_(text) {}

    /// Returns the next group, nothing at the end of the text. Throws Error for an invalid group.
    std::optional<Group> next();
    /// Returns the next group without consuming it.
    std::optional<Group> peek() const { return GroupReader(*this).next(); }
    std::size_t line() const { return line_; }

  private:
    std::string_view read_line();

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
    /// Throws Error if the value is not a finite number.
    double number(int code, double fallback) const;
    double number(int code) const;  ///< Throws also if it is missing.
    int integer_or(int code, int fallback) const;
    geometry::Point point(int code) const;  ///< x at `code`, y ten above.

  private:
    Group kind_;
    std::vector<Group> groups_;
};

/// Returns an error in a line.
Error error_at(std::size_t line, std::string message);

/// Throws Error if the value is not a finite number.
double parse_number(const Group& group);

}  // namespace gsim::drawing
