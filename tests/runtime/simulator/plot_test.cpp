#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "base/os/child_process.h"
#include "engine/system/picture.h"
#include "runtime/outputs/plot_script.h"
#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::plot_test {
namespace {

namespace fs = std::filesystem;
using engine::Picture;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class PlotTest : public testing::Test {
  protected:
    PlotTest() {
        std::string name = (fs::temp_directory_path() / "plot_test_XXXXXX").string();
        folder = ::mkdtemp(name.data());
    }
    ~PlotTest() override { fs::remove_all(folder); }

    void draw_something() {
        data.begin(joints(0, 0));
        data.on_segment(line(1, 0, joints(0, 0), joints(100, 0)), {.kind = MoveKind::rapid});
        data.on_segment(line(2, 2.5, joints(100, 0), joints(100, 100)), {.kind = MoveKind::linear});
        data.on_segment(arc(3, 5, 0, 100, 100, 0, 180), {.kind = MoveKind::arc_ccw, .process_on = true});
    }
    static std::string content(const fs::path& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    Result<void> draw(const fs::path& path, std::string_view title) const {
        return Picture::picture_for_file(path).and_then([&](const Picture& picture) {
            const auto format = picture.bitmap() ? PictureFormat::png : PictureFormat::svg;
            return picture.draw(plot_script(data, format, title));
        });
    }
    bool has_gnuplot() const {
        std::FILE* null = std::fopen("/dev/null", "r+");
        const bool has = os::run_child({"gnuplot", "--version"}, null, null).has_value();
        std::fclose(null);
        return has;
    }

    machine::Machine machine = af5();
    PlotData data{machine};
    fs::path folder;
};

TEST_F(PlotTest, DrawsPngAndSvg) {
    if (!has_gnuplot()) GTEST_SKIP() << "no gnuplot here";
    draw_something();
    const auto png = draw(folder / "a b.png", "it's `a` \"title\" \\ $x\n{/*2 y}");
    ASSERT_TRUE(png) << png.error().message;
    EXPECT_THAT(content(folder / "a b.png"), StartsWith("\x89PNG"));
    const auto svg = draw(folder / "a.svg", "it's `a` title");
    ASSERT_TRUE(svg) << svg.error().message;
    EXPECT_THAT(content(folder / "a.svg"), HasSubstr("it's `a` title"));
    EXPECT_THAT(content(folder / "a.svg"), HasSubstr("</svg>"));
}

TEST_F(PlotTest, DrawsRunWithoutMoves) {
    if (!has_gnuplot()) GTEST_SKIP() << "no gnuplot here";
    data.begin(joints(0, 0));
    const auto drawn = draw(folder / "a.png", "");
    EXPECT_TRUE(drawn) << drawn.error().message;
}

TEST_F(PlotTest, DrawsOneCurvePerStyle) {
    draw_something();
    const std::string script = plot_script(data, PictureFormat::svg, "t");
    EXPECT_THAT(script, HasSubstr("$rapid << EOD\n0 0\n"));
    EXPECT_THAT(script, HasSubstr("$feed << EOD\n100 0\n100 100\nEOD\n"));
    EXPECT_THAT(script, HasSubstr("$jet << EOD\n100 100\n"));
    EXPECT_THAT(script, HasSubstr("title 'jet on'"));
}

TEST_F(PlotTest, HoldsFeedUntilNextOne) {
    data.begin(joints(0, 0));
    data.on_segment(line(1, 0, joints(0, 0), joints(100, 0)),
                    {.kind = MoveKind::linear, .feed_per_min = 3000});
    data.on_segment(line(2, 2.5, joints(100, 0), joints(0, 0)), {.kind = MoveKind::rapid});
    data.on_segment(line(3, 5, joints(0, 0), joints(100, 0)),
                    {.kind = MoveKind::linear, .feed_per_min = 2400});
    EXPECT_THAT(plot_script(data, PictureFormat::svg, "t"),
                HasSubstr("$programmed << EOD\n0 50\n2.5 50\n5 50\n\n5 40\n7.5 40\nEOD\n"));
}

TEST_F(PlotTest, DrawsFeedAndNearbyLimit) {
    data.begin(joints(0, 0));
    data.on_segment(line(1, 0, joints(0, 0), joints(100, 0)),
                    {.kind = MoveKind::linear, .feed_per_min = 6000});
    const std::string far = plot_script(data, PictureFormat::svg, "t");
    EXPECT_THAT(far, HasSubstr("$programmed << EOD\n0 100\n2.5 100\nEOD\n"));
    EXPECT_THAT(far, HasSubstr("set yrange [0:108]"));
    EXPECT_THAT(far, HasSubstr("set yrange [-108:108]"));  // of +-100 mm/s2
    EXPECT_THAT(far, Not(HasSubstr("limit of feed moves")));
    machine.path.max_acceleration_mm_s2 = 150;
    const std::string near = plot_script(data, PictureFormat::svg, "t");
    EXPECT_THAT(near, HasSubstr("-150 with lines"));
    EXPECT_THAT(near, HasSubstr("set yrange [-162:162]"));
}

TEST_F(PlotTest, RejectsUnknownFileExtension) {
    EXPECT_EQ(Picture::picture_for_file("a.pdf").error().message,
              "cannot draw 'a.pdf': the name of a picture must end in .svg or .png");
}

TEST_F(PlotTest, RejectsMissingFolder) {
    const std::string name = (folder / "no" / "a.png").string();
    EXPECT_EQ(Picture::picture_for_file(name).error().message,
              "cannot write '" + name + "': No such file or directory");
}

TEST_F(PlotTest, CheckOfNameLeavesNoFile) {
    if (!has_gnuplot()) GTEST_SKIP() << "no gnuplot here";
    EXPECT_TRUE(Picture::picture_for_file(folder / "a.png"));
    EXPECT_TRUE(fs::is_empty(folder));
}

// 400 mm/s in rapids, 40 mm/s and 100 mm/s2 in feed moves.
TEST_F(PlotTest, RapidsHaveSeparateScale) {
    data.begin(joints(0, 0));
    motion::Segment rapid = line(1, 0, joints(0, 0), joints(100, 0));
    rapid.master = motion::TimeLaw::fastest(100, 400, 8000);
    rapid.duration_s = rapid.master.duration_s();
    data.on_segment(rapid, {.kind = MoveKind::rapid});
    motion::Segment feed = line(2, rapid.duration_s, joints(100, 0), joints(100, 100));
    feed.master = motion::TimeLaw::fastest(100, 40, 100);
    feed.duration_s = feed.master.duration_s();
    data.on_segment(feed, {.kind = MoveKind::linear, .feed_per_min = 2400, .process_on = true});
    const std::string script = plot_script(data, PictureFormat::svg, "t");
    EXPECT_THAT(script, HasSubstr("set yrange [0:43.2]\n"));
    EXPECT_THAT(script, HasSubstr("set y2range [0:432]\n"));
    EXPECT_THAT(script, HasSubstr("set yrange [-108:108]\n"));
    EXPECT_THAT(script, HasSubstr("set y2range [-8640:8640]\n"));
    EXPECT_THAT(script, HasSubstr("$speed_rapid axes x1y2 with lines"));
    EXPECT_THAT(script, HasSubstr("set y2label 'rapid (mm/s)'"));
}

TEST_F(PlotTest, RapidsAloneUseLeftScale) {
    data.begin(joints(0, 0));
    data.on_segment(line(1, 0, joints(0, 0), joints(100, 0)), {.kind = MoveKind::rapid});
    const std::string script = plot_script(data, PictureFormat::svg, "t");
    EXPECT_THAT(script, HasSubstr("set yrange [0:54]\n"));
    EXPECT_THAT(script, Not(HasSubstr("y2range")));
}

TEST_F(PlotTest, MarksPiercesCollisionsAndAlarm) {
    draw_something();
    data.on_segment(line(4, 20, joints(-100, 100), joints(-100, 0)), {.kind = MoveKind::linear});
    data.on_segment(line(5, 30, joints(-100, 0), joints(7, 0)),
                    {.kind = MoveKind::linear, .process_on = true});
    const std::string before = plot_script(data, PictureFormat::svg, "t");
    EXPECT_THAT(before, HasSubstr("$pierce << EOD\n100 100\n-100 0\nEOD\n"));
    EXPECT_THAT(before, Not(HasSubstr("title 'alarm'")));
    EXPECT_THAT(before, Not(HasSubstr("title 'collision'")));
    data.mark_collision(joints(5, 6));
    data.mark_alarm();
    const std::string script = plot_script(data, PictureFormat::svg, "t");
    EXPECT_THAT(script, HasSubstr("$collision << EOD\n5 6\nEOD\n"));
    EXPECT_THAT(script, HasSubstr("$alarm << EOD\n7 0\nEOD\n"));
    for (const char* title : {"'pierce'", "'collision'", "'alarm'"})
        EXPECT_THAT(script, HasSubstr(std::string("title ") + title));
}

TEST(ChildProcess, ReportsStartExitAndSignalErrors) {
    std::FILE* null = std::fopen("/dev/null", "r+");
    EXPECT_EQ(os::run_child({"no-such-program"}, null, null).error().message,
              "cannot run no-such-program: No such file or directory");
    EXPECT_EQ(os::run_child({"sh", "-c", "echo; echo why >&2; exit 3"}, null, null).error().message,
              "sh failed: why");
    EXPECT_EQ(os::run_child({"sh", "-c", "kill -9 $$"}, null, null).error().message,
              "sh was terminated by signal 9");
    std::fclose(null);
}

}  // namespace
}  // namespace gsim::simulation::plot_test
