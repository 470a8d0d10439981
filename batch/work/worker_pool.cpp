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

constexpr std::size_t kQueueDepth = 2;  // one is run, the next one waits
constexpr int kMaxAttempts = 3;
constexpr std::size_t kChunkBytes = std::size_t{64} << 10U;

std::string system_message(int error) {
    return std::generic_category().message(error);
}

Result<std::pair<os::Descriptor, os::Descriptor>> make_pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        return Unexpected("cannot create a pipe: " + system_message(errno));
    return std::pair(os::Descriptor(ends[0]), os::Descriptor(ends[1]));
}

/// Returns true if another process (a cluster, an administrator, the system if memory is short) ended the
/// worker: the job need not be the cause.
bool was_killed_externally(int status) {
    if (!WIFSIGNALED(status)) return false;
    const int signal = WTERMSIG(status);
    return signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP;
}

/// Returns the row of a job during which its worker ended.
RunRow failure_row(const Job& job, int status, bool timed_out, double timeout_s) {
    RunRow row{.number = job.number};
    row.outcome.file = job.program;
    if (timed_out) {
        row.outcome.status = row.outcome.cause = "timeout";
        row.outcome.message = fmt::format("it was terminated after {} s", timeout_s);
    } else if (WIFEXITED(status) && WEXITSTATUS(status) == kOutOfMemory) {
        row.outcome.status = row.outcome.cause = "memory";
        row.outcome.message = "it exceeded the memory limit";
    } else {
        row.outcome.status = row.outcome.cause = "crashed";
        row.outcome.message = WIFSIGNALED(status)
                                  ? fmt::format("its process was terminated by signal {}", WTERMSIG(status))
                                  : fmt::format("its process ended with status {}", WEXITSTATUS(status));
    }
    row.findings = nlohmann::json::array({{{"severity", "error"},
                                           {"code", row.outcome.cause},
                                           {"file", job.program},
                                           {"line", nullptr},
                                           {"column", nullptr},
                                           {"end_column", nullptr},
                                           {"text", row.outcome.message},
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

bool WorkerPool::has_capacity() const {
    return workers_.size() < options_.workers ||
           std::any_of(workers_.begin(), workers_.end(),
                       [](const Worker& worker) { return worker.jobs.size() < kQueueDepth; });
}

std::size_t WorkerPool::pending_count() const {
    std::size_t count = 0;
    for (const Worker& worker : workers_) count += worker.jobs.size();
    return count;
}

Result<void> WorkerPool::start_worker() {
    auto jobs = make_pipe();
    auto rows = make_pipe();
    if (!jobs || !rows) return Unexpected(jobs ? rows.error().message : jobs.error().message);
    os::SpawnActions actions;
    actions.redirect(jobs->first.number(), STDIN_FILENO);
    actions.redirect(rows->second.number(), STDOUT_FILENO);
    // Signals of a terminal that end this program are handled here, not in the worker.
    const auto child = os::spawn(options_.command, actions, os::ProcessGroup::separate);
    if (!child)
        return Unexpected(
            fmt::format("cannot run {}: {}", options_.command[0], system_message(child.error())));
    for (const int parent_end : {jobs->second.number(), rows->first.number()})
        ::fcntl(parent_end, F_SETFL, ::fcntl(parent_end, F_GETFL) | O_NONBLOCK);
    workers_.push_back({.child = *child, .input = std::move(jobs->second), .output = std::move(rows->first)});
    return {};
}

Result<void> WorkerPool::submit(Job job) {
    return enqueue({.job = std::move(job)});
}

Result<void> WorkerPool::enqueue(QueuedJob queued) {
    const auto has_fewer_jobs = [](const Worker& a, const Worker& b) {
        return a.jobs.size() < b.jobs.size();
    };
    auto worker = std::min_element(workers_.begin(), workers_.end(), has_fewer_jobs);
    if (worker == workers_.end() || (!worker->jobs.empty() && workers_.size() < options_.workers)) {
        if (auto start = start_worker(); !start) return start;
        worker = std::prev(workers_.end());
    }
    if (worker->jobs.empty()) worker->start = Clock::now();
    worker->unsent_text += print_job(queued.job) + '\n';
    worker->jobs.push_back(std::move(queued));
    send(*worker);
    return {};
}

void WorkerPool::send(Worker& worker) {
    while (!worker.unsent_text.empty()) {
        const ssize_t sent =
            ::write(worker.input.number(), worker.unsent_text.data(), worker.unsent_text.size());
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0) return;  // it reads later, or is gone, which its output shows
        worker.unsent_text.erase(0, static_cast<std::size_t>(sent));
    }
}

bool WorkerPool::receive(Worker& worker, std::vector<RunRow>& rows) {
    std::array<char, kChunkBytes> chunk{};
    const ssize_t bytes_read = ::read(worker.output.number(), chunk.data(), chunk.size());
    if (bytes_read < 0) return errno == EAGAIN || errno == EINTR;
    if (bytes_read == 0) return false;
    worker.received.append(chunk.data(), static_cast<std::size_t>(bytes_read));
    std::size_t begin = 0;
    for (std::size_t end = 0; (end = worker.received.find('\n', begin)) != std::string::npos;
         begin = end + 1) {
        auto row = read_row(std::string_view(worker.received).substr(begin, end - begin));
        // A row that is not for the front job comes from a worker in an invalid state.
        if (!row || worker.jobs.empty() || row->number != worker.jobs.front().job.number) return false;
        rows.push_back(*std::move(row));
        worker.jobs.pop_front();
        worker.has_finished_job = true;
        worker.start = Clock::now();
    }
    worker.received.erase(0, begin);
    return true;
}

/// Handles a worker that has ended: its job gets a row, and pending jobs get another worker.
Result<void> WorkerPool::remove_ended_worker(std::list<Worker>::iterator worker, std::vector<RunRow>& rows) {
    ::kill(worker->child, SIGKILL);
    const int status = os::wait_for(worker->child).value_or(0);
    std::deque<QueuedJob> jobs = std::move(worker->jobs);
    const bool timed_out = worker->timed_out;
    // An earlier run may have damaged the process, so the job is tried once more.
    const bool may_be_earlier_job =
        worker->has_finished_job && !jobs.empty() && jobs.front().killed_attempts == 0;
    workers_.erase(worker);
    if (jobs.empty()) return {};
    if (timed_out || !(may_be_earlier_job || was_killed_externally(status)) ||
        ++jobs.front().killed_attempts == kMaxAttempts) {
        rows.push_back(failure_row(jobs.front().job, status, timed_out, options_.timeout_s));
        jobs.pop_front();
    }
    for (QueuedJob& job : jobs) {
        if (auto queued = enqueue(std::move(job)); !queued) return queued;
    }
    return {};
}

void WorkerPool::kill_if_timed_out(Worker& worker) const {
    const std::chrono::duration<double> max_duration(options_.timeout_s);
    if (worker.jobs.empty() || worker.timed_out || Clock::now() - worker.start < max_duration) return;
    worker.timed_out = true;
    ::kill(worker.child, SIGKILL);
}

std::chrono::milliseconds WorkerPool::time_until_timeout(std::chrono::milliseconds max_duration) const {
    const auto timeout =
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options_.timeout_s));
    for (const Worker& worker : workers_) {
        if (worker.jobs.empty() || worker.timed_out) continue;
        const auto remaining =
            std::chrono::ceil<std::chrono::milliseconds>(worker.start + timeout - Clock::now());
        max_duration = std::clamp(remaining, std::chrono::milliseconds(0), max_duration);
    }
    return max_duration;
}

Result<std::vector<RunRow>> WorkerPool::collect(std::chrono::milliseconds max_wait) {
    std::vector<pollfd> descriptors;
    for (const Worker& worker : workers_) {
        descriptors.push_back({worker.output.number(), POLLIN, 0});
        if (!worker.unsent_text.empty()) descriptors.push_back({worker.input.number(), POLLOUT, 0});
    }
    ::poll(descriptors.data(), descriptors.size(), static_cast<int>(time_until_timeout(max_wait).count()));
    std::vector<RunRow> rows;
    for (auto worker = workers_.begin(); worker != workers_.end();) {
        const auto next = std::next(worker);
        send(*worker);
        const bool is_alive = receive(*worker, rows);
        kill_if_timed_out(*worker);
        // A child process of a run may keep the output of a killed worker open.
        if (worker->timed_out || !is_alive) {
            if (auto removed = remove_ended_worker(worker, rows); !removed)
                return Unexpected(removed.error());
        }
        worker = next;
    }
    return rows;
}

}  // namespace gsim::batch
