#include "batch/store/sqlite.h"

#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <sqlite3.h>

namespace gsim::batch {

namespace {

constexpr int kBusyTimeout_ms = 10'000;

/// Returns the name of a file that is never changed, in SQLite's format (https://www.sqlite.org/uri.html).
std::string immutable_uri(const std::string& file) {
    std::string uri = "file:";
    for (const char c : file) {
        const bool plain = c == '/' || c == '.' || c == '-' || c == '_' || (c >= '0' && c <= '9') ||
                           (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        uri += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return uri + "?immutable=1";
}

/// Returns SQLite's message for its latest error, with the system's message if that was the cause.
std::string sqlite_message(sqlite3* database, const std::string& file) {
    std::string error_text = fmt::format("'{}': {}", file, sqlite3_errmsg(database));
    const int status = sqlite3_errcode(database);
    const int error = sqlite3_system_errno(database);
    if ((status != SQLITE_IOERR && status != SQLITE_CANTOPEN) || error == 0) return error_text;
    return fmt::format("{} ({})", error_text, std::generic_category().message(error));
}

}  // namespace

void Statement::Close::operator()(sqlite3_stmt* statement) const {
    sqlite3_finalize(statement);
}

void Database::Close::operator()(sqlite3* database) const {
    sqlite3_close(database);
}

Statement& Statement::check_bind(int status) {
    if (status != SQLITE_OK) bind_status_ = status;
    return *this;
}

Statement& Statement::bind(int parameter, std::string_view text) {
    // An empty view may have a null pointer, which SQLite would interpret as NULL.
    const char* text_data = text.data() == nullptr ? "" : text.data();
    return check_bind(sqlite3_bind_text64(statement_.get(), parameter, text_data, text.size(),
                                          SQLITE_TRANSIENT, SQLITE_UTF8));
}

Statement& Statement::bind(int parameter, std::int64_t number) {
    return check_bind(sqlite3_bind_int64(statement_.get(), parameter, number));
}

Statement& Statement::bind(int parameter, std::optional<double> number) {
    if (!number) return bind_null(parameter);
    return check_bind(sqlite3_bind_double(statement_.get(), parameter, *number));
}

Statement& Statement::bind_null(int parameter) {
    return check_bind(sqlite3_bind_null(statement_.get(), parameter));
}

Result<bool> Statement::step() {
    if (const int bind_status = std::exchange(bind_status_, SQLITE_OK); bind_status != SQLITE_OK)
        return Unexpected(fmt::format("'{}': {}", *file_, sqlite3_errstr(bind_status)));
    const int status = sqlite3_step(statement_.get());
    if (status == SQLITE_ROW) return true;
    Result<bool> ended = false;
    if (status != SQLITE_DONE) ended = Unexpected(sqlite_message(database_, *file_));
    sqlite3_reset(statement_.get());
    return ended;
}

Result<void> Statement::run() {
    while (true) {
        const auto row = step();
        if (!row) return tl::unexpected(row.error());
        if (!*row) return {};
    }
}

int Statement::columns() const {
    return sqlite3_column_count(statement_.get());
}

std::string Statement::name(int column) const {
    return sqlite3_column_name(statement_.get(), column);
}

bool Statement::is_null(int column) const {
    return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

bool Statement::is_integer(int column) const {
    return sqlite3_column_type(statement_.get(), column) == SQLITE_INTEGER;
}

bool Statement::is_number(int column) const {
    return sqlite3_column_type(statement_.get(), column) == SQLITE_FLOAT;
}

std::string_view Statement::text(int column) const {
    const auto* bytes = sqlite3_column_blob(statement_.get(), column);
    const int count = sqlite3_column_bytes(statement_.get(), column);
    return {static_cast<const char*>(bytes), static_cast<std::size_t>(count)};
}

std::int64_t Statement::integer(int column) const {
    return sqlite3_column_int64(statement_.get(), column);
}

double Statement::number(int column) const {
    return sqlite3_column_double(statement_.get(), column);
}

Result<Database> Database::open(const std::string& file, bool read_only) {
    if (!read_only) return open_with_flags(file, file, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
    // If the file is writable, the last program that closes it removes the auxiliary files of SQLite.
    auto database = open_with_flags(file, file, SQLITE_OPEN_READWRITE);
    if (!database || database->prepare("SELECT count(*) FROM sqlite_schema")) return database;
    // Neither it nor its folder can be written, so no process changes it meanwhile.
    return open_with_flags(file, immutable_uri(file), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
}

Result<Database> Database::open_with_flags(const std::string& file, const std::string& name, int flags) {
    sqlite3* opened = nullptr;
    const int status = sqlite3_open_v2(name.c_str(), &opened, flags, nullptr);
    Database database(opened, file);
    if (status != SQLITE_OK)
        return Unexpected(fmt::format("'{}' cannot be opened: {}", file, sqlite3_errstr(status)));
    sqlite3_busy_timeout(opened, kBusyTimeout_ms);
    return database;
}

Result<void> Database::execute(const std::string& sql) {
    if (sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK) return {};
    return tl::unexpected(sqlite_message(database_.get(), *file_));
}

Result<Statement> Database::prepare(std::string_view sql) {
    sqlite3_stmt* statement = nullptr;
    if (sqlite3_prepare_v3(database_.get(), sql.data(), static_cast<int>(sql.size()),
                           SQLITE_PREPARE_PERSISTENT, &statement, nullptr) != SQLITE_OK)
        return tl::unexpected(sqlite_message(database_.get(), *file_));
    return Statement(database_.get(), file_, statement);
}

}  // namespace gsim::batch
