#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "geometry/distance/triangle_mesh.h"

namespace gsim::cell {

inline constexpr std::size_t kMaxTriangles = 5'000'000;
inline constexpr double kMaxLength_mm = 1e6;

/// Vertices and triangles as a file has them; a vertex may occur more than once.
struct TriangleSoup {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<Triangle> triangles;

    /// Adds a triangle with its own vertices.
    void add(const std::array<Eigen::Vector3d, 3>& corners);
};

/// The words of a text, line by line.
class WordReader {
  public:
    explicit WordReader(std::string_view text) : remaining_(text) {}

    /// Returns the next word, of this line or of a later one; empty at the end.
    std::string_view next();
    /// Returns the next word of this line; empty at its end.
    std::string_view next_in_line();
    /// Skips the remainder of this line. Returns false at the end of the text.
    bool skip_line();
    std::size_t line() const { return line_; }

  private:
    std::string_view remaining_;
    std::size_t line_ = 1;
};

/// Returns the finite number that the complete word is.
std::optional<double> parse_number(std::string_view word);

/// Reads one of the formats, as the next functions do; errors are ": message" or ":line: message", to be
/// appended to a file name.
Result<TriangleSoup> read_stl_text(std::string_view text);
Result<TriangleSoup> read_stl_binary(std::string_view bytes);
Result<TriangleSoup> read_obj(std::string_view text);
/// True if the size is that required by the count in the header of a binary STL file.
bool is_stl_binary(std::string_view bytes);

}  // namespace gsim::cell
