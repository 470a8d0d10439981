#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

struct sqlite3;
struct sqlite3_stmt;

namespace gsim::batch {

/// What a statement of SQL comes to; the error is a sentence of SQLite's behind the file's name.
using SqlDone = tl::expected<void, std::string>;

/// One statement with its parameters, to be stepped through; made again and again for the same SQL it costs
/// no more than its steps. It goes before its database.
class Statement {
  public:
    /// Parameters count from 1, in the order of their question marks.
    Statement& bind(int parameter, std::string_view text);
    Statement& bind(int parameter, std::int64_t number);
    Statement& bind(int parameter, std::optional<double> number);  ///< Nothing: NULL.
    Statement& bind_null(int parameter);

    /// The next row: whether there is one. Behind the last one the statement may be bound anew. A parameter
    /// that was not taken (longer than SQLite's 1,000,000,000 bytes, or memory is short) is told of here.
    tl::expected<bool, std::string> step();
    /// To the end, for statements without rows; it may be bound anew then.
    SqlDone run();

    /// Of the row that step() has come to. Columns count from 0.
    int columns() const;
    std::string name(int column) const;
    bool is_null(int column) const;
    bool is_whole(int column) const;          ///< A whole number.
    bool is_number(int column) const;         ///< Any other number.
    std::string_view text(int column) const;  ///< Until the next step.
    std::int64_t whole(int column) const;
    double number(int column) const;

  private:
    friend class Database;
    struct Close {
        void operator()(sqlite3_stmt* statement) const;
    };
    Statement(sqlite3* database, std::shared_ptr<const std::string> file, sqlite3_stmt* statement)
        : database_(database), file_(std::move(file)), statement_(statement) {}
    Statement& bound(int status);

    sqlite3* database_;
    std::shared_ptr<const std::string> file_;
    std::unique_ptr<sqlite3_stmt, Close> statement_;
    int unbound_ = 0;  ///< Why a parameter was not taken, as SQLite counts reasons.
};

/// A file of SQLite.
class Database {
  public:
    /// Opens a file, or makes it; `for_reading`: an existing one, of which nothing is changed. The error is a
    /// sentence with the file's name.
    static tl::expected<Database, std::string> open(const std::string& file, bool for_reading = false);

    /// As it was named when it was opened.
    const std::string& file() const { return *file_; }

    /// Statements without parameters and rows, with semicolons between.
    SqlDone execute(const std::string& sql);
    /// Of one statement. The error: it is no SQL, or what it names is not there.
    tl::expected<Statement, std::string> prepare(std::string_view sql);

  private:
    struct Close {
        void operator()(sqlite3* database) const;
    };
    Database(sqlite3* database, const std::string& file)
        : file_(std::make_shared<const std::string>(file)), database_(database) {}
    static tl::expected<Database, std::string> open_by(const std::string& file, const std::string& name,
                                                       int flags);

    std::shared_ptr<const std::string> file_;
    std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace gsim::batch
