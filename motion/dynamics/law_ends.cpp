#include "motion/dynamics/law_ends.h"

namespace gsim::dynamics {

namespace {

void add_piece_ends(const motion::TimeLaw& law, std::vector<double>& ends_s) {
    double end_s = 0;
    for (const motion::LawPiece& piece : law.pieces()) ends_s.push_back(end_s += piece.duration_s);
}

}  // namespace

void add_law_ends(const motion::Segment& segment, std::vector<double>& ends_s) {
    add_piece_ends(segment.lead, ends_s);
    for (const motion::Follower& follower : segment.followers()) add_piece_ends(follower.law, ends_s);
    if (segment.beside) add_law_ends(*segment.beside, ends_s);
}

}  // namespace gsim::dynamics
