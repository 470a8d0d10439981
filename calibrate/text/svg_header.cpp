#include "calibrate/text/svg_header.h"

#include <fmt/format.h>

namespace gsim::calibrate {

std::string svg_header(double width, double height) {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 "
        "{0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"11\">\n<rect width=\"100%\" "
        "height=\"100%\" fill=\"#fff\"/>\n",
        width, height);
}

}  // namespace gsim::calibrate
