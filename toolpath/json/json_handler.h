#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/text/json.h"
#include "toolpath/json/json_bytes.h"
#include "toolpath/json/offset_reader.h"
#include "toolpath/json/path_names.h"
#include "toolpath/json/path_reader.h"
#include "toolpath/json/program_reader.h"
#include "toolpath/json/read_result.h"
#include "toolpath/json/target_reader.h"
#include "toolpath/json/touch_reader.h"

namespace gsim::path {

/// Builder of a program from the events of a JSON parser. It passes each event to the reader of the open
/// object. An event that returns false ends the parsing; error() then gives the reason.
class JsonHandler {
  public:
    JsonHandler(const JsonBytes& bytes, std::string file_name) : bytes_(bytes) {
        file_.file_name = std::move(file_name);
    }

    // Events that nlohmann::json::sax_parse calls.
    bool null() { return fail_type("null"); }
    bool boolean(bool) { return fail_type("true or false"); }
    bool number_integer(nlohmann::json::number_integer_t value) { return number(static_cast<double>(value)); }
    bool number_unsigned(nlohmann::json::number_unsigned_t value) {
        return number(static_cast<double>(value));
    }
    bool number_float(double value, const std::string&) { return number(value); }
    bool string(std::string& value);
    bool binary(nlohmann::json::binary_t&) { return fail_type("binary"); }
    bool start_object(std::size_t);
    bool key(std::string& name);
    bool end_object();
    bool start_array(std::size_t);
    bool end_array();
    bool parse_error(std::size_t position, const std::string& last_token,
                     const nlohmann::json::exception& exception);

    /// Returns the program, once all events have been handled; the error is "file:line:column: message".
    Result<PathFile> finish();
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

    Level level() const { return levels_.back(); }
    /// Returns the level around the innermost one.
    Level outer_level() const { return levels_[levels_.size() - 2]; }
    bool open(Level level);
    bool open_vector();
    bool number(double value);
    bool vector_number(double value);
    bool start_path();
    bool start_path_array();
    bool start_target_array();
    bool end_path();
    bool end_target();
    bool end_touch();
    bool end_vector();
    std::string_view vector_key() const;
    std::string expected_type() const;
    bool check(const ReadResult& done) { return done ? true : fail(done.error().message); }
    bool fail(const SourceLocation& source_location, std::string_view message);
    bool fail(std::string_view message) { return fail(bytes_.token(), message); }
    bool fail_type(std::string_view found) { return check(type_error(expected_type(), found)); }

    const JsonBytes& bytes_;
    PathFile file_;
    PathNames names_;
    std::string error_;
    std::vector<Level> levels_{Level::outside};
    ProgramReader program_;
    OffsetReader offset_;
    PathReader path_;
    TargetReader target_;
    TouchReader touch_;
    std::vector<double> values_;  ///< Values of the open vector.
};

}  // namespace gsim::path
