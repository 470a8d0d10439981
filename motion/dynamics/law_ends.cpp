#include "motion/dynamics/law_ends.h"

namespace gsim::dynamics {

namespace {

void add_section_ends(const motion::TimeLaw& law, std::vector<double>& ends_s) {
    double end_s = 0;
    for (const motion::LawSection& section : law.sections()) ends_s.push_back(end_s += section.duration_s);
}

}  // namespace

void add_law_ends(const motion::Segment& segment, std::vector<double>& ends_s) {
    add_section_ends(segment.master, ends_s);
    for (const motion::Follower& follower : segment.followers()) add_section_ends(follower.law, ends_s);
    if (segment.superimposed) add_law_ends(*segment.superimposed, ends_s);
}

}  // namespace gsim::dynamics
