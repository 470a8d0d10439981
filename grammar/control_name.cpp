#include "grammar/control_name.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/nearest_name.h"

namespace gsim::grammar {

namespace {

struct Control {
    std::string_view name;
    std::string_view dialect;  // Empty: no similar dialect.
    std::string_view caution;
};

constexpr std::string_view kAb9 = "ab9";
constexpr std::string_view kNgc = "rs274ngc";
constexpr std::string_view kKlipper = "klipper";

constexpr std::string_view kFanuc =
    "a relative of the 9/Series with the same macros and subprograms; codes and parameters of its own "
    "(G5.1, G54.1 P, G10 L50, #3000 on) are errors or mean what they mean on the 9/Series";
constexpr std::string_view kHaas =
    "a relative of the 9/Series; G12, G13, G70, G71, G150 and settings of its own are not read as it means "
    "them, and its programs in inches often do not say G20";
constexpr std::string_view kGrbl =
    "it knows a part of that language; what it lacks (O-words, parameters, cycles) passes here all the same";
constexpr std::string_view kMach =
    "a relative of LinuxCNC: M98 P with O numbers as there, but no O-words; G12, G13 and macros in M codes "
    "are its own";
constexpr std::string_view kPathPilot = "built on LinuxCNC; G47 and the M codes of its probing are its own";
constexpr std::string_view kEding = "a relative of LinuxCNC with IF and SUB of its own in place of O-words";
constexpr std::string_view kTinyG = "it knows a part of that language; its JSON commands are not read";

constexpr std::array kControls{
    Control{"ab9", kAb9, ""},
    Control{"rs274ngc", kNgc, ""},
    Control{"klipper", kKlipper, ""},
    Control{"9/series", kAb9, ""},
    Control{"allen-bradley", kAb9, ""},
    Control{"linuxcnc", kNgc, ""},
    Control{"emc2", kNgc, ""},
    Control{"machinekit", kNgc, ""},
    Control{"brother", kAb9, kFanuc},
    Control{"doosan", kAb9, kFanuc},
    Control{"fanuc", kAb9, kFanuc},
    Control{"haas", kAb9, kHaas},
    Control{"mazak-eia", kAb9, kFanuc},
    Control{"mitsubishi", kAb9, kFanuc},
    Control{"eding", kNgc, kEding},
    Control{"fluidnc", kNgc, kGrbl},
    Control{"g2core", kNgc, kTinyG},
    Control{"grbl", kNgc, kGrbl},
    Control{"grblhal", kNgc, kGrbl},
    Control{"mach3", kNgc, kMach},
    Control{"mach4", kNgc, kMach},
    Control{"pathpilot", kNgc, kPathPilot},
    Control{"tinyg", kNgc, kTinyG},
    Control{"tormach", kNgc, kPathPilot},
    Control{"heidenhain", "", "Heidenhain's own language (BEGIN PGM, L X+10 FMAX) is not read"},
    Control{
        "siemens", "",
        "the language of Sinumerik (DEF, R1=, MCALL) is not read; programs in its ISO mode are near to ab9"},
    Control{
        "sinumerik", "",
        "the language of Sinumerik (DEF, R1=, MCALL) is not read; programs in its ISO mode are near to ab9"},
    Control{"okuma", "", "the language of OSP controls (VC1=, CALL O1, NLAP) is not read"},
};

// Returns letters and digits alone, in lower case.
std::string bare(std::string_view name) {
    std::string out;
    for (const char c : name) {
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) out += c;
        if (c >= 'A' && c <= 'Z') out += static_cast<char>(c - 'A' + 'a');
    }
    return out;
}

std::string unknown(std::string_view name) {
    std::vector<std::string_view> known;
    known.reserve(kControls.size());
    for (const Control& control : kControls) known.push_back(control.name);
    const auto nearest = text::nearest_name(name, known);
    return fmt::format("there is no dialect or control '{}'; {}", name,
                       nearest
                           ? fmt::format("did you mean '{}'?", *nearest)
                           : std::string("the dialects are ab9, rs274ngc and klipper, and docs/language.md "
                                         "lists the controls"));
}

}  // namespace

tl::expected<ControlName, std::string> control_named(std::string_view name) {
    const std::string wanted = bare(name);
    const auto* control = std::find_if(kControls.begin(), kControls.end(),
                                       [&](const Control& one) { return bare(one.name) == wanted; });
    if (control == kControls.end()) return tl::unexpected(unknown(name));
    if (control->dialect.empty()) return tl::unexpected(std::string(control->caution));
    ControlName found{.dialect = dialect_named(control->dialect)};
    if (!control->caution.empty()) {
        found.caution = fmt::format("programs of {} are read as {} ({}): {}", control->name, control->dialect,
                                    found.dialect->title(), control->caution);
    }
    return found;
}

std::vector<std::string> control_names() {
    std::vector<std::string> names;
    for (const Control& control : kControls) {
        if (!control.dialect.empty()) names.emplace_back(control.name);
    }
    return names;
}

std::string control_table() {
    std::string table = "| control | dialect | to mind |\n| --- | --- | --- |\n";
    for (const Control& control : kControls) {
        text::append_format(
            table, "| `{}` | {} | {} |\n", control.name,
            control.dialect.empty() ? std::string("none") : fmt::format("`{}`", control.dialect),
            control.caution);
    }
    return table;
}

}  // namespace gsim::grammar
