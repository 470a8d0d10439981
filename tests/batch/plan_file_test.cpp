#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include <gmock/gmock.h>
#include <unistd.h>

#include "batch/plan/plan.h"

namespace gsim::batch::plan_file_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

class PlanFile : public testing::Test {
  protected:
    PlanFile() {
        for (const char* name :
             {"p/a.nc", "p/b.NGC", "p/deep/c.tap", "p/notes.txt", "p/.hidden/d.nc", "m.toml"}) {
            fs::create_directories((folder_ / name).parent_path());
            std::ofstream(folder_ / name) << "M2\n";
        }
    }
    ~PlanFile() override { fs::remove_all(folder_); }

    Result<Plan> read(const std::string& text) const {
        return read_plan(text, (folder_ / "plan.toml").string());
    }
    std::string rejection(const std::string& text) const {
        const auto plan = read(text);
        return plan ? "" : plan.error().message;
    }

    fs::path folder_ = fs::temp_directory_path() / ("gsim-plan-" + std::to_string(::getpid()));
};

TEST_F(PlanFile, ExpandsFoldersFilesAndPatterns) {
    const auto plan = read(R"(programs = ["p", "p/*.nc", "p/**/*.tap", "p/notes.txt"]
machines = ["m.toml", "router3"]
)");
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_THAT(plan->programs, ElementsAre(EndsWith("p/a.nc"), EndsWith("p/b.NGC"), EndsWith("p/deep/c.tap"),
                                            EndsWith("p/notes.txt")))
        << "each of them once";
    EXPECT_THAT(plan->machines, ElementsAre(EndsWith("/m.toml"), "router3"));
    EXPECT_EQ(Jobs(*plan).size(), 8U);
}

TEST_F(PlanFile, CreatesJobPerProgramMachineAndVariant) {
    const auto plan = read(R"(programs = "p"
machines = ["m.toml", "router3"]
controllers = ["ab9", "blend"]
reports = true
[options]
dialect = "rs274ngc"
cell = "m.toml"
[[setting]]
key = "machine.axis.X.max_speed_mm_s"
from = 100
to = 300
steps = 3
)");
    ASSERT_TRUE(plan) << plan.error().message;
    const Jobs jobs(*plan);
    ASSERT_EQ(jobs.size(), 3U * 2 * 2 * 3);
    const Job job = jobs.job(7);
    EXPECT_THAT(job.program, EndsWith("p/a.nc"));
    EXPECT_EQ(job.machine, "router3");
    EXPECT_EQ(settings_json(job.settings).dump(),
              R"({"machine.axis.X.max_speed_mm_s":100.0,"machine.controller.model":"blend"})");
    EXPECT_THAT(job.options.at("cell").get<std::string>(), EndsWith("/m.toml"));
    EXPECT_TRUE(job.stored_documents.report);
    const auto repeated = read_job(print_job(job));
    ASSERT_TRUE(repeated);
    EXPECT_EQ(repeated->settings, job.settings);
    EXPECT_EQ(repeated->options, job.options);
}

TEST_F(PlanFile, ReportsInvalidKeysAndValues) {
    EXPECT_THAT(rejection("programs = ["), HasSubstr("plan.toml:1:"));
    EXPECT_THAT(rejection("machines = [\"a\"]"), HasSubstr("lacks the key 'programs'"));
    EXPECT_THAT(rejection("programs = \"q\""), HasSubstr("q': file or folder not found"));
    EXPECT_THAT(rejection("programs = \"*.xyz\""), HasSubstr("no file matches '"));
    EXPECT_THAT(rejection("programs = [1]"), HasSubstr("must be a list of strings"));
    const std::string head = "programs = \"p\"\n";
    EXPECT_THAT(rejection(head + "program = 1"), HasSubstr("did you mean 'programs'?"));
    EXPECT_THAT(rejection(head + "[options]\ndialct = \"a\""), HasSubstr("did you mean 'dialect'?"));
    EXPECT_THAT(rejection(head + "[options]\npasses = 1.5"), HasSubstr("'passes' must be an integer"));
    EXPECT_THAT(rejection(head + "[sampling]\nkind = \"sobol\""), HasSubstr("lacks the key 'runs'"));
    const std::string setting = head + "[[setting]]\n";
    EXPECT_THAT(rejection(setting + "key = \"axis.X\"\nvalues = [1]"), HasSubstr("must begin with"));
    EXPECT_THAT(rejection(setting + "key = \"machine.a\"\nvalues = []"),
                HasSubstr("'values' must be a list with at least one value"));
    EXPECT_THAT(rejection(setting + "key = \"machine.a\"\nfrom = 1\nto = 0"), HasSubstr("must not be less"));
    EXPECT_THAT(rejection(setting + "key = \"machine.a\"\nfrom = 1\nto = 2"),
                HasSubstr("which a grid requires"));
    const std::string two = setting + "key = \"machine.a\"\nvalues = [1]\n";
    EXPECT_THAT(rejection(two + "[[setting]]\nkey = \"machine.a\"\nvalues = [2]"), HasSubstr("is set twice"));
    EXPECT_THAT(rejection(two + "steps = 2"), HasSubstr("'steps' has no effect together with 'values'"));
    EXPECT_THAT(rejection(head + "[sampling]\nruns = 5"),
                HasSubstr("a grid has one run for each combination"));
    const std::string normal = "key = \"machine.a\"\ndistribution = \"normal\"\nmean = 1\ndeviation = 1\n";
    EXPECT_THAT(rejection(setting + normal + "from = 1\nto = 2"),
                HasSubstr("'from' has no effect together with 'normal'"));
    EXPECT_THAT(rejection(setting + "key = \"machine.a\"\ndistribution = \"triangular\""),
                HasSubstr("lacks the key 'from'"));
    EXPECT_THAT(rejection(setting + "key = \"option.passes\"\nfrom = 1\nto = 2"),
                HasSubstr("'passes' must be an integer from 1 on"));
    EXPECT_THAT(rejection(setting + "key = \"machine.a\""),
                HasSubstr("must have 'values', or 'from' and 'to'"));
    EXPECT_THAT(rejection(setting + "key = \"option.passes\"\nvalues = [0]"),
                HasSubstr("'passes' must be an integer from 1 on"));
    EXPECT_THAT(rejection(setting + "key = \"option.x\"\nvalues = [0]"), HasSubstr("unknown option 'x'"));
    EXPECT_THAT(rejection(setting + "key = \"data.OFFSET.54.X\"\nscale = true\nvalues = [2]"),
                HasSubstr("'scale' applies only to"));
}

// The name of a folder may contain the wildcards of a pattern.
TEST_F(PlanFile, AcceptsFolderOfAnyName) {
    const fs::path odd = folder_ / "job [5] *";
    fs::create_directories(odd / "deep");
    std::ofstream(odd / "deep" / "x.nc") << "M2\n";
    for (const char* pattern : {"*/*.nc", "**/*.nc", "deep"}) {
        const auto plan =
            read_plan(std::string("programs = \"") + pattern + "\"\n", (odd / "plan.toml").string());
        ASSERT_TRUE(plan) << plan.error().message;
        EXPECT_THAT(plan->programs, ElementsAre(EndsWith("job [5] */deep/x.nc")));
    }
    std::ofstream(odd / "\xe9.nc") << "M2\n";
    EXPECT_THAT(read_plan("programs = \".\"\n", (odd / "plan.toml").string()).error().message,
                HasSubstr("not UTF-8"));
}

TEST_F(PlanFile, SetsSeveralKeysToSameValue) {
    const auto plan = read(R"(programs = "p"
[[setting]]
keys = ["cell.object.part.frame.x_mm", "cell.frame.f.x_mm"]
values = [1, 2]
shift = true
[[setting]]
key = "path.order"
values = [[0, 1], [1, 0]]
)");
    ASSERT_TRUE(plan) << plan.error().message;
    ASSERT_EQ(Jobs(*plan).size(), 12U);
    const Job job = Jobs(*plan).job(3);
    ASSERT_EQ(job.settings.size(), 3U);
    EXPECT_EQ(job.settings[0], (SettingValue{"cell.object.part.frame.x_mm", 2, SettingUse::shift}));
    EXPECT_EQ(job.settings[1], (SettingValue{"cell.frame.f.x_mm", 2, SettingUse::shift}));
    EXPECT_EQ(job.settings[2].value, (nlohmann::json{1U, 0U}));
    EXPECT_EQ(settings_json(job.settings)["cell.frame.f.x_mm"], "+ 2");
}

TEST_F(PlanFile, DrawsOrdersUniformly) {
    const auto plan = read(R"(programs = "p/a.nc"
[sampling]
kind = "random"
runs = 6000
[[setting]]
key = "path.order"
orders = 3
)");
    ASSERT_TRUE(plan) << plan.error().message;
    const Jobs jobs(*plan);
    std::map<std::string, int> counts;
    for (std::uint64_t i = 0; i < jobs.size(); ++i) ++counts[jobs.job(i).settings[0].value.dump()];
    ASSERT_EQ(counts.size(), 6U) << "all orders of three";
    for (const auto& [order, count] : counts)
        EXPECT_NEAR(count, 1000, 5 * std::sqrt(6000 * 5.0 / 36)) << order;
}

TEST_F(PlanFile, RejectsIncompatibleKeys) {
    const auto with = [&](const std::string& setting) {
        return rejection("programs = \"p\"\n[[setting]]\n" + setting);
    };
    EXPECT_THAT(with("values = [1]\n"), HasSubstr("a 'key', or a list of 'keys'"));
    EXPECT_THAT(with("key = \"machine.a\"\nkeys = [\"machine.b\"]\nvalues = [1]\n"),
                HasSubstr("a 'key', or a list of 'keys'"));
    EXPECT_THAT(with("keys = [1]\nvalues = [1]\n"), HasSubstr("'keys' must be a list of strings"));
    EXPECT_THAT(with("key = \"machine.a\"\nvalues = [1]\nshift = true\nscale = true\n"),
                HasSubstr("not both"));
    EXPECT_THAT(with("key = \"option.passes\"\nvalues = [1]\nshift = true\n"),
                HasSubstr("'shift' applies only to values of"));
    EXPECT_THAT(with("key = \"machine.a\"\norders = 3\n"), HasSubstr("'path.order' must have 'orders'"));
    EXPECT_THAT(with("key = \"path.order\"\nfrom = 1\nto = 2\n"),
                HasSubstr("'path.order' must have 'orders'"));
    EXPECT_THAT(with("key = \"path.order\"\norders = 40\n"), HasSubstr("from 2 to 18"));
    EXPECT_THAT(with("key = \"path.order\"\nvalues = [1]\n"), HasSubstr("a value must be"));
    EXPECT_THAT(with("key = \"path.plase.x_mm\"\nvalues = [1]\n"), HasSubstr("path.place.x_mm"));
    EXPECT_THAT(with("keys = [\"machine.a\", \"machine.a\"]\nvalues = [1]\n"), HasSubstr("set twice"));
}

TEST_F(PlanFile, ReadsEachSamplingKind) {
    for (const auto& [name, sampling] : {std::pair{"random", Sampling::random},
                                         {"latin-hypercube", Sampling::latin_hypercube},
                                         {"sobol", Sampling::sobol}}) {
        const auto plan = read(std::string("programs = \"p/a.nc\"\n[sampling]\nkind = \"") + name +
                               "\"\nruns = 7\n[[setting]]\nkey = \"machine.a\"\nfrom = 0\nto = 1\n");
        ASSERT_TRUE(plan) << plan.error().message;
        EXPECT_EQ(plan->design.sampling, sampling) << name;
        EXPECT_EQ(Jobs(*plan).size(), 7U) << name;
    }
}

TEST_F(PlanFile, RejectsPathOptionsForPrograms) {
    for (const char* option : {"post = \"ab9\"", "path_frame = \"f\"", "rotary_as_given = true"})
        EXPECT_THAT(rejection(std::string("programs = \"p\"\n[options]\n") + option + "\n"),
                    HasSubstr("applies to paths"));
}

TEST_F(PlanFile, ReadsDistributions) {
    const auto plan = read(R"(programs = "p"
[sampling]
kind = "latin-hypercube"
runs = 10
[[setting]]
key = "machine.a"
distribution = "normal"
mean = 5
deviation = 1
[[setting]]
key = "machine.b"
from = 0.9
to = 1.1
scale = true
[[setting]]
key = "machine.c"
distribution = "triangular"
from = 0
to = 2
mode = 0.5
)");
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_TRUE(std::holds_alternative<Normal>(plan->settings[0].domain));
    EXPECT_EQ(plan->settings[1].use, SettingUse::factor);
    EXPECT_EQ(std::get<Triangular>(plan->settings[2].domain).mode, 0.5);
    EXPECT_EQ(Jobs(*plan).size(), 30U);
}

}  // namespace
}  // namespace gsim::batch::plan_file_test
