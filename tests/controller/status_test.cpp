#include "controller/services/status.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace gsim::rrs::status_test {

TEST(Status, NamesMatchConstants) {
    EXPECT_EQ(name(Status::RRS_SUCCESS), "RRS_SUCCESS");
    EXPECT_EQ(name(Status::RRS_JOINT_LIMIT), "RRS_JOINT_LIMIT");
    EXPECT_EQ(name(Status::RRS_MOTION_TYPE_NOT_SUPPORTED), "RRS_MOTION_TYPE_NOT_SUPPORTED");
}

TEST(Status, EachNumberHasUniqueName) {
    std::set<std::string> names;
    for (int number = -13; number <= 3; ++number) names.emplace(name(static_cast<Status>(number)));
    EXPECT_EQ(names.size(), 17U);
    EXPECT_FALSE(names.contains("RRS_UNKNOWN_STATUS"));
}

TEST(Status, NumberOfNewerModuleIsUnknown) {
    EXPECT_EQ(name(static_cast<Status>(-999)), "RRS_UNKNOWN_STATUS");
}

}  // namespace gsim::rrs::status_test
