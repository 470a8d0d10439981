#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/studio/engine/asked.h"

namespace gsim::studio {
namespace {

using nlohmann::json;
using testing::HasSubstr;

// Returns a tent of two edges that runs back along the ground: walls tilted by 30 degrees, 6 mm deep.
engine::Contours tent() {
    using Vec3 = engine::Contours::Vec3;
    const Vec3 along{0.5, 0, -std::sqrt(3) / 2};
    engine::Contours::Contour contour{.face = "the plane face #7 at (5, 0, 0)", .is_hole = true};
    const auto edge = [&](const std::string& label, const std::vector<Vec3>& places) {
        engine::Contours::Edge new_edge{.name = "edge " + label, .label = label};
        for (const Vec3& position : places)
            new_edge.points.push_back(
                {.position_mm = position, .normal = {0, 0, 1}, .along_wall = along, .depth_mm = 6});
        return new_edge;
    };
    contour.edges = {edge("#11", {{0, 0, 0}, {30, 40, 0}, {60, 0, 0}}), edge("#12", {{60, 0, 0}, {0, 0, 0}})};
    return {.contours = {contour}, .notes = {"3 contours look to another side"}};
}

struct Asked {
    std::vector<Frame> frames;
    std::string file;
    engine::ContourSelection selection;
};

Asked ask(const json& request) {
    Asked request_json;
    engine::Host host;
    host.files = engine::Files::given([](const std::string&) { return std::nullopt; });
    host.read_contours = [&](const std::string& file, const engine::ContourSelection& selection) {
        request_json.file = file;
        request_json.selection = selection;
        return tl::expected<engine::Contours, std::string>(tent());
    };
    handle_request(request.dump(), host,
                   [&](const std::string& bytes) { request_json.frames.push_back(read_frame(bytes)); });
    return request_json;
}

std::string error(json request) {
    request["do"] = "contours";
    return make_error(request.dump());
}

TEST(ContoursForm, ListsCuttableContours) {
    const Asked request_json =
        ask({{"do", "contours"},
             {"drawing", "part.step"},
             {"curve_tolerance_mm", 0.25},
             {"contours", {{"kind", "all"}, {"side", "-x"}, {"faces", {"red"}}, {"axis", "normal"}}}});
    EXPECT_EQ(request_json.file, "part.step");
    EXPECT_EQ(request_json.selection.kind, "all");
    EXPECT_EQ(request_json.selection.side, "-x");
    EXPECT_EQ(request_json.selection.faces, std::vector<std::string>{"red"});
    EXPECT_EQ(request_json.selection.tolerance_mm, 0.25);
    EXPECT_FALSE(request_json.selection.along_walls);
    ASSERT_EQ(filter_frames(request_json.frames, "contours").size(), 1U) << last(request_json.frames).header;
    const Frame list = filter_frames(request_json.frames, "contours").front();
    ASSERT_EQ(list.header["contours"].size(), 1U);
    const json& contour = list.header["contours"][0];
    EXPECT_EQ(contour["face"], "the plane face #7 at (5, 0, 0)");
    EXPECT_EQ(contour["is_hole"], true);
    EXPECT_EQ(contour["is_open"], false);
    EXPECT_EQ(contour["edges"], (json{"#11", "#12"}));
    EXPECT_NEAR(contour["length_mm"].get<double>(), 50 + 50 + 60, 1e-9);
    EXPECT_NEAR(contour["depth_mm"].get<double>(), 6, 1e-9);
    EXPECT_NEAR(contour["tilt_deg"].get<double>(), 30, 1e-9);
    // Each position once, and the first one again at the end.
    EXPECT_EQ(contour["points"], 4);
    EXPECT_EQ(list.column<double>("lines"), (std::vector<double>{0, 0, 0, 30, 40, 0, 60, 0, 0, 0, 0, 0}));
    EXPECT_EQ(list.header["notes"], json{"3 contours look to another side"});
    EXPECT_EQ(last(request_json.frames).is(), "done");
}

TEST(ContoursForm, RejectsInvalidRequests) {
    EXPECT_EQ(error({{"drawing", "part.step"}}), "contours of a part needs 'contours'");
    EXPECT_THAT(error({{"contours", {{"kind", "holes"}}}}), HasSubstr("'drawing'"));
    EXPECT_THAT(error({{"drawing", "part.step"}, {"contours", "holes"}}),
                HasSubstr("'contours' must be an object, not of type string"));
    EXPECT_EQ(error({{"drawing", "part.step"}, {"contours", {{"kind", "walls"}}}}),
              "'kind' must be one of holes, outlines, all, edges, not 'walls'");
    EXPECT_THAT(error({{"drawing", "part.step"}, {"contours", {{"kind", "holes"}}}, {"kerf_mm", 1}}),
                HasSubstr("unknown key 'kerf_mm' of contours of a part"));
    // A page without a reader says what it reads.
    EXPECT_EQ(error({{"drawing", "part.step"}, {"contours", {{"kind", "holes"}}}}),
              "part.step: STEP and IGES files are not supported here, only DXF and SVG files");
    EXPECT_THAT(error({{"drawing", "part.svg"}, {"contours", {{"kind", "holes"}}}}),
                HasSubstr("--contours applies to STEP and IGES files"));
}

}  // namespace
}  // namespace gsim::studio
