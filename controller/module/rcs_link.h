#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <sys/types.h>
#include <tl/expected.hpp>

#include "base/os/descriptor.h"
#include "controller/module/rcs_process.h"
#include "controller/module/rcs_shared.h"

namespace gsim::rrs {

/// How a process was lost, in two parts: "crashed", " (signal 11)". Where it happened goes between or behind.
struct RcsLoss {
    std::string what;
    std::string why;
    std::int32_t service = 0;  ///< What the module was in; 0: in none.
};

/// Memory that two processes share: a struct RcsShared, and texts behind it.
class RcsMemory {
  public:
    /// The error is errno.
    static tl::expected<std::unique_ptr<RcsMemory>, int> make(std::size_t texts_size);
    /// That of `descriptor`, as the other process sees it.
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

/// A gsim-rcs-host at work, and the way to it.
class RcsLink {
  public:
    static tl::expected<std::unique_ptr<RcsLink>, std::string> begin(const std::filesystem::path& program,
                                                                     const std::string& path,
                                                                     const gsim_rcs_machine& machine,
                                                                     const RcsProcessLimits& limits);
    RcsLink(const RcsLink&) = delete;
    RcsLink& operator=(const RcsLink&) = delete;
    /// Ends the process, and those that the module has begun in its group.
    ~RcsLink();

    RcsShared& shared() const { return memory_->shared(); }
    /// What is answered; nothing where the process is lost.
    std::optional<std::int32_t> ask(RcsRequest request, std::int32_t opcode = 0);
    const std::optional<RcsLoss>& loss() const { return loss_; }
    double cpu_s() const { return cpu_s_; }

  private:
    RcsLink(pid_t process, os::Descriptor socket, std::unique_ptr<RcsMemory> memory, int answer_ms);
    bool receive(RcsAnswer& answer);
    bool has_ended() const;
    bool wait_for_end(int milliseconds) const;
    void lose(std::string what, std::string why);
    void lose_ended();
    void end();

    pid_t process_;
    os::Descriptor socket_;
    std::unique_ptr<RcsMemory> memory_;
    int answer_ms_;
    int slice_ms_;
    std::uint64_t number_ = 0;
    std::int32_t awaited_ = 0;  ///< The service whose answer is waited for; 0: none.
    double cpu_s_ = 0;
    std::optional<int> status_;  ///< Of the process, as waitpid() has it.
    std::optional<RcsLoss> loss_;
};

}  // namespace gsim::rrs
