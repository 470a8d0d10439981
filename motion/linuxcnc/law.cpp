#include "motion/linuxcnc/law.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace gsim::motion::linuxcnc {

namespace {

double distance(const LawSection& section, double t_s) {
    return t_s * (section.v0 + t_s * (section.a0 / 2 + t_s * section.jerk / 6));
}

double speed(const LawSection& section, double t_s) {
    return std::max(0.0, section.v0 + t_s * (section.a0 + t_s * section.jerk / 2));
}

// The jerk is not 0 here. Bisection works because distances only grow.
double bisect_time(const LawSection& section, double length) {
    constexpr int kSteps = 60;
    double low = 0, high = section.duration_s;
    for (int i = 0; i < kSteps; ++i) {
        const double middle = (low + high) / 2;
        (distance(section, middle) < length ? low : high) = middle;
    }
    return high;
}

// Returns the time that the part needs for a distance within it, in the form without cancellation.
double time_for(const LawSection& section, double length) {
    if (section.jerk != 0) return bisect_time(section, length);
    const double square = std::max(0.0, section.v0 * section.v0 + 2 * section.a0 * length);
    const double sum = section.v0 + std::sqrt(square);
    return sum > 0 ? std::clamp(2 * length / sum, 0.0, section.duration_s) : 0;
}

}  // namespace

void Law::add(double duration_s, double speed_before, double acceleration, double jerk) {
    if (!(duration_s > 0)) return;
    LawSection& section = sections_[count_++];
    section = {duration_s, length_, speed_before, acceleration, jerk};
    length_ += std::max(0.0, distance(section, duration_s));
    duration_s_ += duration_s;
    top_speed_ = std::max({top_speed_, speed_before, speed(section, duration_s)});
}

double Law::end_speed() const {
    return count_ > 0 ? speed(sections_[count_ - 1], sections_[count_ - 1].duration_s) : 0;
}

double Law::end_acceleration() const {
    if (count_ == 0) return 0;
    const LawSection& last = sections_[count_ - 1];
    return last.a0 + last.duration_s * last.jerk;
}

double Law::at(double t_s) const {
    for (const LawSection& section : std::span(sections_.data(), count_)) {
        if (t_s <= section.duration_s) return section.s0 + distance(section, std::max(t_s, 0.0));
        t_s -= section.duration_s;
    }
    return length_;
}

double Law::time_at(double length) const {
    double before_s = 0;
    for (const LawSection& section : std::span(sections_.data(), count_)) {
        const double end = section.s0 + distance(section, section.duration_s);
        if (length <= end) return before_s + time_for(section, length - section.s0);
        before_s += section.duration_s;
    }
    return duration_s_;
}

double Law::speed_at(double t_s) const {
    for (const LawSection& section : std::span(sections_.data(), count_)) {
        if (t_s <= section.duration_s) return speed(section, std::max(t_s, 0.0));
        t_s -= section.duration_s;
    }
    return 0;
}

void Law::append(const Law& other) {
    for (const LawSection& section : std::span(other.sections_.data(), other.count_))
        add(section.duration_s, section.v0, section.a0, section.jerk);
}

Law Law::part(double from_s, double to_s) const {
    Law part;
    double before_s = 0;
    for (const LawSection& section : std::span(sections_.data(), count_)) {
        const double from = std::max(from_s - before_s, 0.0);
        const double to = std::min(to_s - before_s, section.duration_s);
        part.add(to - from, speed(section, from), section.a0 + from * section.jerk, section.jerk);
        before_s += section.duration_s;
    }
    return part;
}

Law Law::over(double length) const {
    const double scale = length / length_;
    Law law;
    for (const LawSection& section : std::span(sections_.data(), count_))
        law.add(section.duration_s, section.v0 * scale, section.a0 * scale, section.jerk * scale);
    return law;
}

Law Law::shortened(double earlier_s) const {
    std::size_t last = count_ - 1;
    while (last > 0 && earlier_s > sections_[last].duration_s / 2) earlier_s -= sections_[last--].duration_s;
    Law law;
    for (const LawSection& section : std::span(sections_.data(), last))
        law.add(section.duration_s, section.v0, section.a0, section.jerk);
    const LawSection& stop = sections_[last];
    const double stop_s = stop.duration_s - earlier_s;
    law.add(stop_s, stop.v0, stop.a0, -2 * (stop.v0 + stop.a0 * stop_s) / (stop_s * stop_s));
    return law.over(length_);
}

TimeLaw Law::scaled(double scale) const {
    std::array<LawSection, TimeLaw::kMaxSections> scaled;
    for (std::size_t i = 0; i < count_; ++i) {
        const LawSection& section = sections_[i];
        scaled[i] = {section.duration_s, section.s0 * scale, section.v0 * scale, section.a0 * scale,
                     section.jerk * scale};
    }
    return TimeLaw::from_sections({scaled.data(), count_});
}

}  // namespace gsim::motion::linuxcnc
