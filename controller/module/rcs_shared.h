#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "controller/module/rcs_calls.h"
#include "controller/module/rcs_module.h"

// What a program and its gsim-rcs-host share, the process in which a controller module runs: a piece of
// memory with what is asked and answered, and a socket of packets by which each tells the other to look
// there. Both are of one build. Nothing that is read of it is relied on: the module can write there, too.
namespace gsim::rrs {

/// Descriptors of gsim-rcs-host.
inline constexpr int kHostSocket = 3;
inline constexpr int kHostMemory = 4;
/// Its exit status where the socket is not what it was.
inline constexpr int kSocketLost = 99;

inline constexpr std::size_t kStepsAtOnce = 256;
inline constexpr std::size_t kLargestStructure = 4096;

enum class RcsRequest : std::int32_t { load, call, steps, end };

/// A packet to the host: which request of how many it is.
struct RcsQuestion {
    std::uint64_t number;
    RcsRequest request;
    std::int32_t opcode;
};

/// A packet from it. Of RcsRequest::load 0 says that the module is there.
struct RcsAnswer {
    std::uint64_t number;
    std::int32_t status;
    std::int32_t reserved;
    double cpu_s;  ///< What the process has spent so far.
};

/// Instead of a status of GetTargetOfLastStep.
inline constexpr std::int32_t kNotAsked = 1000;
inline constexpr std::int32_t kUnanswered = 1001;

struct RcsSharedStep {
    gsim_rcs_step step;
    gsim_rcs_target_id target;
    std::int32_t status;
    std::atomic<std::int32_t> target_status;
};

struct RcsShared {
    gsim_rcs_machine machine;  ///< Its pointers have no meaning: parameters lie behind all this, as texts.
    std::uint64_t texts_size;
    std::uint64_t memory_bytes;        ///< What the process may take in all; 0: no limit.
    std::atomic<std::int32_t> serves;  ///< The service that the module is in; 0: none.
    alignas(16) std::array<char, kLargestStructure> input;
    alignas(
        16) std::array<char, kLargestStructure> output;  ///< Why it cannot be loaded, of RcsRequest::load.
    std::int32_t ahead;                                  ///< RcsAhead, and whether targets are asked for.
    std::int32_t asks_targets;
    gsim_rcs_step no_step;  ///< What GetNextStep and GetTargetOfLastStep have to fill in.
    gsim_rcs_target_id no_target;
    std::atomic<std::uint32_t> step_count;
    std::atomic<std::int32_t> was_full;  ///< Whether steps are made because a target was answered QUEUE_FULL,
    std::atomic<std::int32_t> has_retry;  ///< and whether it was put again behind them.
    std::int32_t retry_status;
    std::array<RcsSharedStep, kStepsAtOnce> steps;
};
static_assert(std::atomic<std::int32_t>::is_always_lock_free);

/// How large the structures of a service are; 0: it has none, or is not known.
struct RcsSizes {
    std::size_t input = 0;
    std::size_t output = 0;
};
RcsSizes rcs_sizes(std::int32_t opcode);

/// The name of a service; empty: it is not known.
std::string_view rcs_service_name(std::int32_t opcode);

}  // namespace gsim::rrs
