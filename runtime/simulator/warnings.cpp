#include "runtime/simulator/warnings.h"

#include <algorithm>

namespace gsim::simulation {

namespace {

constexpr std::size_t kMaxWarnings = 1'000;

}  // namespace

void Warnings::add(const std::string& text) {
    if (texts_.size() < kMaxWarnings && std::find(texts_.begin(), texts_.end(), text) == texts_.end()) {
        texts_.push_back(text);
    }
}

}  // namespace gsim::simulation
