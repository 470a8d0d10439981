#include "runtime/rrs/status.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace gsim::rrs::status_test {

TEST(Status, names_are_those_of_the_constants) {
    EXPECT_EQ(name(Status::RRS_SUCCESS), "RRS_SUCCESS");
    EXPECT_EQ(name(Status::RRS_JOINT_LIMIT), "RRS_JOINT_LIMIT");
    EXPECT_EQ(name(Status::RRS_MOTION_TYPE_NOT_SUPPORTED), "RRS_MOTION_TYPE_NOT_SUPPORTED");
}

TEST(Status, every_number_in_use_has_a_name_of_its_own) {
    std::set<std::string> names;
    for (int number = -13; number <= 3; ++number) names.emplace(name(static_cast<Status>(number)));
    EXPECT_EQ(names.size(), 17U);
    EXPECT_FALSE(names.contains("RRS_UNKNOWN_STATUS"));
}

TEST(Status, number_of_a_newer_module_is_unknown) {
    EXPECT_EQ(name(static_cast<Status>(-999)), "RRS_UNKNOWN_STATUS");
}

}  // namespace gsim::rrs::status_test
