#include "tests/cam/cutting/cut_path.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace gsim::cutting {

using geometry::Edge;

drawing::Drawing drawing_of(const std::vector<geometry::Contour>& contours) {
    drawing::Drawing drawing;
    for (const geometry::Contour& contour : contours) {
        const auto source = static_cast<std::uint32_t>(drawing.entities.size());
        drawing.entities.push_back({"piece", std::to_string(source), source + 1});
        drawing.drawn_contours.push_back(contour);
        for (geometry::Vertex& vertex : drawing.drawn_contours.back().vertices) vertex.source = source;
    }
    return drawing;
}

std::vector<JetPath> jet_ways(const path::Program& program) {
    std::vector<JetPath> ways;
    for (const path::Target& target : program.paths[program.root].targets) {
        JetPath jet_path;
        bool on = false;
        geometry::Point current;
        for (const path::Target& inner : program.paths[std::get<path::SubPath>(target).path].targets) {
            const auto& point = std::get<path::Point>(inner);
            const geometry::Point to{point.position_mm[0], point.position_mm[1]};
            EXPECT_FALSE(on && point.motion == path::MotionType::rapid);
            if (on && distance(current, to) > 0) {
                double bulge = 0;
                if (point.motion == path::MotionType::circular) {
                    const auto& arc = std::get<path::CenterArc>(point.arc);
                    bulge = arc.normal[2] * std::tan(arc.turn_deg * std::numbers::pi / 720);
                }
                append_edge(jet_path.jet_path, {current, to, bulge}, 0);
            }
            for (const std::string& action : point.actions) {
                if (action == "waterjet_on") {
                    on = true;
                    jet_path.pierce = to;
                }
                if (action == "waterjet_off") on = false;
            }
            current = to;
        }
        EXPECT_FALSE(on);
        ways.push_back(std::move(jet_path));
    }
    return ways;
}

}  // namespace gsim::cutting
