#include <cstdint>
#include <cstring>
#include <map>

#include <fmt/format.h>

#include "base/text/json.h"
#include "studio/engine/session.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/promises.h"

namespace gsim::fuzz {
namespace {

/// Returns a file of a request.
std::optional<std::string> file_of_page(const std::string& name) {
    static const std::map<std::string, std::string> kFiles{
        {"part.nc", "G21 G90\nG0 X10\nG1 Y20 F6000\nG2 X30 Y20 I10\nM2\n"},
        {"part.ngc", "G21 G90\nG64 P0.1\nG1 X10 F600\nY10\nM2\n"},
        {"part.lua", "local _ENV = require 'gsim'\nG0{x=1}\n"},
        {"tools.txt", "NCFILE\nTOOL\n1 30 2\nENDFILE\n"},
        {"broken.toml", "[machine\n"},
        {"router.toml",
         "[machine]\nname = \"r\"\ninverse = \"gantry\"\n"
         "[[axis]]\nletter = \"X\"\nkind = \"linear\"\nmin_mm = 0.0\nmax_mm = 500.0\ndirection = \"x\"\n"
         "[[axis]]\nletter = \"Y\"\nkind = \"linear\"\nmin_mm = 0.0\nmax_mm = 500.0\ndirection = \"y\"\n"
         "[[axis]]\nletter = \"Z\"\nkind = \"linear\"\nmin_mm = -90.0\nmax_mm = 90.0\ndirection = \"z\"\n"
         "[[shape]]\nname = \"cutter\"\non = \"tool\"\nshape = { sphere_mm = 8.0 }\n"},
        {"cell.toml",
         "[cell]\nname = \"c\"\nmachine = \"router.toml\"\n"
         "[[object]]\nname = \"block\"\nshape = { box_mm = [90.0, 90.0, 9.0] }\n"},
        {"square.svg",
         "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"90mm\" height=\"90mm\" viewBox=\"0 0 90 90\">"
         "<path d=\"M20,20 h50 v50 h-50 z\"/></svg>"},
        {"part.step", "ISO-10303-21;"},
        {"way.json",
         "{\"name\": \"w\", \"root\": \"w\", \"paths\": [{\"name\": \"w\", \"targets\": ["
         "{\"motion\": \"rapid\", \"position_mm\": [10, 20, 30], \"tool_axis\": [0, 0, 1]}, "
         "{\"position_mm\": [60, 20, 30], \"feed_mm_min\": 900}]}]}"},
    };
    const auto found = kFiles.find(name);
    if (found == kFiles.end()) return std::nullopt;
    return found->second;
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
    std::uint32_t number = 0;
    std::memcpy(&number, bytes.data() + at, sizeof number);
    return number;
}

std::size_t aligned(std::size_t size) {
    return (size + 7) / 8 * 8;
}

/// Messages of an answer, by the layout that pages read.
class Messages {
  public:
    void add_message(const std::string& bytes) {
        if (!error_) error_ = check_message(bytes);
    }
    std::optional<std::string> violation() const {
        if (error_) return error_;
        if (ends_ != 1) return fmt::format("an answer has {} ends", ends_);
        return std::nullopt;
    }
    bool done() const { return done_; }

  private:
    std::optional<std::string> check_message(const std::string& bytes) {
        if (ends_ > 0) return "a message behind the end";
        if (bytes.size() < 8 || number_at(bytes, 0) != bytes.size() || bytes.size() % 8 != 0)
            return "a message has another size than it says";
        const std::size_t size = number_at(bytes, 4);
        if (8 + size > bytes.size()) return "a header goes past its message";
        const auto header = text::try_parse_json<nlohmann::json>(bytes.substr(8, size));
        if (!header.is_object() || !header.contains("is")) return "a header is no object with a name";
        static const std::map<std::string, std::size_t> kTypeSizes{
            {"f64", 8}, {"f32", 4}, {"u32", 4}, {"u8", 1}};
        std::size_t at = aligned(8 + size);
        for (const auto& column : header.value("columns", nlohmann::json::array()))
            at += aligned(kTypeSizes.at(column[1]) * column[2].get<std::size_t>());
        if (at != bytes.size()) return "columns do not fill their message";
        if (header["is"] == "done" || header["is"] == "failed") ++ends_;
        done_ = header["is"] == "done";
        if (header["is"] == "failed") return fault_of_sentence(header["message"].get<std::string>());
        return std::nullopt;
    }

    std::optional<std::string> error_;
    int ends_ = 0;
    bool done_ = false;
};

/// The volume of a machine's reach takes long for good reason.
bool takes_long(std::string_view requested) {
    return requested.find("envelope") != std::string_view::npos ||
           requested.find("\\u") != std::string_view::npos;
}

}  // namespace

Outcome check_studio_request(std::string_view json) {
    if (takes_long(json)) return rejected();
    engine::Host host;
    host.files = engine::Files::given(file_of_page);
    Messages messages;
    studio::handle_request(json, host, [&](const std::string& bytes) { messages.add_message(bytes); });
    if (auto violation = messages.violation()) return broken(*std::move(violation));
    return messages.done() ? accepted() : rejected();
}

}  // namespace gsim::fuzz
