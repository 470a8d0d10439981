#pragma once

#include <optional>

#include "motion/linuxcnc/axes.h"
#include "motion/linuxcnc/blend_arc.h"
#include "motion/linuxcnc/piece.h"

namespace gsim::motion::linuxcnc {

/// A blend arc that could stand between two pieces.
struct Blend {
    Piece piece;
    double cut_before = 0;  ///< As in BlendCircle.
    double cut_after = 0;
    bool takes_before = false;  ///< What is left of the line before is so short that it becomes a part of it.
};

/// The blend arc between two pieces that move X, Y and Z alone; nothing where none fits.
std::optional<Blend> blend_between(const Piece& before, const Piece& after, const Corner& corner,
                                   const Axes& axes, const Planning& planning);

/// Cuts off both pieces what the blend takes.
void make_room(const Blend& blend, const Axes& axes, Piece& before, Piece& after);

}  // namespace gsim::motion::linuxcnc
