#pragma once

#include <cstddef>
#include <vector>

#include "geometry/planar/point.h"

namespace gsim::cutting {

/// A set of points from which the nearest one is removed repeatedly.
class NearestGrid {
  public:
    explicit NearestGrid(std::vector<geometry::Point> points);

    std::size_t remaining() const { return remaining_; }
    /// Removes the nearest of the remaining points and returns its number; the set must not be empty.
    std::size_t pop_nearest(geometry::Point to);

  private:
    struct NearestEntry {
        double mm;
        std::size_t cell, slot;
    };

    std::size_t column_index(double x) const;
    std::size_t row_index(double y) const;
    void search_cell(std::size_t column, std::size_t row, geometry::Point to, NearestEntry& best) const;
    void search_ring(std::size_t column, std::size_t row, std::size_t ring, geometry::Point to,
                     NearestEntry& best) const;

    std::vector<geometry::Point> points_;
    geometry::Box box_;
    double cell_mm_ = 1;
    std::size_t columns_ = 1, rows_ = 1;
    std::size_t remaining_ = 0;
    std::vector<std::vector<std::size_t>> cells_;
};

}  // namespace gsim::cutting
