#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <list>
#include <mutex>

#include <httplib.h>

namespace gsim::studio {

/// All connections that are open, so that those which ask for nothing do not keep others out: where there is
/// no room for a further one, those that have waited for a while without a whole request are ended, and the
/// one that has waited longest in any case.
class Connections {
  public:
    explicit Connections(std::size_t most) : most_(most) {}

    struct Waiting {
        int socket;
        std::chrono::steady_clock::time_point since;
    };

    /// One of them, from its beginning to its end.
    class Entry {
      public:
        Entry(Connections& all, int socket);
        Entry(const Entry&) = delete;
        Entry& operator=(const Entry&) = delete;
        ~Entry();
        /// It has asked for something that is answered: it stays.
        void admit();
        /// It has its answer, and is ended as those that wait where there is no room for others.
        void finish();

      private:
        Connections& all_;
        std::list<Waiting>::iterator place_;
        bool admitted_ = false;
    };

    /// Waits until there is room for a further one. False: end() has been called.
    bool make_room();
    /// Counts a further one; each needs gone() at its end.
    void came();
    void gone();
    /// Ends those that wait, and no further one comes. Returns when all have gone.
    void end();

  private:
    void end_waiting();

    std::size_t most_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::size_t count_ = 0;
    bool ended_ = false;
    std::list<Waiting> waiting_;   // those without a whole request, or answered: the oldest first
    std::list<Waiting> admitted_;  // the others
};

/// A thread for each connection, as cpp-httplib asks for one.
class ConnectionThreads final : public httplib::TaskQueue {
  public:
    explicit ConnectionThreads(Connections& connections) : connections_(connections) {}
    void enqueue(std::function<void()> answer) override;
    void shutdown() override { connections_.end(); }

  private:
    Connections& connections_;
};

}  // namespace gsim::studio
