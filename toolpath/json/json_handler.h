#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "base/text/json.h"
#include "toolpath/json/json_bytes.h"
#include "toolpath/json/path_draft.h"
#include "toolpath/json/target_draft.h"
#include "toolpath/json/touches.h"

namespace gsim::path {

/// Builder of a program from the events of a JSON parser. An event that returns false ends the parsing;
/// error() then gives the reason.
class JsonHandler {
  public:
    JsonHandler(const JsonBytes& bytes, std::string file_name) : bytes_(bytes) {
        file_.file_name = std::move(file_name);
    }

    // Events that nlohmann::json::sax_parse calls.
    bool null() { return type_error("null"); }
    bool boolean(bool) { return type_error("true or false"); }
    bool number_integer(nlohmann::json::number_integer_t value) { return number(static_cast<double>(value)); }
    bool number_unsigned(nlohmann::json::number_unsigned_t value) {
        return number(static_cast<double>(value));
    }
    bool number_float(double value, const std::string&) { return number(value); }
    bool string(std::string& value);
    bool binary(nlohmann::json::binary_t&) { return type_error("binary"); }
    bool start_object(std::size_t);
    bool key(std::string& name);
    bool end_object();
    bool start_array(std::size_t);
    bool end_array();
    bool parse_error(std::size_t position, const std::string& last_token,
                     const nlohmann::json::exception& exception);

    /// Returns the program after the last event; the error is "file:line:column: message".
    tl::expected<PathFile, std::string> finish();
    const std::string& error() const { return error_; }

  private:
    enum class Level {
        outside,
        program,
        paths,
        path,
        targets,
        target,
        vector,
        rotary,
        touches,
        touch,
        actions,
        offsets,
        offset
    };
    struct Reference {
        TargetId from;
        std::string path_name;
    };

    Level level() const { return levels_.back(); }
    bool number(double value);
    bool program_key(const std::string& name);
    bool path_key(const std::string& name);
    bool target_key(const std::string& name);
    bool offset_key(std::string& name);
    bool offset_value(double value);
    bool start_offset();
    bool start_target_array();
    bool start_path_array();
    bool start_touch_array();
    bool touch_key(const std::string& name);
    bool touch_value(double value);
    bool touch_value(std::string_view value);
    bool end_touch();
    bool path_string(std::string& value);
    bool path_number(double value);
    bool expects(PathDraft::ValueKind kind) const;
    bool target_expects(TargetDraft::ValueKind kind) const;
    std::string_view vector_key() const;
    bool end_path();
    bool end_target();
    bool end_vector();
    bool check(tl::expected<void, std::string> done);
    bool fail(const SourceLocation& source_location, std::string_view message);
    bool fail(std::string_view message) { return fail(bytes_.token(), message); }
    bool type_error(std::string_view found);
    std::string expected_type() const;
    bool resolve();
    std::optional<std::size_t> path_index(std::string_view name) const;

    const JsonBytes& bytes_;
    PathFile file_;
    std::string error_;
    std::vector<Level> levels_{Level::outside};
    std::string key_;  // the last key of the program, of a path or of rotary axes
    std::vector<std::string> program_keys_, path_keys_, offset_keys_;
    std::string offset_name_;  // of the work coordinate system being read
    std::optional<std::string> root_;
    SourceLocation root_location_;
    PathKey path_key_ = PathKey::name;
    PathDraft path_draft_;
    TouchKey touch_key_ = TouchKey::axis;
    TouchDraft touch_draft_;
    SourceLocation touch_location_;
    TargetKey target_key_ = TargetKey::name;
    TargetDraft draft_;
    SourceLocation draft_location_;
    std::vector<double> values_;
    std::vector<Reference> references_;
    std::map<std::string, std::size_t, std::less<>> by_name_;
};

}  // namespace gsim::path
