// Answers of the planner, compared with the list of services.

#include <functional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "controller/services/service_call.h"
#include "controller/services/services.h"
#include "tests/controller/service_values.h"
#include "tests/motion/planner_under_test.h"

namespace gsim::motion::services_list_test {
namespace {

using rrs::Shell;
using rrs::Status;

constexpr rrs::AllowedStatuses kAlways{Status::RRS_SUCCESS, Status::RRS_NOT_INITIALIZED,
                                       Status::RRS_SERVICE_NOT_SUPPORTED, Status::RRS_INVALID_PARAMETER};

struct Call {
    rrs::Service service;
    std::function<Status(Shell&, rrs::ServiceValues&)> make;
};

template <typename... Parameters>
Status call_with_any(Shell& shell, Status (Shell::*method)(Parameters...), rrs::ServiceValues& values) {
    using Traits = rrs::ServiceTraits<Status (Shell::*)(Parameters...)>;
    using All = std::tuple<Parameters...>;
    const auto inputs = [&]<std::size_t... at>(std::index_sequence<at...>) {
        return std::tuple{values.next<std::tuple_element_t<at, All>>()...};
    }
    (std::make_index_sequence<Traits::kInputs>());
    typename Traits::Outputs outputs{};
    return rrs::call(shell, method, inputs, outputs);
}

std::vector<Call> all_calls() {
    std::vector<Call> calls;
#define GSIM_RCS_SERVICE(method, opcode, number, rrs_number, input, statuses, parameters, arguments) \
    calls.push_back({rrs::services::method, [](Shell& shell, rrs::ServiceValues& values) {           \
                         return call_with_any(shell, &Shell::method, values);                        \
                     }});
#include "controller/module/rcs_services.def"
    return calls;
}

class ServicesList : public AnyPlanner {};

INSTANTIATE_TEST_SUITE_P(Ways, ServicesList, all_ways(), way_name);

TEST_P(ServicesList, ContainsAllResponsesOfPlanner) {
    const std::vector<Call> calls = all_calls();
    rrs::ServiceValues values(11);
    std::mt19937 random(12);
    std::size_t succeeded = 0, rejected = 0;
    for (int session = 0; session < 40; ++session) {
        const auto planner = make(gantry_setup());
        if (session > 0) planner->Initialize();
        for (int i = 0; i < 200; ++i) {
            const Call& call = calls[random() % calls.size()];
            if (call.service.name == "Terminate") continue;
            const Status status = call.make(*planner, values);
            EXPECT_TRUE(kAlways.contains(status) || call.service.statuses.contains(status))
                << call.service.name << " answers " << name(status);
            ++(rrs::is_error_status(status) ? rejected : succeeded);
        }
    }
    EXPECT_GT(succeeded, 1000U);
    EXPECT_GT(rejected, 1000U);
}

TEST_P(ServicesList, ExtensionsReachPlanner) {
    const auto planner = make(gantry_setup());
    planner->Initialize();
    const rrs::CartPos pose = rrs::CartPos::Identity();
    EXPECT_EQ(planner->SetInitialPosition(pose, joint_pos({500, 500, 300, 0, 0}), ""), Status::RRS_SUCCESS);
    EXPECT_EQ(planner->SelectTracking(1, true), Status::RRS_INVALID_PARAMETER) << "none is defined";
    EXPECT_EQ(planner->DefineConveyor(1, {1, 0, 0}, 100), Status::RRS_SUCCESS);
    EXPECT_EQ(planner->SelectTracking(1, true), Status::RRS_SUCCESS);
    EXPECT_EQ(planner->SelectTracking(1, false), Status::RRS_SUCCESS);
    EXPECT_EQ(planner->SetTipControl(true, {0, 0, -50}), Status::RRS_SUCCESS);
    EXPECT_EQ(planner->SetTipControl(false, {0, 0, 0}), Status::RRS_SUCCESS);
}

}  // namespace
}  // namespace gsim::motion::services_list_test
