#include "cli/progress.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

namespace gsim::apps {

namespace {

constexpr std::size_t kProgressBarWidth = 40;
constexpr auto kUpdateInterval = std::chrono::milliseconds(100);

}  // namespace

Progress::Progress(std::FILE* stream) : Progress(stream, ::isatty(::fileno(stream)) == 1) {}

void Progress::update(std::uint64_t done, std::uint64_t total) {
    if (!enabled_) return;
    const Clock::time_point now = Clock::now();
    if (now < next_) return;
    next_ = now + kUpdateInterval;
    draw(done, total);
}

void Progress::draw(std::uint64_t done, std::uint64_t total) {
    is_drawn_ = true;
    std::string text = fmt::format("\r{} blocks", done);
    if (total != 0) {
        const double share = std::min(1.0, static_cast<double>(done) / static_cast<double>(total));
        const auto filled = static_cast<std::size_t>(share * static_cast<double>(kProgressBarWidth));
        text = fmt::format("\r[{}{}] {:3.0f} %", std::string(filled, '='),
                           std::string(kProgressBarWidth - filled, ' '), 100 * share);
    }
    std::fputs(text.c_str(), stream_);
    std::fflush(stream_);
}

void Progress::clear() {
    if (!is_drawn_) return;
    std::fputs("\r\x1b[K", stream_);
    std::fflush(stream_);
    is_drawn_ = false;
}

}  // namespace gsim::apps
