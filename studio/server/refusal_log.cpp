#include "studio/server/refusal_log.h"

#include <fmt/format.h>

#include "base/text/printable.h"

namespace gsim::studio {

namespace {

constexpr std::size_t kMostInSecond = 20;
constexpr std::size_t kLongestLine = 500;

}  // namespace

void RefusalLog::add(const std::string& line) {
    const std::lock_guard lock(mutex_);
    if (const auto now = Clock::now(); now - second_ > std::chrono::seconds(1)) {
        if (in_second_ > kMostInSecond) sink_(fmt::format("and {} more", in_second_ - kMostInSecond));
        second_ = now;
        in_second_ = 0;
    }
    if (++in_second_ <= kMostInSecond) sink_(text::printable(line.substr(0, kLongestLine)));
}

}  // namespace gsim::studio
