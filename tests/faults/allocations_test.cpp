// Memory that is refused: each allocation of a program once, and all from one on.

#include <cerrno>

#include <gtest/gtest.h>

#include "tests/faults/jobs.h"
#include "tests/faults/sweep.h"

namespace gsim::faults::allocations_test {
namespace {

class AllocationErrors : public testing::Test {
  protected:
    void SetUp() override {
        if (kInstrumented)
            GTEST_SKIP() << "what is built into the program asks for memory, too, and ends without";
    }
    static void reject(bool repeated) {
        for (const Job& job : jobs()) {
            const Count count = sweep(job, {.kind = Kind::allocation, .error = ENOMEM, .repeated = repeated});
            print_row(repeated ? "no memory from an allocation on" : "an allocation fails", job.name, count);
            EXPECT_GT(count.of, 100U) << job.name;
            // The number of a process is in names of files, so that the last ones may not come.
            EXPECT_GE(count.struck + 2, count.attempts) << job.name;
            for (const std::string& wrong : count.wrong) ADD_FAILURE() << job.name << ", " << wrong;
        }
    }
};

TEST_F(AllocationErrors, EachSingleFailureIsHandled) {
    reject(false);
}

TEST_F(AllocationErrors, FailureOfAllLaterAllocationsIsHandled) {
    reject(true);
}

TEST_F(AllocationErrors, MessageNamesProgramAndReason) {
    const Outcome found =
        run(job_named("gcode2lua"), {.kind = Kind::allocation, .which = 100, .error = ENOMEM});
    EXPECT_EQ(found.status, 2);
    EXPECT_EQ(found.err, "gcode2lua: out of memory\n");
    EXPECT_EQ(found.files, job_named("gcode2lua").files);
}

}  // namespace
}  // namespace gsim::faults::allocations_test
