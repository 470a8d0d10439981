#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <list>
#include <mutex>

#include <httplib.h>

namespace gsim::studio {

/// All open connections. Idle ones must not keep others out. If the limit is reached, those that have waited
/// for a while without a complete request are ended. The one that has waited longest is ended in any case.
class Connections {
  public:
    explicit Connections(std::size_t max) : max_connections_(max) {}

    struct Waiting {
        int socket;
        std::chrono::steady_clock::time_point since;
    };

    /// One connection, from its beginning to its end.
    class Entry {
      public:
        Entry(Connections& all, int socket);
        Entry(const Entry&) = delete;
        Entry& operator=(const Entry&) = delete;
        ~Entry();
        /// Marks the request as accepted: the connection stays open.
        void accept_request();
        /// Marks the response as complete: the connection may be ended like waiting ones if others need its
        /// slot.
        void finish();

      private:
        Connections& all_;
        std::list<Waiting>::iterator entry_position_;
        bool accepted_ = false;
    };

    /// Waits until a further connection fits. False: end() has been called.
    bool wait_for_capacity();
    /// Counts a further connection; each needs on_close() at its end.
    void on_open();
    void on_close();
    /// Ends waiting connections and admits no further one. Returns once all have ended.
    void end();

  private:
    void close_idle();

    std::size_t max_connections_;
    std::mutex mutex_;
    std::condition_variable change_signal_;
    std::size_t count_ = 0;
    bool ended_ = false;
    std::list<Waiting> pending_;   // those without a complete request, or already served: the oldest first
    std::list<Waiting> accepted_;  // the others
};

/// Thread for each connection, as cpp-httplib requires.
class ConnectionThreads final : public httplib::TaskQueue {
  public:
    explicit ConnectionThreads(Connections& connections) : connections_(connections) {}
    void enqueue(std::function<void()> task) override;
    void shutdown() override { connections_.end(); }

  private:
    Connections& connections_;
};

}  // namespace gsim::studio
