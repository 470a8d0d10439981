#include "batch/work/worker_pool.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/os/spawn.h"
#include "base/text/json.h"
#include "batch/work/worker.h"

namespace gsim::batch {

namespace {

using Fault = tl::unexpected<std::string>;

constexpr std::size_t kDepth = 2;  // one is run, the next one waits
constexpr int kMostTries = 3;
constexpr std::size_t kPiece = std::size_t{64} << 10U;

std::string reason(int error) {
    return std::generic_category().message(error);
}

tl::expected<std::pair<os::Descriptor, os::Descriptor>, std::string> make_pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return Fault("no pipe: " + reason(errno));
    return std::pair(os::Descriptor(ends[0]), os::Descriptor(ends[1]));
}

/// Returns true if another process (a cluster, an administrator, the system if memory is short) ended the
/// worker: the job need not be the cause.
bool was_ended_from_outside(int status) {
    if (!WIFSIGNALED(status)) return false;
    const int signal = WTERMSIG(status);
    return signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP;
}

/// Returns the row of a job during which its worker ended.
RunRow row_of_end(const Job& job, int status, bool timed_out, double timeout_s) {
    RunRow row{.number = job.number};
    row.file = job.program;
    if (timed_out) {
        row.status = row.cause = "timeout";
        row.message = fmt::format("it was ended after {} s", timeout_s);
    } else if (WIFEXITED(status) && WEXITSTATUS(status) == kOutOfMemory) {
        row.status = row.cause = "memory";
        row.message = "it needs more memory than it may have";
    } else {
        row.status = row.cause = "crashed";
        row.message = WIFSIGNALED(status)
                          ? fmt::format("its process was ended by signal {}", WTERMSIG(status))
                          : fmt::format("its process ended with status {}", WEXITSTATUS(status));
    }
    row.findings = nlohmann::json::array({{{"severity", "error"},
                                           {"code", row.cause},
                                           {"file", job.program},
                                           {"line", nullptr},
                                           {"column", nullptr},
                                           {"end_column", nullptr},
                                           {"text", row.message},
                                           {"hint", nullptr}}})
                       .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    row.extents = "{}";
    return row;
}

}  // namespace

WorkerPool::WorkerPool(PoolOptions options) : options_(std::move(options)) {
    // An ended worker is detected by the end of its output, not by a signal to this process.
    std::signal(SIGPIPE, SIG_IGN);
    // This process has two open pipes for each worker.
    rlimit open{};
    if (::getrlimit(RLIMIT_NOFILE, &open) == 0) {
        open.rlim_cur = open.rlim_max;
        ::setrlimit(RLIMIT_NOFILE, &open);
    }
}

WorkerPool::~WorkerPool() {
    for (Worker& worker : workers_) {
        if (!worker.jobs.empty()) ::kill(worker.child, SIGKILL);
        worker.input.close();
    }
    for (const Worker& worker : workers_) os::wait_for(worker.child);
}

bool WorkerPool::has_room() const {
    return workers_.size() < options_.workers ||
           std::any_of(workers_.begin(), workers_.end(),
                       [](const Worker& worker) { return worker.jobs.size() < kDepth; });
}

std::size_t WorkerPool::in_work() const {
    std::size_t count = 0;
    for (const Worker& worker : workers_) count += worker.jobs.size();
    return count;
}

tl::expected<void, std::string> WorkerPool::begin_worker() {
    auto jobs = make_pipe();
    auto rows = make_pipe();
    if (!jobs || !rows) return Fault(jobs ? rows.error() : jobs.error());
    os::SpawnActions actions;
    actions.redirect(jobs->first.number(), STDIN_FILENO);
    actions.redirect(rows->second.number(), STDOUT_FILENO);
    // Signals of a terminal that end this program are handled here, not in the worker.
    const auto child = os::spawn(options_.command, actions, os::ProcessGroup::own);
    if (!child) return Fault(fmt::format("cannot run {}: {}", options_.command[0], reason(child.error())));
    for (const int ours : {jobs->second.number(), rows->first.number()})
        ::fcntl(ours, F_SETFL, ::fcntl(ours, F_GETFL) | O_NONBLOCK);
    workers_.push_back({.child = *child, .input = std::move(jobs->second), .output = std::move(rows->first)});
    return {};
}

tl::expected<void, std::string> WorkerPool::give(Job job) {
    return give_again({.job = std::move(job)});
}

tl::expected<void, std::string> WorkerPool::give_again(Given given) {
    const auto least = [](const Worker& a, const Worker& b) { return a.jobs.size() < b.jobs.size(); };
    auto worker = std::min_element(workers_.begin(), workers_.end(), least);
    if (worker == workers_.end() || (!worker->jobs.empty() && workers_.size() < options_.workers)) {
        if (auto begun = begin_worker(); !begun) return begun;
        worker = std::prev(workers_.end());
    }
    if (worker->jobs.empty()) worker->begun = Clock::now();
    worker->unsent += print_job(given.job) + '\n';
    worker->jobs.push_back(std::move(given));
    send(*worker);
    return {};
}

void WorkerPool::send(Worker& worker) {
    while (!worker.unsent.empty()) {
        const ssize_t sent = ::write(worker.input.number(), worker.unsent.data(), worker.unsent.size());
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0) return;  // it reads later, or is gone, which its output shows
        worker.unsent.erase(0, static_cast<std::size_t>(sent));
    }
}

bool WorkerPool::receive(Worker& worker, std::vector<RunRow>& rows) {
    std::array<char, kPiece> piece{};
    const ssize_t got = ::read(worker.output.number(), piece.data(), piece.size());
    if (got < 0) return errno == EAGAIN || errno == EINTR;
    if (got == 0) return false;
    worker.received.append(piece.data(), static_cast<std::size_t>(got));
    std::size_t begin = 0;
    for (std::size_t end = 0; (end = worker.received.find('\n', begin)) != std::string::npos;
         begin = end + 1) {
        auto row = read_row(std::string_view(worker.received).substr(begin, end - begin));
        // A row that is not for the front job comes from a worker in an invalid state.
        if (!row || worker.jobs.empty() || row->number != worker.jobs.front().job.number) return false;
        rows.push_back(*std::move(row));
        worker.jobs.pop_front();
        worker.has_answered = true;
        worker.begun = Clock::now();
    }
    worker.received.erase(0, begin);
    return true;
}

/// Handles a worker that has ended: its job gets a row, and pending jobs get another worker.
tl::expected<void, std::string> WorkerPool::bury(std::list<Worker>::iterator worker,
                                                 std::vector<RunRow>& rows) {
    ::kill(worker->child, SIGKILL);
    const int status = os::wait_for(worker->child).value_or(0);
    std::deque<Given> jobs = std::move(worker->jobs);
    const bool timed_out = worker->timed_out;
    // An earlier run may have damaged the process, so the job is tried once more.
    const bool may_be_anothers = worker->has_answered && !jobs.empty() && jobs.front().tries == 0;
    workers_.erase(worker);
    if (jobs.empty()) return {};
    if (timed_out || !(may_be_anothers || was_ended_from_outside(status)) ||
        ++jobs.front().tries == kMostTries) {
        rows.push_back(row_of_end(jobs.front().job, status, timed_out, options_.timeout_s));
        jobs.pop_front();
    }
    for (Given& job : jobs) {
        if (auto given = give_again(std::move(job)); !given) return given;
    }
    return {};
}

void WorkerPool::kill_if_late(Worker& worker) const {
    const std::chrono::duration<double> longest(options_.timeout_s);
    if (worker.jobs.empty() || worker.timed_out || Clock::now() - worker.begun < longest) return;
    worker.timed_out = true;
    ::kill(worker.child, SIGKILL);
}

std::chrono::milliseconds WorkerPool::until_timeout(std::chrono::milliseconds longest) const {
    const auto timeout =
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options_.timeout_s));
    for (const Worker& worker : workers_) {
        if (worker.jobs.empty() || worker.timed_out) continue;
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(worker.begun + timeout - Clock::now());
        longest = std::clamp(left, std::chrono::milliseconds(0), longest);
    }
    return longest;
}

tl::expected<std::vector<RunRow>, std::string> WorkerPool::take(std::chrono::milliseconds longest_wait) {
    std::vector<pollfd> asked;
    for (const Worker& worker : workers_) {
        asked.push_back({worker.output.number(), POLLIN, 0});
        if (!worker.unsent.empty()) asked.push_back({worker.input.number(), POLLOUT, 0});
    }
    ::poll(asked.data(), asked.size(), static_cast<int>(until_timeout(longest_wait).count()));
    std::vector<RunRow> rows;
    for (auto worker = workers_.begin(); worker != workers_.end();) {
        const auto next = std::next(worker);
        send(*worker);
        const bool goes_on = receive(*worker, rows);
        kill_if_late(*worker);
        // A child process of a run may keep the output of a killed worker open.
        if (worker->timed_out || !goes_on) {
            if (auto buried = bury(worker, rows); !buried) return Fault(buried.error());
        }
        worker = next;
    }
    return rows;
}

}  // namespace gsim::batch
