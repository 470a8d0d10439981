#pragma once

#include "toolpath/model/arc_shape.h"
#include "toolpath/rotary/axis_moves.h"

namespace gsim::path {

/// Returns true if the arc is neither too small nor too large for a program's numbers: a short arc's rounded
/// end may lie on the wrong side of its rounded start.
bool is_representable_arc(const ArcShape& arc, const MoveOptions& options);
/// Returns how many circles an arc begins, if one block may say so; otherwise 1.
int turns_per_block(const ArcShape& arc, const MoveOptions& options);
/// Returns the number of blocks, of one turn at most, for an arc in a plane of the axes.
int planar_block_count(const ArcShape& arc, const MoveOptions& options);
/// Returns the number of blocks through a third point for an arc; 0 if that point is hardly off the line
/// between the ends.
int three_point_block_count(const ArcShape& arc, const MoveOptions& options);

}  // namespace gsim::path
