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
    std::size_t line = 0;  ///< Of the value.
};

/// What is wrong with a file; thrown inside of the readers alone.
struct DrawingFault {
    std::size_t line = 0;
    std::string sentence;
};

/// Walks through the groups of a DXF file; a copy goes on from the same place.
class GroupReader {
  public:
    explicit GroupReader(std::string_view text) : text_(text) {}

    /// The next group, nothing at the end of the text. Throws DrawingFault for what is no group.
    std::optional<Group> next();
    /// The same without going on.
    std::optional<Group> peek() const { return GroupReader(*this).next(); }
    std::size_t line() const { return line_; }

  private:
    std::string_view take_line();

    std::string_view text_;
    std::size_t offset_ = 0;
    std::size_t line_ = 0;  // lines taken
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
    /// Throws DrawingFault for what is no finite number.
    double number(int code, double otherwise) const;
    double number(int code) const;  ///< And where there is none.
    int whole(int code, int otherwise) const;
    geometry::Point point(int code) const;  ///< x at `code`, y ten above.

  private:
    Group kind_;
    std::vector<Group> groups_;
};

/// Throws DrawingFault for what is no finite number.
double number_of(const Group& group);

}  // namespace gsim::drawing
