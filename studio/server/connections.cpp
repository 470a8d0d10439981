#include "studio/server/connections.h"

#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#include <sys/socket.h>

namespace gsim::studio {

namespace {

/// Interval of checks for closed connections.
constexpr std::chrono::milliseconds kPollInterval{50};
/// A complete request of a page takes less.
constexpr std::chrono::milliseconds kMinIdleTime{500};

}  // namespace

Connections::Entry::Entry(Connections& all, int socket) : all_(all) {
    const std::lock_guard lock(all_.mutex_);
    entry_position_ = all_.pending_.insert(all_.pending_.end(), {socket, std::chrono::steady_clock::now()});
}

Connections::Entry::~Entry() {
    const std::lock_guard lock(all_.mutex_);
    (accepted_ ? all_.accepted_ : all_.pending_).erase(entry_position_);
}

void Connections::Entry::accept_request() {
    const std::lock_guard lock(all_.mutex_);
    all_.accepted_.splice(all_.accepted_.end(), all_.pending_, entry_position_);
    accepted_ = true;
}

void Connections::Entry::finish() {
    const std::lock_guard lock(all_.mutex_);
    entry_position_->since = std::chrono::steady_clock::now();
    all_.pending_.splice(all_.pending_.end(), accepted_ ? all_.accepted_ : all_.pending_, entry_position_);
    accepted_ = false;
}

// The threads of the connections notice it, and close them.
void Connections::close_idle() {
    const auto late = std::chrono::steady_clock::now() - kMinIdleTime;
    for (const Waiting& each : pending_) {
        if (&each != &pending_.front() && each.since > late) break;
        ::shutdown(each.socket, SHUT_RDWR);
    }
}

bool Connections::wait_for_capacity() {
    std::unique_lock lock(mutex_);
    while (count_ >= max_connections_ && !ended_) {
        close_idle();
        change_signal_.wait_for(lock, kPollInterval);
    }
    return !ended_;
}

void Connections::on_open() {
    const std::lock_guard lock(mutex_);
    ++count_;
}

void Connections::on_close() {
    const std::lock_guard lock(mutex_);
    --count_;
    change_signal_.notify_all();
}

void Connections::end() {
    std::unique_lock lock(mutex_);
    ended_ = true;
    for (const std::list<Waiting>* all : {&pending_, &accepted_}) {
        for (const Waiting& each : *all) ::shutdown(each.socket, SHUT_RDWR);
    }
    change_signal_.wait(lock, [this] { return count_ == 0; });
}

void ConnectionThreads::enqueue(std::function<void()> task) {
    connections_.wait_for_capacity();
    connections_.on_open();
    try {
        std::thread([this, task] {
            task();
            connections_.on_close();
        }).detach();
    } catch (const std::system_error&) {
        // If no further thread is available, this thread handles the connection.
        task();
        connections_.on_close();
    }
}

}  // namespace gsim::studio
