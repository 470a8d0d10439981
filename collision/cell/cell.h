#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "collision/cell/frame_trajectory.h"
#include "collision/cell/frame_tree.h"
#include "geometry/distance/shape.h"

namespace gsim::cell {

/// Role of a body for the tool: the jet may cut workpieces, and exists only while the process is on.
enum class Role : std::uint8_t { machine, jet, workpiece, fixture };

/// Body of the cell: an object, a part of the machine, or the jet.
struct Item {
    std::string name;
    Role role;
    Shape shape;
    std::size_t frame;  ///< Frame of the shape, in the cell's FrameTree.
};

/// Surroundings of a machine, and the shapes of its own parts. Read from a cell file; see docs/cell-file.md.
struct Cell {
    std::string name = {};
    double clearance_mm = 0;  ///< Bodies that come nearer to each other are reported.
    FrameTree frames;
    std::vector<Item> items = {};
    /// Independent frames, in the order of their links.
    std::vector<MovingFrame> moving_frames = {};
    std::size_t replaced = 0;  ///< Number of shapes of the machine file that the cell replaces.
    /// Pairs of items, as indices, that may touch each other.
    std::vector<std::pair<std::size_t, std::size_t>> ignored = {};

    /// Makes a frame independent from now on; it is at standstill at first.
    void make_movable(std::size_t frame, bool conveyor) {
        const auto next = std::find_if(moving_frames.begin(), moving_frames.end(),
                                       [frame](const MovingFrame& one) { return one.frame > frame; });
        moving_frames.insert(next, {frame, conveyor, FrameTrajectory(frames.pose_in_parent(frame))});
        frames.make_movable(frame);
    }
};

}  // namespace gsim::cell
