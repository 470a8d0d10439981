#include "controller/services/shell.h"

#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "controller/services/service_call.h"
#include "tests/controller/service_values.h"

namespace gsim::rrs::shell_test {
namespace {

// A controller that offers no service, but records the requested one.
class BareShell : public Shell {
  public:
    std::string requested;

  protected:
    Status not_supported(std::string_view service) override {
        requested = service;
        return Shell::not_supported(service);
    }
};

template <typename... Parameters>
Status call_with_any(Shell& shell, Status (Shell::*method)(Parameters...)) {
    using Traits = ServiceTraits<Status (Shell::*)(Parameters...)>;
    using All = std::tuple<Parameters...>;
    ServiceValues values(3);
    const auto inputs = [&]<std::size_t... at>(std::index_sequence<at...>) {
        return std::tuple{values.next<std::tuple_element_t<at, All>>()...};
    }
    (std::make_index_sequence<Traits::kInputs>());
    typename Traits::Outputs outputs{};
    return call(shell, method, inputs, outputs);
}

TEST(Shell, ReportsUnimplementedServiceByName) {
    BareShell shell;
#define GSIM_RCS_SERVICE(method, opcode, number, rrs, input, statuses, parameters, arguments)      \
    EXPECT_EQ(call_with_any(shell, &Shell::method), Status::RRS_SERVICE_NOT_SUPPORTED) << #method; \
    EXPECT_EQ(shell.requested, #method);
#include "controller/module/rcs_services.def"
}

}  // namespace
}  // namespace gsim::rrs::shell_test
