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

/// The services of a controller module. Each result is checked: a status that exists and that the service may
/// return, finite numbers, as many joints as the machine has, a time that advances by no more than a step. A
/// wrong result is an error of the module: the service returns RRS_MODULE_FAULT, GetMessage names module and
/// service, and from then on no service calls the module.
class RcsShell : public Shell {
  public:
    RcsShell(RcsModule module, int joint_count) : module_(std::move(module)), joint_count_(joint_count) {}

    /// Returns the name of the library.
    const std::string& name() const { return module_.name(); }
    /// Returns the error that was found, as a message.
    const std::optional<std::string>& error() const { return error_; }
    double interpolation_s() const { return interpolation_s_; }
    /// Returns the processor time that the module has spent in a separate process.
    double cpu_s() const { return module_.cpu_s(); }

#define GSIM_RCS_SERVICE(method, opcode, number, rrs, input, statuses, parameters, arguments) \
    Status method parameters override;
#include "controller/module/rcs_services.def"

  protected:
    /// Ends all calls of the module from now on; returns RRS_MODULE_FAULT. `what` continues a message that
    /// begins with the module's name: "answered SetRapid with 7, which is no status".
    Status report_module_error(std::string_view what);
    /// Runs before each call of the module.
    virtual void before_call() {}
    /// Works as in RcsCalls.
    void announce(RcsPrefetch prefetch, bool queries_targets) {
        module_.announce(prefetch, queries_targets);
    }

  private:
    Status send_request(const Service& service, const void* input, void* output);
    template <typename Input, typename... Arguments>
    Status request_service(const Service& service, const std::tuple<Arguments...>& arguments,
                           void* output = nullptr);
    template <typename Input>
    void apply_effects(const Service& service, const Input& input);
    Status reject(std::string message);
    template <typename Input, typename Output, typename Method, typename... Arguments>
    Status query(const Service& service, Method method, const std::tuple<Arguments...>& arguments);
    bool is_valid_step(double result_s) const;
    Status report_step_error(const Service& service, double result_s);
    Status check_joint_values(const Service& service, const gsim_rcs_joints& result, double max_abs_value);
    Status check_response(const Service& service, const gsim_rcs_message& result);
    Status check_response(const Service& service, const gsim_rcs_target_id& result);
    Status check_response(const Service& service, const gsim_rcs_pose& result);
    Status check_response(const Service& service, const gsim_rcs_joints& result);
    Status check_response(const Service& service, const gsim_rcs_step& result);
    Status check_response(const Service& service, const gsim_rcs_object_step& result);
    Status check_response(const Service& service, const gsim_rcs_event& result);

    RcsModule module_;
    int joint_count_;
    double interpolation_s_ = kDefaultInterpolation_s;
    double clock_s_ = 0;
    std::optional<std::string> host_message_;  ///< Why the last result was no success, if the host knows.
    std::optional<std::string> error_;

    static constexpr double kDefaultInterpolation_s = 0.01;  // Shell::SetInterpolationTime
};

}  // namespace gsim::rrs
