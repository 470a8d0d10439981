#include "studio/server/rejection_log.h"

#include <fmt/format.h>

#include "base/text/printable.h"

namespace gsim::studio {

namespace {

constexpr std::size_t kMaxLinesPerSecond = 20;
constexpr std::size_t kMaxLineLength = 500;

}  // namespace

void RejectionLog::add(const std::string& line) {
    const std::lock_guard lock(mutex_);
    if (const auto now = Clock::now(); now - second_ > std::chrono::seconds(1)) {
        if (lines_in_second_ > kMaxLinesPerSecond)
            sink_(fmt::format("and {} more", lines_in_second_ - kMaxLinesPerSecond));
        second_ = now;
        lines_in_second_ = 0;
    }
    if (++lines_in_second_ <= kMaxLinesPerSecond) sink_(text::printable(line.substr(0, kMaxLineLength)));
}

}  // namespace gsim::studio
