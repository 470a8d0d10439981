#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/text/json.h"
#include "tests/studio/engine/asked.h"

namespace gsim::studio {
namespace {

using nlohmann::json;
using testing::HasSubstr;

// A square of 100 mm.
const char* const kSquareSvg =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="200mm" viewBox="0 0 200 200">)"
    R"(<path d="M20,20 h100 v100 h-100 z"/></svg>)";

// A machine with a pin on the TCP as its only body, and a post in the area of the square's cut.
const char* const kPin = R"([machine]
name = "pin"
inverse = "numeric"
[[axis]]
letter = "X"
kind = "linear"
max_mm = 1000
direction = "x"
[[axis]]
letter = "Y"
kind = "linear"
max_mm = 1000
direction = "y"
[[axis]]
letter = "Z"
kind = "linear"
max_mm = 400
direction = "z"
[[shape]]
name = "pin"
on = "tool"
shape = { cylinder_mm = [4, 60] }
frame = { z_mm = 30 }
)";
const char* const kPost = R"([cell]
name = "post"
machine = "pin.toml"
[[object]]
name = "post"
shape = { cylinder_mm = [20, 50] }
frame = { x_mm = 120, y_mm = 100, z_mm = 25 }
)";

Files files_of_drawings() {
    return {{"square.svg", kSquareSvg},
            {"plate.svg", sample("plate.svg")},
            {"mine.toml", sample("materials.toml")},
            {"part.step", "ISO-10303-21;"},
            {"pin.toml", kPin},
            {"post.toml", kPost}};
}

std::string drawing_request(json request_json) {
    request_json["do"] = "drawing";
    return request_json.dump();
}

json by_figures(const std::string& drawing) {
    return {{"drawing", drawing}, {"speed_mm_min", 600}, {"kerf_mm", 1}, {"pierce_s", 2}};
}

Frame path_of(const json& request_json) {
    const auto frames = request_frames(drawing_request(request_json), files_of_drawings());
    const auto paths = filter_frames(frames, "path");
    return paths.empty() ? last(frames) : paths.front();
}

TEST(DrawingForm, ReturnsPathAndMetricsOfSquare) {
    const Frame path = path_of(by_figures("square.svg"));
    ASSERT_TRUE(path.columns.contains("text")) << path.header;
    const json metrics = path.header["figures"];
    EXPECT_EQ(metrics["outlines"], 1);
    EXPECT_EQ(metrics["pierces"], 1);
    EXPECT_GT(metrics["cut_mm"], 400);
    EXPECT_LT(metrics["cut_mm"], 440);
    EXPECT_NEAR(metrics["cut_s"].get<double>(), metrics["cut_mm"].get<double>() / 10, 3);
    EXPECT_TRUE(path.header["job"].is_null());
    EXPECT_EQ(path.header["job_text"], "");
    EXPECT_THAT(path.header["summary"].get<std::string>(), HasSubstr("1 contours, 1 pierces"));
    const auto json_path = text::parse_json<json>(path.columns.at("text"));
    EXPECT_EQ(json_path["name"], "square");
}

TEST(DrawingForm, MaterialDeterminesFeedsAndPrice) {
    const Frame path = path_of({{"drawing", "plate.svg"}, {"material", "aluminum"}, {"thickness_mm", 12}});
    ASSERT_TRUE(path.header.contains("job")) << path.header;
    const json job = path.header["job"];
    EXPECT_EQ(job["thickness_mm"], 12);
    EXPECT_EQ(job["currency"], "EUR");
    EXPECT_GT(job["price"], 0);
    EXPECT_GT(job["jet_s"], path.header["figures"]["cut_s"]);  // it pierces, too
    EXPECT_THAT(path.header["job_text"].get<std::string>(), HasSubstr("machinability"));
    json finer = {{"drawing", "plate.svg"},
                  {"material", "aluminum"},
                  {"thickness_mm", 12},
                  {"quality", 5},
                  {"materials", "mine.toml"}};
    EXPECT_LT(path_of(finer).header["job"]["speed_mm_min"], job["speed_mm_min"]);
}

TEST(DrawingForm, AppliesTaperCompensationAndDynamicPierce) {
    json request_json = {{"drawing", "plate.svg"}, {"material", "aluminum"}, {"thickness_mm", 12}};
    const auto axes = [&] {
        const json program = text::parse_json<json>(path_of(request_json).columns.at("text"));
        std::set<json> found;
        for (const json& path : program["paths"]) {
            for (const json& target : path["targets"]) {
                if (target.contains("tool_axis")) found.insert(target["tool_axis"]);
            }
        }
        return found;
    };
    EXPECT_LE(axes().size(), 1U);  // upright
    request_json["taper_compensation"] = true;
    EXPECT_GT(axes().size(), 10U);
    request_json["taper_compensation"] = false;
    const double rests_s = path_of(request_json).header["job"]["jet_s"];
    request_json["dynamic_pierce"] = true;
    EXPECT_LT(path_of(request_json).header["job"]["jet_s"].get<double>(), rests_s);
}

// From the drawing to the machine: all three requests in sequence.
TEST(DrawingForm, PathCanBeWrittenAndRun) {
    json request_json = by_figures("plate.svg");
    request_json["origin_mm"] = {200, 400, 50};
    const Frame path = path_of(request_json);
    ASSERT_TRUE(path.columns.contains("text")) << path.header;
    const Files path_file{{"plate.path.json", path.columns.at("text")}};
    const auto written = request_frames(R"({"do": "write", "path": "plate.path.json"})", path_file);
    ASSERT_EQ(filter_frames(written, "program").size(), 1U) << last(written).header;
    const Frame program = filter_frames(written, "program").at(0);
    const auto frames =
        request_frames(R"({"do": "run", "program": "plate.nc"})", {{"plate.nc", program.columns.at("text")}});
    ASSERT_EQ(last(frames).is(), "done") << last(frames).header;
    const json report = filter_frames(frames, "report").at(0).header["report"];
    EXPECT_EQ(report["status"], "completed");
    const double min_s =
        path.header["figures"]["cut_s"].get<double>() + 2 * path.header["figures"]["pierces"].get<double>();
    EXPECT_GT(report["cycle_time_s"].get<double>(), min_s);
}

TEST(DrawingForm, RejectsInvalidRequests) {
    const auto error = [](const json& request_json) {
        return make_error(drawing_request(request_json), files_of_drawings());
    };
    EXPECT_EQ(error({{"material", "lead"}}), "a drawing needs 'drawing'");
    EXPECT_EQ(error({{"drawing", "square.svg"}}),
              "a drawing needs 'material' and 'thickness_mm', or 'speed_mm_min' and 'kerf_mm'");
    EXPECT_EQ(error({{"drawing", "square.svg"}, {"colour", 1}, {"material", "lead"}}),
              "unknown key 'colour' of a drawing");
    json request_json = by_figures("square.svg");
    request_json["up"] = "w";
    EXPECT_EQ(error(request_json), "'up' must be one of x, y, z, -x, -y, -z, not 'w'");
    request_json = by_figures("square.svg");
    request_json["origin_mm"] = {1, 2};
    EXPECT_EQ(error(request_json), "'origin_mm' must be three numbers, not 2");
    request_json = by_figures("square.svg");
    request_json["unit_mm"] = 0;
    EXPECT_THAT(error(request_json), HasSubstr("'unit_mm' must be from 1e-06 to 1000000, not 0"));
    EXPECT_EQ(error(by_figures("part.step")),
              "part.step: STEP and IGES files are not supported here, only DXF and SVG files");
    request_json = by_figures("part.step");
    request_json["contours"] = {{"kind", "holes"}, {"side", "up"}};
    EXPECT_EQ(error(request_json), "'side' must be one of x, y, z, -x, -y, -z, not 'up'");
    request_json["contours"] = {{"kind", "holes"}, {"colour", "red"}};
    EXPECT_EQ(error(request_json), "unknown key 'colour' of contours");
    request_json["contours"] = {{"kind", "holes"}, {"axis", "wall"}, {"tilt_angle_deg", 5}};
    EXPECT_THAT(error(request_json), HasSubstr("--tilt-angle is relative to the face normal"));
    request_json["contours"] = {{"kind", "holes"}};
    request_json["taper_compensation"] = true;
    EXPECT_THAT(error(request_json), HasSubstr("--taper-compensation"));
    request_json = by_figures("square.svg");
    request_json["contours"] = {{"kind", "holes"}};
    EXPECT_THAT(error(request_json), HasSubstr("--contours applies to STEP and IGES files"));
    EXPECT_THAT(error({{"drawing", "plate.svg"}, {"material", "aluminium"}, {"thickness_mm", 12}}),
                HasSubstr("did you mean \"aluminum\"?"));
    EXPECT_THAT(error(by_figures("none.svg")), HasSubstr("none.svg"));
}

TEST(DrawingForm, ReportsCollisionsWithCell) {
    const auto error = [](const json& request_json) {
        return make_error(drawing_request(request_json), files_of_drawings());
    };
    json request_json = by_figures("square.svg");
    request_json["place"] = {{"cell", "post.toml"}};
    EXPECT_THAT(error(request_json), HasSubstr("'pin' touches 'post'"));
    request_json["origin_mm"] = {200, 0, 0};
    const Frame path = path_of(request_json);
    ASSERT_TRUE(path.header.contains("figures")) << path.header;
    EXPECT_EQ(path.header["figures"]["linking_paths"], 2);
    EXPECT_THAT(path.header["summary"].get<std::string>(), HasSubstr("; there are no collisions, and"));
    request_json["place"] = {{"room", "post.toml"}};
    EXPECT_EQ(error(request_json), "unknown key 'room' of place");
    request_json["place"] = {{"cell", "none.toml"}};
    EXPECT_THAT(error(request_json), HasSubstr("none.toml"));
}

TEST(MaterialsForm, ListsMaterialsOfFile) {
    const json built_in =
        filter_frames(request_frames(R"({"do": "materials"})"), "materials").at(0).header["materials"];
    EXPECT_GT(built_in.size(), 5U);
    EXPECT_EQ(built_in[0]["name"], "aluminum");
    EXPECT_EQ(built_in[0]["machinability"], 213);
    std::string mine = sample("materials.toml") +
                       "[[material]]\nname = \"slate\"\nlike = \"granite\"\n[[material]]\nname = \"oak\"\n"
                       "measured = { pressure_mpa = 345.0, orifice_mm = 0.35, mixing_tube_mm = 1.0, "
                       "abrasive_g_min = 400.0, abrasive_factor = 1.0, speed_mm_min = 1000.0, "
                       "thickness_mm = 20.0, quality = 3.0 }\n";
    const auto frames =
        request_frames(R"({"do": "materials", "materials": "mine.toml"})", {{"mine.toml", mine}});
    ASSERT_EQ(filter_frames(frames, "materials").size(), 1U) << last(frames).header;
    const json list = filter_frames(frames, "materials").at(0).header["materials"];
    ASSERT_EQ(list.size(), built_in.size() + 2);
    const json& slate = list[list.size() - 2];
    const auto granite =
        std::find_if(list.begin(), list.end(), [](const json& each) { return each["name"] == "granite"; });
    EXPECT_EQ(slate["like"], "granite");
    EXPECT_EQ(slate["machinability"], (*granite)["machinability"]);
    EXPECT_EQ(list.back()["measured"], true);
    EXPECT_GT(list.back()["machinability"], 0);
    EXPECT_THAT(make_error(R"({"do": "materials", "materials": "none.toml"})"), HasSubstr("none.toml"));
}

}  // namespace
}  // namespace gsim::studio
