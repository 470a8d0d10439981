#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace gsim::rrs {

/// What the caller of a module's services will do next, whatever is answered, so that a module in a process
/// of its own can do it without being asked for each step. A step is GetNextStep and, where it took time and
/// the caller asks for targets, GetTargetOfLastStep. A refusal ends them all.
enum class RcsAhead : std::uint8_t {
    nothing,    ///< It is not known.
    to_target,  ///< Steps until one reaches a target or nothing is queued.
    to_end,     ///< Steps until nothing is queued.
    if_full,    ///< Where a target is answered RRS_QUEUE_FULL: steps to a target, and that target once more.
};

/// The services of one controller, by their numbers, wherever it runs.
class RcsCalls {
  public:
    RcsCalls() = default;
    RcsCalls(const RcsCalls&) = delete;
    RcsCalls& operator=(const RcsCalls&) = delete;
    virtual ~RcsCalls() = default;

    /// Of the library.
    virtual const std::string& name() const = 0;
    /// Answers what the module answers, unchecked; GSIM_RCS_FAULT where it is lost. Structures as
    /// rcs_module.h has them for `opcode`.
    virtual std::int32_t call(std::int32_t opcode, const void* input, void* output) = 0;
    /// Holds until the next one. `asks_targets`: by GetTargetOfLastStep, as long as that succeeds.
    virtual void announce(RcsAhead /*ahead*/, bool /*asks_targets*/) {}
    /// How the module was lost; continues a sentence that begins with its name: "crashed in GetNextStep
    /// (signal 11)".
    virtual std::optional<std::string> loss() const { return std::nullopt; }
    /// What a process of its own has spent.
    virtual double cpu_s() const { return 0; }
};

}  // namespace gsim::rrs
