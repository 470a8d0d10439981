#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "controller/module/rcs_host.h"
#include "controller/services/services.h"
#include "controller/services/shell.h"

namespace gsim::rrs {

/// The services of a controller module. Each answer is checked: a status that exists and that the service may
/// answer, numbers that are finite, as many joints as the machine has, a time that goes on and by no more
/// than a step. An answer that fails is a fault of the module: the service answers RRS_MODULE_FAULT,
/// GetMessage names module and service, and from then on no service calls the module.
class RcsShell : public Shell {
  public:
    RcsShell(RcsModule module, int joint_count) : module_(std::move(module)), joint_count_(joint_count) {}

    /// Of the library.
    const std::string& name() const { return module_.name(); }
    /// The fault that was found, as a sentence.
    const std::optional<std::string>& fault() const { return fault_; }
    double interpolation_s() const { return interpolation_s_; }
    /// Processor time that the module has spent in a process of its own.
    double cpu_s() const { return module_.cpu_s(); }

#define GSIM_RCS_SERVICE(method, opcode, number, rrs, input, answers, parameters, arguments) \
    Status method parameters override;
#include "controller/module/rcs_services.def"

  protected:
    /// From now on the module is not called any more; answers RRS_MODULE_FAULT. `what` continues a sentence
    /// that begins with the module's name: "answered SetRapid with 7, which is no status".
    Status blame(std::string_view what);
    /// The module is about to be called.
    virtual void calling() {}
    /// As of RcsCalls.
    void announce(RcsAhead ahead, bool asks_targets) {
        module_.announce(ahead, asks_targets);
    }

  private:
    Status ask(const Service& service, const void* input, void* output);
    template <typename Input, typename... Arguments>
    Status tell(const Service& service, const std::tuple<Arguments...>& arguments, void* output = nullptr);
    template <typename Input>
    void heard(const Service& service, const Input& input);
    Status refuse(std::string message);
    template <typename Input, typename Output, typename Method, typename... Arguments>
    Status query(const Service& service, Method method, const std::tuple<Arguments...>& arguments);
    bool is_step(double answer_s) const;
    Status blame_step(const Service& service, double answer_s);
    Status checked_joints(const Service& service, const gsim_rcs_joints& answer, double largest);
    Status checked(const Service& service, const gsim_rcs_message& answer);
    Status checked(const Service& service, const gsim_rcs_target_id& answer);
    Status checked(const Service& service, const gsim_rcs_pose& answer);
    Status checked(const Service& service, const gsim_rcs_joints& answer);
    Status checked(const Service& service, const gsim_rcs_step& answer);
    Status checked(const Service& service, const gsim_rcs_object_step& answer);
    Status checked(const Service& service, const gsim_rcs_event& answer);

    RcsModule module_;
    int joint_count_;
    double interpolation_s_ = kDefaultInterpolation_s;
    double clock_s_ = 0;
    std::optional<std::string> own_message_;  ///< Why the last answer was no success, where the host knows.
    std::optional<std::string> fault_;

    static constexpr double kDefaultInterpolation_s = 0.01;  // Shell::SetInterpolationTime
};

}  // namespace gsim::rrs
