#pragma once

#include "toolpath/model/arc_shape.h"
#include "toolpath/rotary/axis_moves.h"

namespace gsim::path {

/// Whether the arc is no smaller and no larger than what a program's numbers can say as one: a short arc's
/// rounded end may lie on the wrong side of its rounded start.
bool is_worth_an_arc(const ArcShape& arc, const MoveOptions& options);
/// The circles that an arc begins, where one block may say so; else 1.
int turns_in_one(const ArcShape& arc, const MoveOptions& options);
/// Blocks of a turn at most that an arc in a plane of the axes becomes.
int pieces_in_plane(const ArcShape& arc, const MoveOptions& options);
/// Blocks through a third point that an arc becomes; 0: that point is hardly off the line between the ends.
int pieces_through_points(const ArcShape& arc, const MoveOptions& options);

}  // namespace gsim::path
