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
    explicit Connections(std::size_t most) : most_(most) {}

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
        void admit();
        /// Marks the response as complete: the connection may be ended like waiting ones if others need its
        /// slot.
        void finish();

      private:
        Connections& all_;
        std::list<Waiting>::iterator place_;
        bool admitted_ = false;
    };

    /// Waits until a further connection fits. False: end() has been called.
    bool make_room();
    /// Counts a further connection; each needs gone() at its end.
    void came();
    void gone();
    /// Ends waiting connections and admits no further one. Returns after all have ended.
    void end();

  private:
    void end_waiting();

    std::size_t most_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::size_t count_ = 0;
    bool ended_ = false;
    std::list<Waiting> waiting_;   // those without a complete request, or already served: the oldest first
    std::list<Waiting> admitted_;  // the others
};

/// Thread for each connection, as cpp-httplib requires.
class ConnectionThreads final : public httplib::TaskQueue {
  public:
    explicit ConnectionThreads(Connections& connections) : connections_(connections) {}
    void enqueue(std::function<void()> answer) override;
    void shutdown() override { connections_.end(); }

  private:
    Connections& connections_;
};

}  // namespace gsim::studio
