// STL, as text and binary (StereoLithography Interface Specification, 3D Systems, 1989).

#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "base/bits.h"
#include "geometry/mesh/mesh_text.h"

namespace gsim::cell {

using Eigen::Vector3d;

namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kCountBytes = 4;
constexpr std::size_t kTriangleBytes = 50;
constexpr std::size_t kNormalBytes = 12;

std::uint32_t read_little_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (unsigned i = 0; i < 4; ++i)
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) << (8U * i);
    return value;
}

double read_float(std::string_view bytes, std::size_t offset) {
    return static_cast<double>(bits_as<float>(read_little_endian(bytes.substr(offset, 4))));
}

/// Reader of the facets of a text; it keeps the first error.
class TextReader {
  public:
    explicit TextReader(std::string_view text) : words_(text) {}

    Result<TriangleSoup> read() {
        expect("solid");
        words_.skip_line();  // its name
        while (!error_) {
            const std::string_view word = words_.next();
            if (word == "endsolid") {
                words_.skip_line();
                const std::string_view more = words_.next();  // some programs write several solids
                if (more.empty()) return std::move(soup_);
                if (more != "solid") fail("solid", more);
                words_.skip_line();
            } else if (word == "facet") {
                facet();
            } else {
                fail("facet' or 'endsolid", word);
            }
        }
        return tl::unexpected(*error_);
    }

  private:
    void fail(std::string_view expected_word, std::string_view found) {
        if (error_) return;
        const std::string what =
            found.empty() ? std::string("the file ends") : fmt::format("found '{:.20}'", found);
        error_ = fmt::format(":{}: '{}' is expected; {}", words_.line(), expected_word, what);
    }
    void expect(std::string_view expected_word) {
        if (error_) return;
        if (const std::string_view word = words_.next(); word != expected_word) fail(expected_word, word);
    }
    double number(std::string_view of) {
        if (error_) return 0;
        const std::string_view word = words_.next();
        const auto value = parse_number(word);
        if (!value) fail(of, word);
        return value.value_or(0);
    }
    Vector3d vertex() {
        expect("vertex");
        const double x = number("a coordinate");
        const double y = number("a coordinate");
        return {x, y, number("a coordinate")};
    }
    // The normal is not used, because some programs write unreasonable values.
    void facet() {
        expect("normal");
        for (int i = 0; i < 3 && !error_; ++i) {
            if (words_.next_in_line().empty()) fail("a normal of three numbers", "");
        }
        expect("outer");
        expect("loop");
        std::array<Vector3d, 3> corners;
        for (Vector3d& corner : corners) corner = vertex();
        expect("endloop");
        expect("endfacet");
        if (!error_) soup_.add(corners);
        if (soup_.triangles.size() > kMaxTriangles)
            error_ = fmt::format(": more than {} triangles", kMaxTriangles);
    }

    WordReader words_;
    TriangleSoup soup_;
    std::optional<Error> error_;
};

}  // namespace

bool is_stl_binary(std::string_view bytes) {
    if (bytes.size() < kHeaderBytes + kCountBytes) return false;
    const std::size_t count = read_little_endian(bytes.substr(kHeaderBytes));
    return bytes.size() == kHeaderBytes + kCountBytes + count * kTriangleBytes;
}

Result<TriangleSoup> read_stl_binary(std::string_view bytes) {
    if (bytes.size() < kHeaderBytes + kCountBytes) {
        return Unexpected(fmt::format(
            ": {} bytes are too few for an STL file, and it does not begin with 'solid'", bytes.size()));
    }
    const std::size_t count = read_little_endian(bytes.substr(kHeaderBytes));
    if (!is_stl_binary(bytes)) {
        return Unexpected(fmt::format(": a binary STL file of {} triangles must have {} bytes, not {}", count,
                                      kHeaderBytes + kCountBytes + count * kTriangleBytes, bytes.size()));
    }
    if (count > kMaxTriangles) return Unexpected(fmt::format(": more than {} triangles", kMaxTriangles));
    TriangleSoup soup;
    soup.vertices.reserve(3 * count);
    soup.triangles.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::string_view triangle =
            bytes.substr(kHeaderBytes + kCountBytes + i * kTriangleBytes, kTriangleBytes);
        std::array<Vector3d, 3> corners;
        std::size_t offset = kNormalBytes;
        for (Vector3d& corner : corners) {
            corner = {read_float(triangle, offset), read_float(triangle, offset + 4),
                      read_float(triangle, offset + 8)};
            offset += 12;
            if (corner.allFinite()) continue;
            return Unexpected(fmt::format(": triangle {} has a coordinate that is not finite", i + 1));
        }
        soup.add(corners);
    }
    return soup;
}

Result<TriangleSoup> read_stl_text(std::string_view text) {
    return TextReader(text).read();
}

}  // namespace gsim::cell
