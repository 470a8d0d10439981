#include "toolpath/json/json_handler.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace gsim::path {

namespace {

constexpr std::size_t kMaxMessageLength = 300;

// Returns the parser's message without its own numbering and position.
std::string_view plain_message(std::string_view what) {
    const std::size_t column = what.find("column ");
    const std::size_t colon = column == std::string_view::npos ? column : what.find(": ", column);
    return colon == std::string_view::npos ? what : what.substr(colon + 2);
}

}  // namespace

bool JsonHandler::fail(const SourceLocation& source_location, std::string_view message) {
    std::string line(message.substr(0, kMaxMessageLength));
    std::replace_if(
        line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    error_ = fmt::format("{}:{}:{}: {}", file_.file_name, source_location.line, source_location.column, line);
    return false;
}

std::string JsonHandler::expected_type() const {
    switch (level()) {
        case Level::outside: return "a path file must be an object {...}";
        case Level::program: return program_.expected_type();
        case Level::paths: return "'paths' must contain objects, each a path with 'name' and 'targets'";
        case Level::path: return path_.expected_type();
        case Level::targets: return "'targets' must contain objects, each a point or a sub-path";
        case Level::vector: return fmt::format("'{}' must contain three numbers", vector_key());
        case Level::touches: return "'probe_offset' must contain objects, each a touch";
        case Level::touch: return touch_.expected_type();
        case Level::offsets: return offset_.expected_offset();
        case Level::offset: return offset_.expected_type();
        case Level::rotary: return target_.expected_rotary();
        case Level::actions: return "'actions' must contain strings";
        case Level::target: return target_.expected_type();
    }
    return {};
}

// --- Values ---

bool JsonHandler::number(double value) {
    switch (level()) {
        case Level::vector: return vector_number(value);
        case Level::offset: offset_.number(value); return true;
        case Level::touch: return check(touch_.number(value));
        case Level::path: return check(path_.number(value));
        case Level::program: return check(program_.number(value));
        case Level::rotary: return check(target_.rotary_number(value));
        case Level::target: return check(target_.number(value));
        default: return fail_type("a number");
    }
}

bool JsonHandler::vector_number(double value) {
    if (values_.size() == 3) return fail_type("more");
    values_.push_back(value);
    return true;
}

bool JsonHandler::string(std::string& value) {
    switch (level()) {
        case Level::program: return check(program_.string(value, bytes_.token(), file_.program, names_));
        case Level::path: return check(path_.string(value));
        case Level::actions: target_.draft().add_action(std::move(value)); return true;
        case Level::touch: return check(touch_.string(value));
        case Level::target: return check(target_.string(value));
        default: return fail_type("a string");
    }
}

bool JsonHandler::key(std::string& name) {
    switch (level()) {
        case Level::program: return check(program_.key(name));
        case Level::path: return check(path_.key(name));
        case Level::target: return check(target_.key(name));
        case Level::offsets: offset_.set_name(name); return true;
        case Level::offset: return check(offset_.key(name));
        case Level::touch: return check(touch_.key(name));
        default: target_.rotary_key(name); return true;
    }
}

// --- Objects ---

bool JsonHandler::open(Level level) {
    levels_.push_back(level);
    return true;
}

bool JsonHandler::start_object(std::size_t) {
    switch (level()) {
        case Level::outside: return open(Level::program);
        case Level::program:
            return program_.is_at("work_offsets") ? open(Level::offsets) : fail_type("an object");
        case Level::offsets: open(Level::offset); return check(offset_.start(file_.program));
        case Level::paths: return start_path();
        case Level::targets: target_.start(bytes_.token()); return open(Level::target);
        case Level::touches: touch_.start(bytes_.token()); return open(Level::touch);
        case Level::target:
            if (!target_.expects(TargetDraft::ValueKind::letters)) return fail_type("an object");
            target_.draft().begin_rotary();
            return open(Level::rotary);
        default: return fail_type("an object");
    }
}

bool JsonHandler::start_path() {
    path_.start();
    file_.program.paths.emplace_back();
    file_.paths.push_back(bytes_.token());
    file_.targets.emplace_back();
    return open(Level::path);
}

bool JsonHandler::end_object() {
    const Level ended = level();
    levels_.pop_back();
    if (ended == Level::path) return end_path();
    if (ended == Level::target) return end_target();
    if (ended == Level::touch) return end_touch();
    return true;
}

bool JsonHandler::end_path() {
    const SourceLocation source_location = file_.paths.back();
    Path& path = file_.program.paths.back();
    if (auto done = path_.finish(path); !done) return fail(source_location, done.error().message);
    if (names_.add(path.name, file_.program.paths.size() - 1)) return true;
    return fail(source_location, fmt::format("two paths have the name '{}'", path.name));
}

bool JsonHandler::end_target() {
    Result<Target> target = target_.draft().finish();
    if (!target) return fail(target_.location(), target.error().message);
    const std::size_t path = file_.program.paths.size() - 1;
    std::vector<Target>& targets = file_.program.paths.back().targets;
    if (target_.draft().is_sub_path()) names_.add_use({path, targets.size()}, target_.draft().path_name());
    targets.push_back(std::move(*target));
    file_.targets.back().push_back(target_.location());
    return true;
}

// Adds the touch to a path, or to the use of one.
bool JsonHandler::end_touch() {
    const auto touch = touch_.finish();
    if (!touch) return fail(touch_.location(), touch.error().message);
    if (outer_level() == Level::path) {
        path_.add_touch(*touch);
    } else {
        target_.draft().add_touch(*touch);
    }
    return true;
}

// --- Arrays ---

bool JsonHandler::open_vector() {
    values_.clear();
    return open(Level::vector);
}

bool JsonHandler::start_array(std::size_t) {
    switch (level()) {
        case Level::program: return program_.is_at("paths") ? open(Level::paths) : fail_type("an array");
        case Level::path: return start_path_array();
        case Level::touch: return touch_.expects_vector() ? open_vector() : fail_type("an array");
        case Level::target: return start_target_array();
        default: return fail_type("an array");
    }
}

bool JsonHandler::start_path_array() {
    if (path_.expects_vector()) return open_vector();
    if (path_.expects_touches()) return open(Level::touches);
    return path_.expects_targets() ? open(Level::targets) : fail_type("an array");
}

bool JsonHandler::start_target_array() {
    if (target_.expects(TargetDraft::ValueKind::list)) return open(Level::actions);
    if (target_.expects(TargetDraft::ValueKind::touches)) return open(Level::touches);
    return target_.expects(TargetDraft::ValueKind::vector) ? open_vector() : fail_type("an array");
}

bool JsonHandler::end_array() {
    const Level ended = level();
    levels_.pop_back();
    if (ended == Level::touches)
        return check(level() == Level::path ? path_.end_touches() : target_.draft().end_touches());
    return ended == Level::vector ? end_vector() : true;
}

bool JsonHandler::end_vector() {
    if (level() == Level::touch) return check(touch_.vector(values_));
    return check(level() == Level::path ? path_.vector(values_) : target_.vector(values_));
}

// Returns the key of the open vector.
std::string_view JsonHandler::vector_key() const {
    if (outer_level() == Level::touch) return touch_.current_key();
    return outer_level() == Level::path ? path_.current_key() : target_.current_key();
}

// --- The end ---

bool JsonHandler::parse_error(std::size_t, const std::string&, const nlohmann::json::exception& exception) {
    SourceLocation source_location = bytes_.location();
    if (source_location.column > 1) --source_location.column;
    return fail(source_location, plain_message(exception.what()));
}

Result<PathFile> JsonHandler::finish() {
    if (file_.program.paths.empty()) {
        fail(SourceLocation{1, 1}, "a path file needs 'paths' with at least one path");
        return tl::unexpected(error_);
    }
    if (const auto error = names_.resolve(file_)) {
        fail({error->line, error->column}, error->message);
        return tl::unexpected(error_);
    }
    return std::move(file_);
}

}  // namespace gsim::path
