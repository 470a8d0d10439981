// Comments of RS274/NGC with an effect beyond messages.

#include "tests/lua_lib/ngc_run.h"

namespace gsim::script::ngc_comments_test {
namespace {

TEST(NgcAbort, EndsRunWithItsText) {
    const Outcome r = run_ngc("G0 X1\n(abort, no tool is loaded)\nG0 X2\nM2\n");
    expect_alarm(r, 2, {"no tool is loaded"});
    EXPECT_EQ(r.moves.size(), 1U) << "what stands before it has been done";
}

TEST(NgcAbort, FormatsValuesLikeDebugComment) {
    const Outcome r =
        run_ngc("#1=6\n#<foo>=5\nG0 X1 (ABORT, v=#1 n=#<foo> m=#<bar> %.2f #1 %d #1 %f #1 50%)\nM2\n");
    expect_alarm(r, 3, {"v=6.000000 n=5.000000 m=######  6.00  6  6.0000 50%"});
    EXPECT_TRUE(r.moves.empty()) << "it acts before its block";
}

TEST(NgcAbort, IgnoresSkippedBranchAndOtherComments) {
    EXPECT_TRUE(run_ngc("o1 if [0]\n(abort,no)\no1 endif\nM2\n").completed());
    EXPECT_TRUE(run_ngc("(abort,no)(a remark)\n;abort,no\n(abort no)\n( abort , no)\nM2\n").completed());
    expect_alarm(run_ngc("o1 sub\n(abort,in o1 #1)\no1 endsub\no1 call [3]\nM2\n"), 2, {"in o1 3.000000"});
}

TEST(NgcAbort, ReportsMissingText) {
    expect_alarm(run_ngc("(abort,)\nM2\n"), 1, {"(abort,) needs a text"});
}

TEST(NgcPython, IsRejectedByNameIfExecuted) {
    expect_alarm(run_ngc("(py,this.x = 1)\nM2\n"), 1,
                 {"(py,) runs Python of the controller, which is not supported"});
    expect_alarm(run_ngc("(PYRUN,file.py)\nM2\n"), 1,
                 {"(pyrun,) runs Python of the controller, which is not supported"});
    EXPECT_TRUE(run_ngc("o1 if [0]\n(py,this.x = 1)\no1 endif\nM2\n").completed());
}

TEST(NgcPython, ReloadIsReportedOnce) {
    const Outcome r = run_ngc("(pyreload)\nG0 X1\n(pyreload)\nM2\n");
    ASSERT_TRUE(r.completed()) << r.message();
    ASSERT_EQ(r.report.messages.warnings.size(), 1U);
    EXPECT_NE(r.report.messages.warnings[0].find("(pyreload) has no effect: Python is not supported"),
              std::string::npos)
        << r.report.messages.warnings[0];
}

}  // namespace
}  // namespace gsim::script::ngc_comments_test
