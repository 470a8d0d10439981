#include "tests/conformance/random_source.h"

#include <fmt/format.h>

namespace gsim::conformance {

std::string RandomSource::decimal(int min, int max) {
    switch (below(4)) {
        case 0: return std::to_string(between(min, max));
        case 1: return fmt::format("{:.1f}", between(min * 10, max * 10) / 10.0);
        case 2: return fmt::format("{:.2f}", between(min * 100, max * 100) / 100.0);
        default: return fmt::format("{:.3f}", between(min * 1000, max * 1000) / 1000.0);
    }
}

}  // namespace gsim::conformance
