#include "controller/module/rcs_codec.h"

#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "controller/services/service_call.h"
#include "controller/services/services.h"
#include "tests/controller/service_values.h"

namespace gsim::rrs::rcs_codec_test {
namespace {

template <typename One, typename Other>
bool same(const One& one, const Other& other) {
    if constexpr (std::is_same_v<One, CartPos>) {
        return one.matrix() == other.matrix();
    } else if constexpr (std::is_enum_v<One>) {
        return one == static_cast<One>(other);
    } else if constexpr (std::is_same_v<One, std::span<const int>> ||
                         std::is_same_v<One, std::span<const double>>) {
        return std::equal(one.begin(), one.end(), other.begin(), other.end());
    } else {
        return one == other;
    }
}

template <typename Input, typename... Parameters>
void expect_same_behind_the_interface(const Service& service, Status (Shell::*)(Parameters...)) {
    constexpr std::size_t kInputs = ServiceTraits<Status (Shell::*)(Parameters...)>::kInputs;
    using All = std::tuple<Parameters...>;
    ServiceValues values(7);
    [&]<std::size_t... at>(std::index_sequence<at...>) {
        [[maybe_unused]] const auto given = std::tuple{values.next<std::tuple_element_t<at, All>>()...};
        Input input{};
        ASSERT_FALSE(write(input, std::get<at>(given)...)) << service.name;
        const auto taken = get_values<kInputs>(input);
        ASSERT_TRUE(taken) << service.name;
        EXPECT_TRUE((same(std::get<at>(given), std::get<at>(*taken)) && ...)) << service.name;
    }
    (std::make_index_sequence<kInputs>());
}

TEST(RcsCodec, ServiceInputsPassInterfaceUnchanged) {
#define GSIM_RCS_SERVICE(method, opcode, number, rrs, input, statuses, parameters, arguments) \
    expect_same_behind_the_interface<gsim_rcs_##input>(services::method, &Shell::method);
#include "controller/module/rcs_services.def"
}

TEST(RcsCodec, ReportsTooLongNamesAndLists) {
    gsim_rcs_target target{};
    const std::string fits(GSIM_RCS_NAME_SIZE - 1, 'n'), too_long(GSIM_RCS_NAME_SIZE, 'n');
    const auto put_named = [&](const std::string& configuration, const std::string& name) {
        return write(target, TargetId{1}, TargetParam::end, CartPos::Identity(), JointPos::Zero(5).eval(),
                     std::string_view(configuration), 0.0, std::string_view(name));
    };
    EXPECT_FALSE(put_named(fits, fits));
    EXPECT_EQ(put_named(too_long, fits)->subject, "The configuration");
    EXPECT_EQ(put_named(fits, too_long)->subject, "The name of the target");
    gsim_rcs_joint_values many{};
    const std::vector<double> values(GSIM_RCS_MAX_JOINTS + 1);
    EXPECT_EQ(write(many, std::span<const int>(), std::span<const double>(values))->subject, "");
}

TEST(RcsCodec, RejectsCountsOutOfRange) {
    gsim_rcs_joint_values values{};
    EXPECT_TRUE(get_values<2>(values));
    for (const int count : {-1, GSIM_RCS_MAX_JOINTS + 1}) {
        values.value_count = count;
        EXPECT_FALSE(get_values<2>(values)) << count;
    }
}

TEST(Services, HaveUniqueNumbers) {
    std::set<int> opcodes, of_rrs;
    std::size_t services = 0, in_rrs = 0;
#define GSIM_RCS_SERVICE(method, opcode, number, rrs, input, statuses, parameters, arguments) \
    ++services;                                                                               \
    opcodes.insert(number);                                                                   \
    if ((rrs) != 0) {                                                                         \
        ++in_rrs;                                                                             \
        of_rrs.insert(rrs);                                                                   \
    }
#include "controller/module/rcs_services.def"
    EXPECT_EQ(opcodes.size(), services);
    EXPECT_EQ(of_rrs.size(), in_rrs);
    EXPECT_GE(in_rrs, 42U);
}

}  // namespace
}  // namespace gsim::rrs::rcs_codec_test
