#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace gsim::rrs {

/// Next actions of the caller of a module's services, whatever the result. So a module in a separate process
/// can do them without a request for each step. A step is GetNextStep and, if it took time and the caller
/// asks for targets, GetTargetOfLastStep. An error ends them all.
enum class RcsPrefetch : std::uint8_t {
    unknown,    ///< It is not known.
    to_target,  ///< Steps until one reaches a target or the queue is empty.
    to_end,     ///< Steps until the queue is empty.
    if_full,    ///< If a target gets RRS_QUEUE_FULL: steps to a target, and that target once more.
};

/// The services of one controller, by their numbers, wherever it runs.
class RcsCalls {
  public:
    RcsCalls() = default;
    RcsCalls(const RcsCalls&) = delete;
    RcsCalls& operator=(const RcsCalls&) = delete;
    virtual ~RcsCalls() = default;

    /// Returns the name of the library.
    virtual const std::string& name() const = 0;
    /// Returns the status of the module, unchecked; GSIM_RCS_FAULT if it is lost. Structures as in
    /// rcs_module.h for `opcode`.
    virtual std::int32_t call(std::int32_t opcode, const void* input, void* output) = 0;
    /// Announces the next calls, until the next announcement. `queries_targets`: by GetTargetOfLastStep, as
    /// long as that succeeds.
    virtual void announce(RcsPrefetch /*ahead*/, bool /*queries_targets*/) {}
    /// Returns how the module was lost; continues a message that begins with its name: "crashed in
    /// GetNextStep (signal 11)".
    virtual std::optional<std::string> loss() const { return std::nullopt; }
    /// Returns the processor time that a separate process has spent.
    virtual double cpu_s() const { return 0; }
};

}  // namespace gsim::rrs
