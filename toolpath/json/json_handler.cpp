#include "toolpath/json/json_handler.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text/file_format.h"

namespace gsim::path {

namespace {

constexpr std::size_t kMaxMessageLength = 300;

// Returns the parser's message without its own numbering and position.
std::string_view plain_message(std::string_view what) {
    const std::size_t column = what.find("column ");
    const std::size_t colon = column == std::string_view::npos ? column : what.find(": ", column);
    return colon == std::string_view::npos ? what : what.substr(colon + 2);
}

bool add_key(std::vector<std::string>& seen, const std::string& key) {
    if (std::find(seen.begin(), seen.end(), key) != seen.end()) return false;
    seen.push_back(key);
    return true;
}

bool is_known(const std::string& key, std::span<const std::string_view> known) {
    return std::find(known.begin(), known.end(), key) != known.end();
}

}  // namespace

bool JsonHandler::fail(const SourceLocation& source_location, std::string_view message) {
    std::string line(message.substr(0, kMaxMessageLength));
    std::replace_if(
        line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    error_ = fmt::format("{}:{}:{}: {}", file_.file_name, source_location.line, source_location.column, line);
    return false;
}

bool JsonHandler::check(tl::expected<void, std::string> done) {
    return done ? true : fail(done.error());
}

bool JsonHandler::type_error(std::string_view found) {
    return fail(fmt::format("{}, not {}", expected_type(), found));
}

bool JsonHandler::number(double value) {
    if (level() == Level::vector) {
        if (values_.size() == 3) return fail(fmt::format("{}, not more", expected_type()));
        values_.push_back(value);
        return true;
    }
    if (level() == Level::offset) return offset_value(value);
    if (level() == Level::touch) return touch_value(value);
    if (level() == Level::path) return path_number(value);
    if (level() == Level::program && key_ == "format") {
        const auto error = text::format_error(value);
        return error ? fail(*error) : true;
    }
    if (level() == Level::rotary) return check(draft_.set_rotary(key_, value));
    const bool expects_number =
        level() == Level::target && (target_expects(TargetDraft::ValueKind::number) ||
                                     target_expects(TargetDraft::ValueKind::text_or_number));
    return expects_number ? check(draft_.set_number(target_key_, value)) : type_error("a number");
}

bool JsonHandler::string(std::string& value) {
    switch (level()) {
        case Level::program:
            if (key_ == "paths" || key_ == "work_offsets" || key_ == "format") return type_error("a string");
            if (key_ == "name") file_.program.name = value;
            if (key_ == "root") {
                root_ = value;
                root_location_ = bytes_.token();
            }
            return true;
        case Level::path: return path_string(value);
        case Level::actions: draft_.add_action(std::move(value)); return true;
        case Level::touch: return touch_value(std::string_view(value));
        case Level::target:
            if (target_expects(TargetDraft::ValueKind::text) ||
                target_expects(TargetDraft::ValueKind::text_or_number)) {
                return check(draft_.set_text(target_key_, value));
            }
            [[fallthrough]];
        default: return type_error("a string");
    }
}

bool JsonHandler::start_object(std::size_t) {
    switch (level()) {
        case Level::outside: levels_.push_back(Level::program); return true;
        case Level::program:
            if (key_ != "work_offsets") return type_error("an object");
            levels_.push_back(Level::offsets);
            return true;
        case Level::offsets: return start_offset();
        case Level::paths:
            levels_.push_back(Level::path);
            path_keys_.clear();
            path_draft_ = {};
            file_.program.paths.emplace_back();
            file_.paths.push_back(bytes_.token());
            file_.targets.emplace_back();
            return true;
        case Level::targets:
            levels_.push_back(Level::target);
            draft_ = {};
            draft_location_ = bytes_.token();
            return true;
        case Level::touches:
            levels_.push_back(Level::touch);
            touch_draft_ = {};
            touch_location_ = bytes_.token();
            return true;
        case Level::target:
            if (TargetDraft::value_kind(target_key_) == TargetDraft::ValueKind::letters) {
                levels_.push_back(Level::rotary);
                draft_.begin_rotary();
                return true;
            }
            [[fallthrough]];
        default: return type_error("an object");
    }
}

bool JsonHandler::key(std::string& name) {
    switch (level()) {
        case Level::program: return program_key(name);
        case Level::path: return path_key(name);
        case Level::target: return target_key(name);
        case Level::offsets: offset_name_ = frame_name(name); return true;
        case Level::offset: return offset_key(name);
        case Level::touch: return touch_key(name);
        default: key_ = std::move(name); return true;
    }
}

bool JsonHandler::program_key(const std::string& name) {
    if (!is_known(name, kProgramKeys)) return fail(unknown_key(name, "the path file", kProgramKeys));
    if (!add_key(program_keys_, name)) return fail(fmt::format("'{}' is given twice", name));
    key_ = name;
    return true;
}

bool JsonHandler::path_key(const std::string& name) {
    if (!is_known(name, kPathKeys)) return fail(unknown_key(name, "a path", kPathKeys));
    if (!add_key(path_keys_, name)) return fail(fmt::format("'{}' is given twice", name));
    key_ = name;
    const auto* const found = std::find(kPathKeys.begin(), kPathKeys.end(), name);
    path_key_ = static_cast<PathKey>(found - kPathKeys.begin());
    return true;
}

bool JsonHandler::expects(PathDraft::ValueKind kind) const {
    return PathDraft::value_kind(path_key_) == kind;
}

bool JsonHandler::target_expects(TargetDraft::ValueKind kind) const {
    return TargetDraft::value_kind(target_key_) == kind;
}

bool JsonHandler::path_string(std::string& value) {
    if (expects(PathDraft::ValueKind::text)) return check(path_draft_.set_text(path_key_, value));
    if (path_key_ != PathKey::name) return type_error("a string");
    file_.program.paths.back().name = value;
    return true;
}

bool JsonHandler::path_number(double value) {
    if (expects(PathDraft::ValueKind::number)) return check(path_draft_.set_number(path_key_, value));
    return type_error("a number");
}

// Returns the key of the open vector.
std::string_view JsonHandler::vector_key() const {
    const Level of = levels_[levels_.size() - 2];
    if (of == Level::touch) return key_name(touch_key_);
    return of == Level::path ? key_name(path_key_) : key_name(target_key_);
}

bool JsonHandler::start_offset() {
    levels_.push_back(Level::offset);
    offset_keys_.clear();
    if (file_.program.work_offsets.try_emplace(offset_name_).second) return true;
    return fail(fmt::format("there are two work offsets of the name '{}'", offset_name_));
}

bool JsonHandler::offset_key(std::string& name) {
    const bool letter = name.size() == 1 && name[0] >= 'A' && name[0] <= 'Z';
    if (!letter && name != kRotationKey) {
        return fail(fmt::format("a work offset names axes by one capital letter each, or has '{}'; not '{}'",
                                kRotationKey, name));
    }
    if (!add_key(offset_keys_, name)) return fail(fmt::format("'{}' is given twice", name));
    key_ = std::move(name);
    return true;
}

bool JsonHandler::offset_value(double value) {
    WorkOffset& offset = file_.program.work_offsets[offset_name_];
    if (key_ == kRotationKey) {
        offset.rotation_deg = value;
    } else {
        offset.origin[key_[0]] = value;
    }
    return true;
}

bool JsonHandler::target_key(const std::string& name) {
    const auto* const found = std::find(kTargetKeys.begin(), kTargetKeys.end(), name);
    if (found == kTargetKeys.end()) return fail(unknown_key(name, "a target", kTargetKeys));
    target_key_ = static_cast<TargetKey>(found - kTargetKeys.begin());
    if (draft_.mark_present(target_key_)) return fail(fmt::format("'{}' is given twice", name));
    return true;
}

bool JsonHandler::touch_key(const std::string& name) {
    const auto* const found = std::find(kTouchKeys.begin(), kTouchKeys.end(), name);
    if (found == kTouchKeys.end()) return fail(unknown_key(name, "a touch", kTouchKeys));
    touch_key_ = static_cast<TouchKey>(found - kTouchKeys.begin());
    if (touch_draft_.mark_present(touch_key_)) return fail(fmt::format("'{}' is given twice", name));
    return true;
}

bool JsonHandler::touch_value(double value) {
    if (TouchDraft::value_kind(touch_key_) != TouchDraft::ValueKind::number) return type_error("a number");
    return check(touch_draft_.set_number(touch_key_, value));
}

bool JsonHandler::touch_value(std::string_view value) {
    if (TouchDraft::value_kind(touch_key_) != TouchDraft::ValueKind::text) return type_error("a string");
    return check(touch_draft_.set_text(touch_key_, value));
}

// Adds the touch to a path, or to the use of one.
bool JsonHandler::end_touch() {
    const auto touch = touch_draft_.finish();
    if (!touch) return fail(touch_location_, touch.error());
    if (levels_[levels_.size() - 2] == Level::path) {
        path_draft_.add_touch(*touch);
    } else {
        draft_.add_touch(*touch);
    }
    return true;
}

bool JsonHandler::end_object() {
    const Level ended = level();
    levels_.pop_back();
    if (ended == Level::path) return end_path();
    if (ended == Level::target) return end_target();
    if (ended == Level::touch) return end_touch();
    return true;
}

bool JsonHandler::start_array(std::size_t) {
    if (level() == Level::program && key_ == "paths") {
        levels_.push_back(Level::paths);
        return true;
    }
    if (level() == Level::path) return start_path_array();
    if (level() == Level::touch) return start_touch_array();
    return level() == Level::target ? start_target_array() : type_error("an array");
}

bool JsonHandler::start_path_array() {
    const bool is_vector = expects(PathDraft::ValueKind::vector);
    const bool are_touches = expects(PathDraft::ValueKind::touches);
    if (!is_vector && !are_touches && path_key_ != PathKey::targets) return type_error("an array");
    values_.clear();
    levels_.push_back(is_vector ? Level::vector : are_touches ? Level::touches : Level::targets);
    return true;
}

bool JsonHandler::start_touch_array() {
    if (TouchDraft::value_kind(touch_key_) != TouchDraft::ValueKind::vector) return type_error("an array");
    values_.clear();
    levels_.push_back(Level::vector);
    return true;
}

bool JsonHandler::start_target_array() {
    const TargetDraft::ValueKind kind = TargetDraft::value_kind(target_key_);
    if (kind == TargetDraft::ValueKind::list) {
        levels_.push_back(Level::actions);
        return true;
    }
    if (kind == TargetDraft::ValueKind::touches) {
        levels_.push_back(Level::touches);
        return true;
    }
    if (kind != TargetDraft::ValueKind::vector) return type_error("an array");
    values_.clear();
    levels_.push_back(Level::vector);
    return true;
}

bool JsonHandler::end_array() {
    const Level ended = level();
    levels_.pop_back();
    if (ended == Level::touches)
        return check(level() == Level::path ? path_draft_.end_touches() : draft_.end_touches());
    return ended == Level::vector ? end_vector() : true;
}

bool JsonHandler::end_vector() {
    if (level() == Level::touch) return check(touch_draft_.set_vector(touch_key_, values_));
    return check(level() == Level::path ? path_draft_.set_vector(path_key_, values_)
                                        : draft_.set_vector(target_key_, values_));
}

bool JsonHandler::end_path() {
    const SourceLocation source_location = file_.paths.back();
    for (const std::string_view name : std::span(kPathKeys).first(kRequiredPathKeys)) {
        if (std::find(path_keys_.begin(), path_keys_.end(), name) == path_keys_.end()) {
            return fail(source_location, fmt::format("a path lacks the key '{}'", name));
        }
    }
    if (auto done = path_draft_.finish(file_.program.paths.back()); !done)
        return fail(source_location, done.error());
    const std::size_t index = file_.program.paths.size() - 1;
    const std::string& name = file_.program.paths.back().name;
    if (by_name_.emplace(name, index).second) return true;
    return fail(source_location, fmt::format("there are two paths of the name '{}'", name));
}

bool JsonHandler::end_target() {
    tl::expected<Target, std::string> target = draft_.finish();
    if (!target) return fail(draft_location_, target.error());
    const std::size_t path = file_.program.paths.size() - 1;
    std::vector<Target>& targets = file_.program.paths.back().targets;
    if (draft_.is_sub_path()) references_.push_back({{path, targets.size()}, draft_.path_name()});
    targets.push_back(std::move(*target));
    file_.targets.back().push_back(draft_location_);
    return true;
}

bool JsonHandler::parse_error(std::size_t, const std::string&, const nlohmann::json::exception& exception) {
    SourceLocation source_location = bytes_.location();
    if (source_location.column > 1) --source_location.column;
    return fail(source_location, plain_message(exception.what()));
}

std::optional<std::size_t> JsonHandler::path_index(std::string_view name) const {
    const auto found = by_name_.find(name);
    if (found == by_name_.end()) return std::nullopt;
    return found->second;
}

bool JsonHandler::resolve() {
    if (file_.program.paths.empty())
        return fail(SourceLocation{1, 1}, "a path file needs 'paths' with one path at least");
    if (root_) {
        const auto index = path_index(*root_);
        if (!index) return fail(root_location_, fmt::format("there is no path of the name '{}'", *root_));
        file_.program.root = *index;
    }
    for (const Reference& reference : references_) {
        const auto [path, target] = reference.from;
        const auto index = path_index(reference.path_name);
        if (!index) {
            return fail(file_.targets[path][*target],
                        fmt::format("there is no path of the name '{}'", reference.path_name));
        }
        std::get<SubPath>(file_.program.paths[path].targets[*target]).path = *index;
    }
    return true;
}

tl::expected<PathFile, std::string> JsonHandler::finish() {
    if (!resolve()) return tl::unexpected(error_);
    return std::move(file_);
}

}  // namespace gsim::path
