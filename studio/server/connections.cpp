#include "studio/server/connections.h"

#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#include <sys/socket.h>

namespace gsim::studio {

namespace {

/// Interval of checks for closed connections.
constexpr std::chrono::milliseconds kLook{50};
/// A complete request of a page takes less.
constexpr std::chrono::milliseconds kWhile{500};

}  // namespace

Connections::Entry::Entry(Connections& all, int socket) : all_(all) {
    const std::lock_guard lock(all_.mutex_);
    place_ = all_.waiting_.insert(all_.waiting_.end(), {socket, std::chrono::steady_clock::now()});
}

Connections::Entry::~Entry() {
    const std::lock_guard lock(all_.mutex_);
    (admitted_ ? all_.admitted_ : all_.waiting_).erase(place_);
}

void Connections::Entry::admit() {
    const std::lock_guard lock(all_.mutex_);
    all_.admitted_.splice(all_.admitted_.end(), all_.waiting_, place_);
    admitted_ = true;
}

void Connections::Entry::finish() {
    const std::lock_guard lock(all_.mutex_);
    place_->since = std::chrono::steady_clock::now();
    all_.waiting_.splice(all_.waiting_.end(), admitted_ ? all_.admitted_ : all_.waiting_, place_);
    admitted_ = false;
}

// The threads of the connections notice it, and close them.
void Connections::end_waiting() {
    const auto late = std::chrono::steady_clock::now() - kWhile;
    for (const Waiting& each : waiting_) {
        if (&each != &waiting_.front() && each.since > late) break;
        ::shutdown(each.socket, SHUT_RDWR);
    }
}

bool Connections::make_room() {
    std::unique_lock lock(mutex_);
    while (count_ >= most_ && !ended_) {
        end_waiting();
        changed_.wait_for(lock, kLook);
    }
    return !ended_;
}

void Connections::came() {
    const std::lock_guard lock(mutex_);
    ++count_;
}

void Connections::gone() {
    const std::lock_guard lock(mutex_);
    --count_;
    changed_.notify_all();
}

void Connections::end() {
    std::unique_lock lock(mutex_);
    ended_ = true;
    for (const std::list<Waiting>* all : {&waiting_, &admitted_}) {
        for (const Waiting& each : *all) ::shutdown(each.socket, SHUT_RDWR);
    }
    changed_.wait(lock, [this] { return count_ == 0; });
}

void ConnectionThreads::enqueue(std::function<void()> answer) {
    connections_.make_room();
    connections_.came();
    try {
        std::thread([this, answer] {
            answer();
            connections_.gone();
        }).detach();
    } catch (const std::system_error&) {
        // If no further thread is available, this thread handles the connection.
        answer();
        connections_.gone();
    }
}

}  // namespace gsim::studio
