#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/error.h"

struct sqlite3;
struct sqlite3_stmt;

namespace gsim::batch {

/// One SQL statement with its parameters, to be stepped through. Errors have the file's name, then the
/// message of SQLite. Creating it again for the same SQL costs no more than its steps. It must be destroyed
/// before its database.
class Statement {
  public:
    /// Parameters count from 1, in the order of their question marks.
    Statement& bind(int parameter, std::string_view text);
    Statement& bind(int parameter, std::int64_t number);
    Statement& bind(int parameter, std::optional<double> number);  ///< Empty: NULL.
    Statement& bind_null(int parameter);

    /// Reads the next row; returns true if one exists. After the last row the statement may be bound again.
    /// Reports also a parameter that was not accepted (longer than SQLite's 1,000,000,000 bytes, or out of
    /// memory).
    Result<bool> step();
    /// Runs a statement without rows to its end; it may then be bound again.
    Result<void> run();

    /// Returns the number of columns of the current row of step(). Columns count from 0.
    int columns() const;
    std::string name(int column) const;
    bool is_null(int column) const;
    bool is_integer(int column) const;        ///< True for an integer.
    bool is_number(int column) const;         ///< Any other number.
    std::string_view text(int column) const;  ///< Until the next step.
    std::int64_t integer(int column) const;
    double number(int column) const;

  private:
    friend class Database;
    struct Close {
        void operator()(sqlite3_stmt* statement) const;
    };
    Statement(sqlite3* database, std::shared_ptr<const std::string> file, sqlite3_stmt* statement)
        : database_(database), file_(std::move(file)), statement_(statement) {}
    Statement& check_bind(int status);

    sqlite3* database_;
    std::shared_ptr<const std::string> file_;
    std::unique_ptr<sqlite3_stmt, Close> statement_;
    int bind_status_ = 0;  ///< SQLite's error code for a parameter that was not accepted.
};

/// SQLite file.
class Database {
  public:
    /// Opens a file, or creates it; `read_only`: an existing one, which is not changed. The error is a
    /// message with the file's name.
    static Result<Database> open(const std::string& file, bool read_only = false);

    /// Returns the name with which it was opened.
    const std::string& file() const { return *file_; }

    /// Executes statements without parameters and rows, separated by semicolons.
    Result<void> execute(const std::string& sql);
    /// Prepares one statement. The error: invalid SQL, or a name in it does not exist.
    Result<Statement> prepare(std::string_view sql);

  private:
    struct Close {
        void operator()(sqlite3* database) const;
    };
    Database(sqlite3* database, const std::string& file)
        : file_(std::make_shared<const std::string>(file)), database_(database) {}
    static Result<Database> open_with_flags(const std::string& file, const std::string& name, int flags);

    std::shared_ptr<const std::string> file_;
    std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace gsim::batch
