#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include <signal.h>

namespace gsim::os {

/// From here on the signals that end a program (SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU) remove
/// the files of all TemporaryNames first; the program still ends by the signal. Those that were ignored stay
/// so. A file that outgrows `ulimit -f` becomes an error of writing. For main() alone, once.
void remove_temporaries_at_signals();

/// Removes the files of all TemporaryNames that there are after remove_temporaries_at_signals(), for who ends
/// the program without leaving its functions. May be called where a signal is handled.
void remove_temporaries();

/// What SIGXCPU means from here on: null, what it always does; else this is written to standard error, and
/// the program ends with `status`. The text must stay.
void end_at_cpu_signal(const char* last_words, int status);

/// Keeps those signals back as long as it lives, in this thread.
class SignalsHeld {
  public:
    SignalsHeld();
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;
    ~SignalsHeld();

  private:
    sigset_t before_;
};

/// A file that is to be gone when this is, however the program ends but by SIGKILL or a crash. Create the
/// file and this one under one SignalsHeld; its name is made before, so that nothing can fail in between.
class TemporaryName {
  public:
    using Kept = std::unique_ptr<const std::string>;
    static Kept kept(const std::filesystem::path& file);

    TemporaryName() = default;
    explicit TemporaryName(Kept name) noexcept;
    TemporaryName(TemporaryName&&) noexcept = default;
    TemporaryName& operator=(TemporaryName&&) = delete;
    ~TemporaryName();

    /// Of one that is empty: takes over another's file.
    void take(TemporaryName&& other) { name_ = std::move(other.name_); }

    bool empty() const { return name_ == nullptr; }
    const std::string& name() const { return *name_; }
    /// The file is there no more, or is to stay.
    void release();

  private:
    Kept name_;  // a handler reads it where it lies
};

}  // namespace gsim::os
