#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "controller/module/rcs_calls.h"
#include "controller/module/rcs_module.h"

// Data shared by a program and its gsim-rcs-host, the process in which a controller module runs: memory with
// requests and responses, and a socket of packets by which each notifies the other. Both are of one build.
// Data read from it are not trusted, because the module can write there, too.
namespace gsim::rrs {

/// Descriptors of gsim-rcs-host.
inline constexpr int kHostSocket = 3;
inline constexpr int kHostMemory = 4;
/// Exit status of the host if its socket is not as it was.
inline constexpr int kSocketLost = 99;

inline constexpr std::size_t kMaxPrefetchedSteps = 256;
inline constexpr std::size_t kMaxStructureSize = 4096;

enum class RcsRequest : std::int32_t { load, call, steps, end };

/// A packet to the host: the request and its running number.
struct RcsRequestPacket {
    std::uint64_t number;
    RcsRequest request;
    std::int32_t opcode;
};

/// A packet from the host. For RcsRequest::load, 0 means that the module exists.
struct RcsResponse {
    std::uint64_t number;
    std::int32_t status;
    std::int32_t reserved;
    double cpu_s;  ///< Processor time of the process so far.
};

/// Values instead of a status of GetTargetOfLastStep.
inline constexpr std::int32_t kNotQueried = 1000;
inline constexpr std::int32_t kPending = 1001;

struct RcsSharedStep {
    gsim_rcs_step step;
    gsim_rcs_target_id target;
    std::int32_t status;
    std::atomic<std::int32_t> target_status;
};

struct RcsShared {
    gsim_rcs_machine machine;  ///< Its pointers have no meaning: parameters follow all this, as texts.
    std::uint64_t texts_size;
    std::uint64_t memory_bytes;                ///< Max memory of the process in all; 0: no limit.
    std::atomic<std::int32_t> active_service;  ///< Active service of the module; 0: none.
    alignas(16) std::array<char, kMaxStructureSize> input;
    alignas(
        16) std::array<char, kMaxStructureSize> output;  ///< For RcsRequest::load: why it cannot be loaded.
    std::int32_t prefetch;                               ///< RcsPrefetch, and whether targets are asked for.
    std::int32_t queries_targets;
    gsim_rcs_step empty_step;  ///< Outputs of GetNextStep and GetTargetOfLastStep to be filled in.
    gsim_rcs_target_id empty_target;
    std::atomic<std::uint32_t> step_count;
    std::atomic<std::int32_t> was_full;   ///< True if steps are made because a target returned QUEUE_FULL,
    std::atomic<std::int32_t> has_retry;  ///< and true if it was then enqueued again.
    std::int32_t retry_status;
    std::array<RcsSharedStep, kMaxPrefetchedSteps> steps;
};
static_assert(std::atomic<std::int32_t>::is_always_lock_free);

/// Sizes of the structures of a service; 0: it has none, or is not known.
struct RcsSizes {
    std::size_t input = 0;
    std::size_t output = 0;
};
RcsSizes rcs_sizes(std::int32_t opcode);

/// Returns the name of a service; empty: it is not known.
std::string_view rcs_service_name(std::int32_t opcode);

}  // namespace gsim::rrs
