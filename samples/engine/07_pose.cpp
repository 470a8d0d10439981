// Which axis values bring the TCP to a point, and which TCP position do axis values give?
// g++ -std=c++20 07_pose.cpp $(pkg-config --cflags --libs libgsim) -o example && ./example MACHINE.toml
#include <cstdio>

#include <gsim/engine/pose.h>

int main(int argc, char** argv) {
    using namespace gsim;
    if (argc != 2) return std::fprintf(stderr, "usage: example MACHINE.toml\n"), 2;
    engine::Request request;
    request.machine = argv[1];
    const auto machine = engine::Machine::read(request);
    if (!machine) return std::fprintf(stderr, "%s\n", machine.error().message.c_str()), 2;

    engine::PoseRequest point;
    point.tcp_mm = {400, 300, -50};
    point.tool_axis = {0.5, 0, 0.8660254};  // 30 deg from the vertical, towards X
    const auto inverse = engine::solve_pose(*machine, point);
    if (!inverse) return std::fprintf(stderr, "%s\n", inverse.error().message.c_str()), 1;
    std::printf("%zu solutions; the first one:", inverse->solutions.size());
    for (const double value : inverse->joints) std::printf(" %.3f", value + 0.0);
    std::printf("\n");

    engine::PoseRequest axes;
    axes.joints = inverse->joints;
    const auto forward = engine::solve_pose(*machine, axes);
    if (!forward) return std::fprintf(stderr, "%s\n", forward.error().message.c_str()), 1;
    std::printf("TCP at %.3f %.3f %.3f mm\n", forward->tcp_mm[0], forward->tcp_mm[1], forward->tcp_mm[2]);
    return 0;
}
