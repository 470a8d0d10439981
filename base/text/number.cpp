#include "base/text/number.h"

#include <fmt/format.h>

namespace gsim::text {

std::string fixed(double value, int decimals) {
    return std::string(unsigned_zero(std::string_view(fmt::format("{:.{}f}", value, decimals))));
}

}  // namespace gsim::text
