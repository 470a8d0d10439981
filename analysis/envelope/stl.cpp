#include "analysis/envelope/stl.h"

#include <Eigen/Geometry>

#include "base/bits.h"

namespace gsim::envelope {

namespace {

constexpr std::size_t kHeaderBytes = 80;

void append_number(std::string& bytes, std::uint32_t number, int count = 4) {
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xffU);
}

void append_vector(std::string& bytes, const Eigen::Vector3f& vector) {
    for (const float value : vector) append_number(bytes, bits_as<std::uint32_t>(value));
}

}  // namespace

std::string to_stl(const Surface& surface) {
    std::string triangles;
    triangles.reserve(surface.triangles.size() * 50);
    std::uint32_t count = 0;
    for (const auto& corners : surface.triangles) {
        const Eigen::Vector3f a = surface.points_mm[corners[0]].cast<float>();
        const Eigen::Vector3f b = surface.points_mm[corners[1]].cast<float>();
        const Eigen::Vector3f c = surface.points_mm[corners[2]].cast<float>();
        if (a == b || b == c || c == a) continue;
        append_vector(triangles, (b - a).cross(c - a).stableNormalized());
        for (const Eigen::Vector3f* corner : {&a, &b, &c}) append_vector(triangles, *corner);
        append_number(triangles, 0, 2);
        ++count;
    }
    std::string bytes = "gsim: volume that the TCP reaches, mm";
    bytes.resize(kHeaderBytes, ' ');
    append_number(bytes, count);
    return bytes + triangles;
}

}  // namespace gsim::envelope
