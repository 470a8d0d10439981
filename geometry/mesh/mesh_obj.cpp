// OBJ (Wavefront Advanced Visualizer, appendix B): its vertices and faces.

#include <algorithm>
#include <array>
#include <charconv>

#include <fmt/format.h>

#include "geometry/mesh/mesh_text.h"

namespace gsim::cell {

using std::string_view_literals::operator""sv;

namespace {

// Statements without effect on the surface. Free-form surfaces are not among them, because they would be
// missing.
constexpr std::array kIgnoredKeywords{"vt"sv,     "vn"sv,     "vp"sv,         "o"sv,        "g"sv,
                                      "s"sv,      "mg"sv,     "l"sv,          "p"sv,        "usemtl"sv,
                                      "lod"sv,    "mtllib"sv, "bevel"sv,      "c_interp"sv, "d_interp"sv,
                                      "usemap"sv, "maplib"sv, "shadow_obj"sv, "trace_obj"sv};

class ObjReader {
  public:
    explicit ObjReader(std::string_view text) : words_(text) {}

    Result<TriangleSoup> read() {
        do {
            const std::string_view word = words_.next_in_line();
            if (word.empty() || word.starts_with('#')) continue;
            if (word == "v") {
                vertex();
            } else if (word == "f") {
                face();
            } else if (std::find(kIgnoredKeywords.begin(), kIgnoredKeywords.end(), word) ==
                       kIgnoredKeywords.end()) {
                fail(fmt::format("'{:.20}' is not supported, only vertices (v) and faces (f)", word));
            }
        } while (!error_ && words_.skip_line());
        if (!error_) return std::move(soup_);
        return tl::unexpected(*error_);
    }

  private:
    void fail(std::string_view message) {
        if (!error_) error_ = fmt::format(":{}: {}", words_.line(), message);
    }
    void vertex() {
        Eigen::Vector3d at;
        for (double& coordinate : at) {
            const std::string_view word = words_.next_in_line();
            const auto value = parse_number(word);
            if (!value) return fail(fmt::format("a vertex must have three numbers, not '{:.20}'", word));
            coordinate = *value;
        }
        if (soup_.vertices.size() >= 3 * kMaxTriangles) return fail("too many vertices");
        soup_.vertices.push_back(at);
    }
    // Reads "7", "7/1", "7//3" or "7/1/3", counted from 1, or from the last one backwards.
    std::optional<std::uint32_t> index(std::string_view word) {
        const std::string_view number = word.substr(0, word.find('/'));
        long long value = 0;
        const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
        const auto count = static_cast<long long>(soup_.vertices.size());
        const bool read = error == std::errc{} && end == number.data() + number.size();
        if (!read || value == 0 || value > count || value < -count) {
            fail(fmt::format("'{:.20}' is not a vertex; {} are defined above this line", word, count));
            return std::nullopt;
        }
        return static_cast<std::uint32_t>(value > 0 ? value - 1 : count + value);
    }
    // A polygon becomes a fan of triangles, because it is flat and convex.
    void face() {
        std::array<std::uint32_t, 2> corners{};
        std::size_t count = 0;
        for (std::string_view word = words_.next_in_line(); !word.empty(); word = words_.next_in_line()) {
            const auto corner = index(word);
            if (!corner) return;
            if (count >= 2) {
                soup_.triangles.push_back({corners[0], corners[1], *corner});
                corners[1] = *corner;
            } else {
                corners[count] = *corner;
            }
            ++count;
        }
        if (count < 3) fail("a face must have at least three vertices");
        if (soup_.triangles.size() > kMaxTriangles)
            fail(fmt::format("more than {} triangles", kMaxTriangles));
    }

    WordReader words_;
    TriangleSoup soup_;
    std::optional<Error> error_;
};

}  // namespace

Result<TriangleSoup> read_obj(std::string_view text) {
    return ObjReader(text).read();
}

}  // namespace gsim::cell
