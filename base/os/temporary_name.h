#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include <signal.h>

namespace gsim::os {

/// Makes the signals that end a program (SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU) remove the files
/// of all TemporaryNames first; the program still ends by the signal. Signals that were ignored stay so. A
/// file that exceeds `ulimit -f` becomes a write error. Only for main(), once.
void remove_temporaries_at_signals();

/// Removes the files of all TemporaryNames that exist after remove_temporaries_at_signals(). For code that
/// ends the program without leaving its functions. May be called in a signal handler.
void remove_temporaries();

/// Sets the action of SIGXCPU from now on. Null: its usual action. Otherwise this text is written to standard
/// error, and the program ends with `status`. The text must stay valid.
void exit_at_cpu_signal(const char* exit_message, int status);

/// Guard that holds those signals back in this thread as long as it lives.
class SignalBlocker {
  public:
    SignalBlocker();
    SignalBlocker(const SignalBlocker&) = delete;
    SignalBlocker& operator=(const SignalBlocker&) = delete;
    ~SignalBlocker();

  private:
    sigset_t old_signal_mask_;
};

/// A file that is removed when this object is destroyed, however the program ends, except by SIGKILL or a
/// crash. Create the file and this object under one SignalBlocker. Its name is made before, so that no step
/// can fail in between.
class TemporaryName {
  public:
    using TemporaryPath = std::unique_ptr<const std::string>;
    static TemporaryPath temporary_path(const std::filesystem::path& file);

    TemporaryName() = default;
    explicit TemporaryName(TemporaryPath name) noexcept;
    TemporaryName(TemporaryName&&) noexcept = default;
    TemporaryName& operator=(TemporaryName&&) = delete;
    ~TemporaryName();

    /// Takes over the file of another object; this one must be empty.
    void adopt(TemporaryName&& other) { name_ = std::move(other.name_); }

    bool empty() const { return name_ == nullptr; }
    const std::string& name() const { return *name_; }
    /// Gives up the file, which no longer exists or is to stay.
    void release();

  private:
    TemporaryPath name_;  // a signal handler reads it in place
};

}  // namespace gsim::os
