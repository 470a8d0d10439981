#include "cam/cutting/nearest_grid.h"

#include <cmath>

namespace gsim::cutting {

using geometry::Point;

namespace {

constexpr double kPointsPerCell = 2;

std::size_t cell_index(double value, double low, double cell, std::size_t count) {
    const double part = std::floor((value - low) / cell);
    return static_cast<std::size_t>(std::clamp(part, 0.0, static_cast<double>(count - 1)));
}

}  // namespace

NearestGrid::NearestGrid(std::vector<Point> points) : points_(std::move(points)), remaining_(points_.size()) {
    for (const Point& point : points_) box_.add(point);
    if (points_.empty()) box_.add(Point{});
    const Point size = box_.high - box_.low;
    const double count = std::max(1.0, static_cast<double>(points_.size()) / kPointsPerCell);
    // For points on a line the area would be 0.
    cell_mm_ = std::max({std::sqrt(size.x * size.y / count), std::max(size.x, size.y) / count, 1e-9});
    columns_ = static_cast<std::size_t>(size.x / cell_mm_) + 1;
    rows_ = static_cast<std::size_t>(size.y / cell_mm_) + 1;
    cells_.resize(columns_ * rows_);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        cells_[row_index(points_[i].y) * columns_ + column_index(points_[i].x)].push_back(i);
    }
}

std::size_t NearestGrid::column_index(double x) const {
    return cell_index(x, box_.low.x, cell_mm_, columns_);
}

std::size_t NearestGrid::row_index(double y) const {
    return cell_index(y, box_.low.y, cell_mm_, rows_);
}

void NearestGrid::search_cell(std::size_t column, std::size_t row, Point to, NearestEntry& best) const {
    const std::size_t cell = row * columns_ + column;
    for (std::size_t slot = 0; slot < cells_[cell].size(); ++slot) {
        const double mm = distance(points_[cells_[cell][slot]], to);
        if (mm < best.mm) best = {mm, cell, slot};
    }
}

void NearestGrid::search_ring(std::size_t column, std::size_t row, std::size_t ring, Point to,
                              NearestEntry& best) const {
    const std::size_t low_row = row - std::min(row, ring);
    const std::size_t high_row = std::min(row + ring, rows_ - 1);
    for (std::size_t r = low_row; r <= high_row; ++r) {
        const bool is_full_row = (row >= ring && r == row - ring) || r == row + ring;
        const std::size_t low = column - std::min(column, ring);
        const std::size_t high = std::min(column + ring, columns_ - 1);
        if (is_full_row) {
            for (std::size_t c = low; c <= high; ++c) search_cell(c, r, to, best);
            continue;
        }
        if (column >= ring) search_cell(column - ring, r, to, best);
        if (ring > 0 && column + ring < columns_) search_cell(column + ring, r, to, best);
    }
}

std::size_t NearestGrid::pop_nearest(Point to) {
    const std::size_t column = column_index(to.x);
    const std::size_t row = row_index(to.y);
    NearestEntry best{HUGE_VAL, 0, 0};
    const std::size_t max_ring = std::max(columns_, rows_);
    for (std::size_t ring = 0; ring <= max_ring; ++ring) {
        search_ring(column, row, ring, to, best);
        // Points in outer rings are farther away than the width of this ring.
        if (best.mm <= static_cast<double>(ring) * cell_mm_) break;
    }
    std::vector<std::size_t>& cell = cells_[best.cell];
    const std::size_t found = cell[best.slot];
    cell[best.slot] = cell.back();
    cell.pop_back();
    --remaining_;
    return found;
}

}  // namespace gsim::cutting
