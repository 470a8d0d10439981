#include "runtime/monitors/cell_findings.h"

#include <algorithm>
#include <utility>

namespace gsim::simulation {

namespace {

constexpr std::size_t kMaxListed = 100'000;

template <typename Entry>
bool append_entry(std::vector<Entry>& entries, Entry entry, std::uint64_t& dropped) {
    if (entries.size() >= kMaxListed) {
        ++dropped;
        return false;
    }
    entries.push_back(std::move(entry));
    return true;
}

}  // namespace

bool list(CellFindings& findings, Collision collision) {
    return append_entry(findings.collisions, std::move(collision), findings.dropped);
}

bool list(CellFindings& findings, BlockClearance clearance) {
    return append_entry(findings.clearances, std::move(clearance), findings.dropped);
}

void sort_by_time(CellFindings& findings) {
    std::stable_sort(findings.collisions.begin(), findings.collisions.end(),
                     [](const Collision& a, const Collision& b) { return a.t_s < b.t_s; });
}

}  // namespace gsim::simulation
