#include "tests/conformance/random_source.h"

#include <fmt/format.h>

namespace gsim::conformance {

std::string RandomSource::decimal(int least, int most) {
    switch (below(4)) {
        case 0: return std::to_string(between(least, most));
        case 1: return fmt::format("{:.1f}", between(least * 10, most * 10) / 10.0);
        case 2: return fmt::format("{:.2f}", between(least * 100, most * 100) / 100.0);
        default: return fmt::format("{:.3f}", between(least * 1000, most * 1000) / 1000.0);
    }
}

}  // namespace gsim::conformance
