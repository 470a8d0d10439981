// gsim-calibrate: a machine file from what a machine did.

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "calibrate/geometry_command.h"
#include "calibrate/servo_command.h"
#include "calibrate/times_command.h"

namespace gsim::calibrate {

namespace {

constexpr int kGood = 0;
constexpr int kUsage = 2;

int run(const std::vector<std::string>& words) {
    if (!words.empty() && words.front() == "times") return run_times({words.begin() + 1, words.end()});
    if (!words.empty() && words.front() == "geometry") return run_geometry({words.begin() + 1, words.end()});
    if (!words.empty() && words.front() == "servo") return run_servo({words.begin() + 1, words.end()});
    const bool asks = !words.empty() && (words.front() == "--help" || words.front() == "-h");
    fmt::print(asks ? stdout : stderr,
               "usage: gsim-calibrate times RUNS.csv --machine FILE [options]\n"
               "       gsim-calibrate times --help\n"
               "       gsim-calibrate geometry TIPS.csv --machine FILE [options]\n"
               "       gsim-calibrate geometry --machine FILE --suggest N [options]\n"
               "       gsim-calibrate geometry --help\n"
               "       gsim-calibrate servo RECORD.csv --machine FILE [options]\n"
               "       gsim-calibrate servo --help\n");
    return asks ? kGood : kUsage;
}

}  // namespace

}  // namespace gsim::calibrate

int main(int argc, char** argv) {
    try {
        return gsim::calibrate::run(std::vector<std::string>(argv + 1, argv + argc));
    } catch (const std::exception& error) {
        fmt::print(stderr, "gsim-calibrate: {}\n", error.what());
        return 1;
    }
}
