#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <sys/types.h>
#include <tl/expected.hpp>

#include "base/error.h"
#include "base/os/descriptor.h"
#include "controller/module/rcs_process.h"
#include "controller/module/rcs_shared.h"

namespace gsim::rrs {

/// Cause of the loss of a process, in two parts: "crashed", " (signal 11)". The place of the loss is inserted
/// between them or added at the end.
struct RcsLoss {
    std::string what;
    std::string reason;
    std::int32_t service = 0;  ///< Active service of the module; 0: none.
};

/// Memory that two processes share: a struct RcsShared, followed by texts.
class RcsMemory {
  public:
    /// Creates the memory. The error is errno.
    static tl::expected<std::unique_ptr<RcsMemory>, int> make(std::size_t texts_size);
    /// Returns the memory of `descriptor`, as the other process sees it.
    static tl::expected<std::unique_ptr<RcsMemory>, int> of(int descriptor);
    RcsMemory(const RcsMemory&) = delete;
    RcsMemory& operator=(const RcsMemory&) = delete;
    ~RcsMemory();

    int descriptor() const { return descriptor_.number(); }
    RcsShared& shared() const { return *static_cast<RcsShared*>(address_); }
    char* texts() const { return static_cast<char*>(address_) + sizeof(RcsShared); }
    std::size_t texts_size() const { return size_ - sizeof(RcsShared); }

  private:
    RcsMemory(os::Descriptor descriptor, void* address, std::size_t size)
        : descriptor_(std::move(descriptor)), address_(address), size_(size) {}
    static tl::expected<std::unique_ptr<RcsMemory>, int> map(os::Descriptor descriptor, std::size_t size);

    os::Descriptor descriptor_;
    void* address_;
    std::size_t size_;
};

/// A running gsim-rcs-host, and the connection to it.
class RcsLink {
  public:
    static Result<std::unique_ptr<RcsLink>> begin(const std::filesystem::path& program,
                                                  const std::string& path, const gsim_rcs_machine& machine,
                                                  const RcsProcessLimits& limits);
    RcsLink(const RcsLink&) = delete;
    RcsLink& operator=(const RcsLink&) = delete;
    /// Ends the process, and those that the module has started in its group.
    ~RcsLink();

    RcsShared& shared() const { return memory_->shared(); }
    /// Sends a request and returns the response; nothing if the process is lost.
    std::optional<std::int32_t> send_request(RcsRequest request, std::int32_t opcode = 0);
    const std::optional<RcsLoss>& loss() const { return loss_; }
    double cpu_s() const { return cpu_s_; }

  private:
    RcsLink(pid_t process, os::Descriptor socket, std::unique_ptr<RcsMemory> memory, int response_timeout_ms);
    bool receive(RcsResponse& response);
    bool has_ended() const;
    bool wait_for_exit(int milliseconds) const;
    void mark_lost(std::string what, std::string reason);
    void mark_exited();
    void end();

    pid_t process_;
    os::Descriptor socket_;
    std::unique_ptr<RcsMemory> memory_;
    int response_timeout_ms_;
    int poll_interval_ms_;
    std::uint64_t number_ = 0;
    std::int32_t pending_service_ = 0;  ///< Service with a pending response; 0: none.
    double cpu_s_ = 0;
    std::optional<int> status_;  ///< Status of the process, as of waitpid().
    std::optional<RcsLoss> loss_;
};

}  // namespace gsim::rrs
