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
    using Triple = engine::Contours::Triple;
    const Triple along{0.5, 0, -std::sqrt(3) / 2};
    engine::Contours::Contour contour{.face = "the plane face #7 at (5, 0, 0)", .is_hole = true};
    const auto edge = [&](const std::string& label, const std::vector<Triple>& places) {
        engine::Contours::Edge made{.name = "edge " + label, .label = label};
        for (const Triple& place : places)
            made.points.push_back(
                {.position_mm = place, .normal = {0, 0, 1}, .along_wall = along, .depth_mm = 6});
        return made;
    };
    contour.edges = {edge("#11", {{0, 0, 0}, {30, 40, 0}, {60, 0, 0}}), edge("#12", {{60, 0, 0}, {0, 0, 0}})};
    return {.contours = {contour}, .notes = {"3 contours look to another side"}};
}

struct Asked {
    std::vector<Frame> frames;
    std::string file;
    engine::ContourChoice choice;
};

Asked ask(const json& request) {
    Asked asked;
    engine::Host host;
    host.files = engine::Files::given([](const std::string&) { return std::nullopt; });
    host.read_contours = [&](const std::string& file, const engine::ContourChoice& choice) {
        asked.file = file;
        asked.choice = choice;
        return tl::expected<engine::Contours, std::string>(tent());
    };
    serve(request.dump(), host, [&](const std::string& bytes) { asked.frames.push_back(read_frame(bytes)); });
    return asked;
}

std::string fault(json request) {
    request["do"] = "contours";
    return failure_of(request.dump());
}

TEST(ContoursForm, ListsWhatCouldBeCut) {
    const Asked asked =
        ask({{"do", "contours"},
             {"drawing", "part.step"},
             {"curve_tolerance_mm", 0.25},
             {"contours", {{"kind", "all"}, {"side", "-x"}, {"faces", {"red"}}, {"axis", "normal"}}}});
    EXPECT_EQ(asked.file, "part.step");
    EXPECT_EQ(asked.choice.kind, "all");
    EXPECT_EQ(asked.choice.side, "-x");
    EXPECT_EQ(asked.choice.faces, std::vector<std::string>{"red"});
    EXPECT_EQ(asked.choice.tolerance_mm, 0.25);
    EXPECT_FALSE(asked.choice.along_walls);
    ASSERT_EQ(of_kind(asked.frames, "contours").size(), 1U) << last(asked.frames).header;
    const Frame list = of_kind(asked.frames, "contours").front();
    ASSERT_EQ(list.header["contours"].size(), 1U);
    const json& contour = list.header["contours"][0];
    EXPECT_EQ(contour["face"], "the plane face #7 at (5, 0, 0)");
    EXPECT_EQ(contour["is_hole"], true);
    EXPECT_EQ(contour["is_open"], false);
    EXPECT_EQ(contour["edges"], (json{"#11", "#12"}));
    EXPECT_NEAR(contour["length_mm"].get<double>(), 50 + 50 + 60, 1e-9);
    EXPECT_NEAR(contour["depth_mm"].get<double>(), 6, 1e-9);
    EXPECT_NEAR(contour["lean_deg"].get<double>(), 30, 1e-9);
    // Each position once, and the first one again at the end.
    EXPECT_EQ(contour["points"], 4);
    EXPECT_EQ(list.column<double>("lines"), (std::vector<double>{0, 0, 0, 30, 40, 0, 60, 0, 0, 0, 0, 0}));
    EXPECT_EQ(list.header["notes"], json{"3 contours look to another side"});
    EXPECT_EQ(last(asked.frames).is(), "done");
}

TEST(ContoursForm, RefusesWhatItDoesNotKnow) {
    EXPECT_EQ(fault({{"drawing", "part.step"}}), "contours of a part needs 'contours'");
    EXPECT_THAT(fault({{"contours", {{"kind", "holes"}}}}), HasSubstr("'drawing'"));
    EXPECT_THAT(fault({{"drawing", "part.step"}, {"contours", "holes"}}),
                HasSubstr("'contours' should be an object"));
    EXPECT_EQ(fault({{"drawing", "part.step"}, {"contours", {{"kind", "walls"}}}}),
              "'kind' should be one of holes, outlines, all, edges, not 'walls'");
    EXPECT_THAT(fault({{"drawing", "part.step"}, {"contours", {{"kind", "holes"}}}, {"kerf_mm", 1}}),
                HasSubstr("there is no key 'kerf_mm'"));
    // A page without a reader says what it reads.
    EXPECT_EQ(fault({{"drawing", "part.step"}, {"contours", {{"kind", "holes"}}}}),
              "part.step: STEP and IGES files are not read here; DXF and SVG files are");
    EXPECT_THAT(fault({{"drawing", "part.svg"}, {"contours", {{"kind", "holes"}}}}),
                HasSubstr("--contours is for STEP and IGES files"));
}

}  // namespace
}  // namespace gsim::studio
