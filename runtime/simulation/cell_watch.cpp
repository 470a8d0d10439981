#include "runtime/simulation/cell_watch.h"

#include <algorithm>
#include <utility>

namespace gsim::simulation {

using rrs::Status;

namespace {

constexpr std::size_t kMaxListed = 100'000;

std::array<double, 3> array_of(const Eigen::Vector3d& point) {
    return {point.x(), point.y(), point.z()};
}

}  // namespace

CellWatch::CellWatch(cell::Cell cell, const machine::Machine& machine)
    : cell_(std::move(cell)), watch_(cell_, machine) {
    findings_.name = cell_.name;
    findings_.clearance_mm = cell_.clearance_mm;
}

Status CellWatch::get_frame(std::string_view name, rrs::CartPos& frame) const {
    const auto found = cell_.frames.find(name);
    if (!found) return Status::RRS_UNKNOWN_FRAME;
    frame = cell_.frames.in_parent(*found);
    return Status::RRS_SUCCESS;
}

Status CellWatch::move_frame(std::string_view name, const rrs::CartPos& frame) {
    const auto found = cell_.frames.find(name);
    if (!found) return Status::RRS_UNKNOWN_FRAME;
    if (cell_.frames.is_of_machine(*found)) return Status::RRS_INVALID_PARAMETER;
    cell_.frames.move(*found, frame);
    watch_.frames_changed();
    return Status::RRS_SUCCESS;
}

void CellWatch::take(const motion::Segment& segment, const MoveInfo& info) {
    const bool goes_on = block_ && block_->file == info.place.file && block_->line == info.place.line;
    if (!goes_on) end_block();
    block_ = info.place;
    watch_.take(segment, info.jet_on);
    places_.resize(watch_.contacts().size(), info.place);
}

void CellWatch::end_block() {
    const auto& nearest = watch_.nearest();
    if (block_ && nearest) {
        if (findings_.clearances.size() < kMaxListed) {
            findings_.clearances.push_back(
                {*block_, nearest->distance_mm, cell_.items[nearest->pair.first].name,
                 cell_.items[nearest->pair.second].name, array_of(nearest->point_mm)});
        } else {
            ++findings_.dropped;
        }
    }
    watch_.begin_block();
}

void CellWatch::end(double /*end_s*/) {
    end_block();
    const std::vector<cell::Contact>& contacts = watch_.contacts();
    const std::size_t listed = std::min(contacts.size(), kMaxListed);
    findings_.dropped += contacts.size() - listed;
    findings_.collisions.reserve(listed);
    for (std::size_t i = 0; i < listed; ++i) {
        findings_.collisions.push_back({contacts[i].t_s, places_[i], cell_.items[contacts[i].pair.first].name,
                                        cell_.items[contacts[i].pair.second].name,
                                        array_of(contacts[i].point_mm), contacts[i].penetrating});
    }
    std::stable_sort(findings_.collisions.begin(), findings_.collisions.end(),
                     [](const Collision& a, const Collision& b) { return a.t_s < b.t_s; });
}

}  // namespace gsim::simulation
