#include "runtime/processes/schedule.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace gsim::process {

namespace {

bool is_met_by(const Wait& wait, const std::string& signal, const Value& before, const Value& after) {
    if (wait.kind == WaitKind::any_change) return true;
    if (wait.kind == WaitKind::zone) return false;  // wake()
    if (wait.signal != signal) return false;
    if (wait.kind == WaitKind::rises) return !is_on(before) && is_on(after);
    if (wait.kind == WaitKind::falls) return is_on(before) && !is_on(after);
    return is_met(wait, after);
}

}  // namespace

bool is_met(const Wait& wait, const Value& value) {
    switch (wait.kind) {
        case WaitKind::on: return is_on(value);
        case WaitKind::off: return !is_on(value);
        case WaitKind::equals: return same(value, wait.value);
        default: return false;
    }
}

ProcessId Schedule::add(std::string name, bool background, double start_s,
                        const simulation::SourceLocation& location) {
    processes_.push_back({.name = std::move(name),
                          .background = background,
                          .start_s = start_s,
                          .time_s = start_s,
                          .location = location});
    return processes_.size() - 1;
}

std::optional<double> Schedule::due_time_s(const Process& process) {
    if (process.state == ProcessState::ready) return process.time_s;
    if (process.state == ProcessState::waiting) return process.wait.until_s;
    return std::nullopt;
}

double Schedule::next_action_s(ProcessId id) const {
    return due_time_s(processes_[id]).value_or(std::numeric_limits<double>::infinity());
}

bool Schedule::has_unfinished() const {
    return std::any_of(processes_.begin(), processes_.end(), [](const Process& process) {
        return !process.background && process.state != ProcessState::done;
    });
}

std::optional<ProcessId> Schedule::next() const {
    std::optional<ProcessId> found;
    double min_s = 0;
    for (ProcessId id = 0; id < processes_.size(); ++id) {
        const std::optional<double> time_s = due_time_s(processes_[id]);
        if (!time_s || (found && *time_s >= min_s)) continue;
        found = id;
        min_s = *time_s;
    }
    return found;
}

std::optional<ProcessId> Schedule::activate_next() {
    if (!has_unfinished()) return std::nullopt;
    const std::optional<ProcessId> id = next();
    if (!id) return id;
    Process& process = processes_[*id];
    process.timed_out = process.state == ProcessState::waiting;
    if (process.timed_out) process.time_s = std::max(process.time_s, *process.wait.until_s);
    process.state = ProcessState::ready;
    return id;
}

void Schedule::wait(ProcessId id, Wait wait) {
    processes_[id].wait = std::move(wait);
    processes_[id].state = ProcessState::waiting;
}

void Schedule::changed(const std::string& signal, const Value& before, const Value& after, double time_s) {
    for (Process& process : processes_) {
        if (process.state != ProcessState::waiting || !is_met_by(process.wait, signal, before, after))
            continue;
        process.state = ProcessState::ready;
        process.time_s = std::max(process.time_s, time_s);
    }
}

void Schedule::finish(ProcessId id) {
    processes_[id].state = ProcessState::done;
}

void Schedule::wake(ProcessId id, double time_s) {
    processes_[id].state = ProcessState::ready;
    processes_[id].time_s = std::max(processes_[id].time_s, time_s);
}

std::vector<ProcessId> Schedule::deadlocked_from(ProcessId id) const {
    std::vector<ProcessId> chain;
    for (ProcessId at = id; chain.size() < processes_.size();) {
        const Process& process = processes_[at];
        if (process.state == ProcessState::done) return chain;
        if (process.state != ProcessState::waiting || !process.wait.holder) return {};
        chain.push_back(at);
        at = *process.wait.holder;
        if (at == id) return chain;
    }
    return {};
}

std::optional<ProcessId> Schedule::find_zone_waiter(ProcessId id) const {
    for (ProcessId at = 0; at < processes_.size(); ++at) {
        const Process& process = processes_[at];
        if (process.state == ProcessState::waiting && process.wait.kind == WaitKind::zone &&
            process.wait.holder == id)
            return at;
    }
    return std::nullopt;
}

bool Schedule::any_waits_for_zone() const {
    return std::any_of(processes_.begin(), processes_.end(), [](const Process& process) {
        return process.state == ProcessState::waiting && process.wait.kind == WaitKind::zone;
    });
}

std::string Schedule::wait_text(const Wait& wait) const {
    switch (wait.kind) {
        case WaitKind::on: return fmt::format("'{}' to be on", wait.signal);
        case WaitKind::off: return fmt::format("'{}' to be off", wait.signal);
        case WaitKind::equals: return fmt::format("'{}' to be {}", wait.signal, value_text(wait.value));
        case WaitKind::rises: return fmt::format("'{}' to switch on", wait.signal);
        case WaitKind::falls: return fmt::format("'{}' to switch off", wait.signal);
        case WaitKind::zone: {
            const Process& holder = processes_[*wait.holder];
            return fmt::format("the zone '{}', which '{}' occupies{}", wait.signal, holder.name,
                               holder.state == ProcessState::done ? ", although it has ended" : "");
        }
        case WaitKind::any_change: break;
    }
    return "a user-defined condition";
}

std::string Schedule::waits(const std::vector<std::string>& files) const {
    std::vector<ProcessId> all;
    for (ProcessId id = 0; id < processes_.size(); ++id) {
        if (processes_[id].state == ProcessState::waiting) all.push_back(id);
    }
    return waits(files, all);
}

std::string Schedule::waits(const std::vector<std::string>& files, std::span<const ProcessId> of) const {
    std::string list;
    for (const ProcessId id : of) {
        const Process& process = processes_[id];
        const simulation::SourceLocation& location = process.location;
        const std::string where = location.line > 0 && location.file < files.size()
                                      ? fmt::format(" ({}:{})", files[location.file], location.line)
                                      : "";
        list += fmt::format("{}'{}'{} waits for {}", list.empty() ? "" : ", ", process.name, where,
                            wait_text(process.wait));
    }
    return list;
}

}  // namespace gsim::process
