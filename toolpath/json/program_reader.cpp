#include "toolpath/json/program_reader.h"

#include <algorithm>

#include "base/text/file_format.h"
#include "toolpath/json/keys.h"
#include "toolpath/json/target_draft.h"

namespace gsim::path {

ReadResult ProgramReader::key(const std::string& name) {
    if (std::find(kProgramKeys.begin(), kProgramKeys.end(), name) == kProgramKeys.end())
        return Unexpected(unknown_key(name, "the path file", kProgramKeys));
    if (std::find(keys_.begin(), keys_.end(), name) != keys_.end()) return duplicate_key(name);
    keys_.push_back(name);
    key_ = name;
    return {};
}

ReadResult ProgramReader::number(double value) const {
    if (!is_at("format")) return type_error(expected_type(), "a number");
    if (auto error = text::find_format_error(value)) return tl::unexpected(*std::move(error));
    return {};
}

ReadResult ProgramReader::string(const std::string& value, const SourceLocation& location, Program& program,
                                 PathNames& names) const {
    if (is_at("paths") || is_at("work_offsets") || is_at("format"))
        return type_error(expected_type(), "a string");
    if (is_at("name")) program.name = value;
    if (is_at("root")) names.set_root(value, location);
    return {};
}

std::string ProgramReader::expected_type() const {
    if (is_at("work_offsets")) return "'work_offsets' must be an object of offsets by name";
    if (is_at("format")) return "'format' must be a number";
    return fmt::format("'{}' must be {}", key_, is_at("paths") ? "an array of paths" : "a string");
}

}  // namespace gsim::path
