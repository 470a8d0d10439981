// gsim-bench-generate: writes the part programs that the benchmarks read. The same arguments give the same
// bytes on any machine: the random numbers come from a generator that the standard fixes, and only +, -, *, /
// and sqrt are used to compute the digits.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace {

/// Header that LinuxCNC and the Allen-Bradley dialect both read: metric, absolute, XY plane, feed in mm/min.
constexpr std::string_view program_header = "G21 G90 G17 G94\n";
constexpr std::string_view program_footer = "M30\n";

struct Point {
    double x_mm;
    double y_mm;
};

/// Random numbers that are equal with every library; those of std::uniform_real_distribution may differ.
class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
    }

  private:
    std::mt19937 engine_;
};

/// Collects the program and writes it in chunks.
class Writer {
  public:
    ~Writer() { flush(); }
    Writer() = default;
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    template <typename... Args>
    void line(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
        text_.push_back('\n');
        if (text_.size() > 1U << 16U) flush();
    }
    void add(std::string_view text) { text_ += text; }

  private:
    void flush() {
        std::fwrite(text_.data(), 1, text_.size(), stdout);
        text_.clear();
    }
    std::string text_;
};

double rounded(double value, double unit) {
    return std::floor(value / unit + 0.5) * unit;
}

/// Returns the height of a bowl with two waves in it, 1 to 9 mm high over a square of 90 mm; rational, so
/// that no sine is needed.
double height_mm(Point p) {
    const double u = (p.x_mm - 50.0) / 45.0;
    const double v = (p.y_mm - 50.0) / 45.0;
    return 2.0 + 3.0 * (u * u + v * v) / 2.0 + 3.0 / (1.0 + 25.0 * (u - v) * (u - v)) +
           1.0 / (1.0 + 16.0 * (u + v * v) * (u + v * v));
}

/// Writes a finishing tool path: slanted passes back and forth over the surface, in steps of 0.3 to 1 mm, 0.2
/// mm from pass to pass. At the end of the surface the path turns back. Each block is a bare `X.. Y.. Z..`
/// under the modal G1.
void write_lines(long count) {
    constexpr double min_mm = 5.0;
    constexpr double max_mm = 95.0;
    constexpr double slope = 0.04;
    constexpr double last_pass_mm = max_mm - slope * (max_mm - min_mm);
    double pass_step_mm = 0.2;
    Random random(20240);
    Writer out;
    out.add(program_header);
    out.line("G0 X{:.3f} Y{:.3f} Z20.000", min_mm, min_mm);
    out.line("G1 Z10.000 F3000");
    Point p{min_mm, min_mm};
    double pass_mm = min_mm;
    double direction = 1.0;
    for (long i = 0; i < count; ++i) {
        p.x_mm += direction * random.uniform(0.3, 1.0);
        if (p.x_mm < min_mm || p.x_mm > max_mm) {
            p.x_mm = std::clamp(p.x_mm, min_mm, max_mm);
            direction = -direction;
            if (pass_mm + pass_step_mm > last_pass_mm || pass_mm + pass_step_mm < min_mm)
                pass_step_mm = -pass_step_mm;
            pass_mm += pass_step_mm;
        }
        p.y_mm = pass_mm + slope * (p.x_mm - min_mm);
        out.line("X{:.3f}Y{:.3f}Z{:.3f}", p.x_mm, p.y_mm, height_mm(p));
    }
    out.add(program_footer);
}

struct Arc {
    bool clockwise;
    Point end;
    double i_mm;
    double j_mm;
};

/// Returns the shorter arc of the given radius between two points.
Arc arc_between(Point from, Point to, double radius_mm, bool clockwise) {
    const double dx = to.x_mm - from.x_mm;
    const double dy = to.y_mm - from.y_mm;
    const double chord = std::sqrt(dx * dx + dy * dy);
    const double rise = std::sqrt(std::max(0.0, radius_mm * radius_mm - chord * chord / 4.0));
    const double side = clockwise ? -1.0 : 1.0;
    return {clockwise, to, dx / 2.0 - side * rise * dy / chord, dy / 2.0 + side * rise * dx / chord};
}

/// Writes waves of arcs along rows, on alternating sides, with chords of 1 to 5 mm. Four decimals make the
/// radii at start and end agree within the tolerance of controllers.
void write_arcs(long count) {
    constexpr double left_mm = 100.0;
    constexpr double right_mm = 1700.0;
    constexpr double min_mm = 100.0;
    constexpr double max_mm = 2300.0;
    constexpr double row_mm = 8.0;
    constexpr double unit_mm = 1e-4;
    Random random(20241);
    Writer out;
    out.add(program_header);
    out.line("G0 X{:.4f} Y{:.4f} Z20.0000", left_mm, min_mm);
    out.line("G1 Z10.0000 F3000");
    Point p{left_mm, min_mm};
    double direction = 1.0;
    double row_direction = 1.0;
    for (long i = 0; i < count; ++i) {
        Point to{rounded(p.x_mm + direction * random.uniform(1.0, 5.0), unit_mm), p.y_mm};
        if (to.x_mm < left_mm || to.x_mm > right_mm) {
            direction = -direction;
            if (p.y_mm + row_direction * row_mm > max_mm || p.y_mm + row_direction * row_mm < min_mm)
                row_direction = -row_direction;
            to = {p.x_mm, p.y_mm + row_direction * row_mm};
        }
        const double chord_mm = std::abs(to.x_mm - p.x_mm) + std::abs(to.y_mm - p.y_mm);
        const Arc arc = arc_between(p, to, chord_mm * random.uniform(0.6, 2.0), i % 2 == 0);
        out.line("{} X{:.4f} Y{:.4f} I{:.4f} J{:.4f}", arc.clockwise ? "G2" : "G3", arc.end.x_mm,
                 arc.end.y_mm, arc.i_mm, arc.j_mm);
        p = to;
    }
    out.add(program_footer);
}

/// Adds the body of the macro loop, the same in both languages: twenty lines of arithmetic and a move to the
/// resulting point, on a rosette.
void add_macro_body(Writer& out) {
    for (const std::string_view line :
         {"#2=[#1 MOD 360]", "#3=[#2*3]",       "#4=[#2*5+30]",          "#5=[40+10*COS[#3]]",
          "#6=[#5*COS[#2]]", "#7=[#5*SIN[#2]]", "#8=[5*COS[#4]]",        "#9=[5*SIN[#4]]",
          "#10=[#6+#8]",     "#11=[#7+#9]",     "#12=[#10*#10+#11*#11]", "#13=SQRT[#12]",
          "#14=[#13-40]",    "#15=[ABS[#14]]",  "#16=[1/[1+#15]]",       "#17=[#10+#16]",
          "#18=[#11-#16]",   "#19=[200+#17]",   "#20=[200+#18]",         "#1=[#1+1]"})
        out.line("{}", line);
    out.line("G1 X[#19] Y[#20] F3000");
}

void write_macro_ab9(long count) {
    Writer out;
    out.add(program_header);
    out.line("#1=0");
    out.line("WHILE[#1 LT {}]DO1", count);
    add_macro_body(out);
    out.line("END1");
    out.add(program_footer);
}

void write_macro_rs274(long count) {
    Writer out;
    out.add(program_header);
    out.line("#1=0");
    out.line("o1 while [#1 LT {}]", count);
    add_macro_body(out);
    out.line("o1 endwhile");
    out.add(program_footer);
}

/// Returns a point of the unit circle, with equally many points for each eighth of a turn. A walk round a
/// square needs only a square root. `turn` from 0 to 1.
Point circle_point(double turn) {
    const double quarters = turn * 4.0;
    const double side = std::floor(quarters);
    const double tangent = 2.0 * (quarters - side) - 1.0;
    const double length = std::sqrt(1.0 + tangent * tangent);
    const Point first{1.0 / length, tangent / length};
    if (side < 1.0) return first;
    if (side < 2.0) return {-first.y_mm, first.x_mm};
    if (side < 3.0) return {-first.x_mm, -first.y_mm};
    return {first.y_mm, -first.x_mm};
}

/// Writes a torus (OBJ) of 50 x `count` quadrangles; each is read as two triangles.
void write_cell_mesh(long count) {
    constexpr double major_radius_mm = 60.0;
    constexpr double minor_radius_mm = 20.0;
    constexpr long tube_segments = 50;
    Writer out;
    for (long i = 0; i < count; ++i) {
        const Point ring_point = circle_point(static_cast<double>(i) / static_cast<double>(count));
        for (long j = 0; j < tube_segments; ++j) {
            const Point tube_point =
                circle_point(static_cast<double>(j) / static_cast<double>(tube_segments));
            const double distance_mm = major_radius_mm + minor_radius_mm * tube_point.x_mm;
            out.line("v {:.6f} {:.6f} {:.6f}", distance_mm * ring_point.x_mm, distance_mm * ring_point.y_mm,
                     minor_radius_mm * tube_point.y_mm);
        }
    }
    const auto vertex = [&](long i, long j) { return i % count * tube_segments + j % tube_segments + 1; };
    for (long i = 0; i < count; ++i) {
        for (long j = 0; j < tube_segments; ++j)
            out.line("f {} {} {} {}", vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
}

/// Writes a cell of `count` of these toruses, in rows of five on the table of the gantry, and the shapes of
/// its head.
void write_cell(long count) {
    Writer out;
    // The machine's own carriage lies within the simple wrist below.
    out.line("ignore = [[\"wrist\", \"tilt carriage\"]]\n");
    out.line("[cell]\nname = \"{} meshes\"\nclearance_mm = 10.0", count);
    for (long i = 0; i < count; ++i) {
        out.line("\n[[object]]\nname = \"torus {}\"\nshape = {{ mesh = \"torus.obj\" }}", i + 1);
        out.line("frame = {{ x_mm = {}.0, y_mm = {}.0 }}", 200 + i % 5 * 350, 150 + i / 5 * 220);
    }
    out.line("\n[[shape]]\nname = \"nozzle\"\non = \"tool\"\nshape = {{ cylinder_mm = [8.0, 60.0] }}");
    out.line("frame = {{ z_mm = 30.0 }}");
    out.line("\n[[shape]]\nname = \"head\"\non = \"tool\"\nshape = {{ cylinder_mm = [70.0, 140.0] }}");
    out.line("frame = {{ z_mm = 130.0 }}");
    out.line("\n[[shape]]\nname = \"wrist\"\non = \"Z\"\nshape = {{ box_mm = [160.0, 160.0, 300.0] }}");
    out.line("frame = {{ z_mm = 360.0 }}");
}

/// Writes blocks of 10 mm back and forth over that cell, 1 to 31 mm above the meshes.
void write_cell_blocks(long count) {
    constexpr double step_mm = 10.0;
    constexpr double min_mm = 50.0;
    constexpr double max_mm = 1750.0;
    constexpr double row_mm = 20.0;
    Random random(20242);
    Writer out;
    out.add(program_header);
    out.line("G64");
    out.line("G0 Z40.000");
    out.line("G1 X{:.3f} Y{:.3f} F6000", min_mm, min_mm);
    Point p{min_mm, min_mm};
    double direction = 1.0;
    double row_direction = 1.0;
    for (long i = 0; i < count; ++i) {
        if (p.x_mm + direction * step_mm > max_mm || p.x_mm + direction * step_mm < min_mm) {
            direction = -direction;
            if (p.y_mm + row_direction * row_mm > 2300.0 || p.y_mm + row_direction * row_mm < min_mm)
                row_direction = -row_direction;
            p.y_mm += row_direction * row_mm;
        } else {
            p.x_mm += direction * step_mm;
        }
        out.line("X{:.3f}Y{:.3f}Z{:.3f}", p.x_mm, p.y_mm,
                 random.uniform(35.0, 37.0) + (i / 500 % 2 == 0 ? -14.0 : 14.0));
    }
    out.add(program_footer);
}

using Generator = void (*)(long);

const std::map<std::string_view, Generator>& generators() {
    static const std::map<std::string_view, Generator> generators_by_name{{"lines", write_lines},
                                                                          {"arcs", write_arcs},
                                                                          {"cell", write_cell},
                                                                          {"cell-blocks", write_cell_blocks},
                                                                          {"cell-mesh", write_cell_mesh},
                                                                          {"macro-ab9", write_macro_ab9},
                                                                          {"macro-rs274", write_macro_rs274}};
    return generators_by_name;
}

std::vector<std::string_view> names() {
    std::vector<std::string_view> names;
    names.reserve(generators().size());
    for (const auto& [name, generator] : generators()) names.push_back(name);
    return names;
}

}  // namespace

int main(int argc, char** argv) {
    long count = 0;
    const std::string_view digits = argc == 3 ? argv[2] : "";
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
    const auto generator = argc == 3 ? generators().find(argv[1]) : generators().end();
    if (generator == generators().end() || error != std::errc{} || end != digits.data() + digits.size() ||
        count < 1) {
        fmt::print(stderr, "usage: gsim-bench-generate MODE COUNT >FILE; MODE is one of {}\n",
                   fmt::join(names(), ", "));
        return 2;
    }
    generator->second(count);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        std::perror("gsim-bench-generate");
        return 1;
    }
    return 0;
}
