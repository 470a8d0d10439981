#pragma once

#include <array>

namespace gsim::batch {

/// Version of the tables below; a file has it as PRAGMA user_version.
inline constexpr int kSchemaVersion = 3;
/// "gsim" as PRAGMA application_id.
inline constexpr int kApplicationId = 0x6773696d;

/// Additions of version 2, without the columns of kVersion2Columns: pictures, searches, and the results of
/// each run for them.
inline constexpr const char* kVersion2Tables = R"(
CREATE TABLE search (
  id INTEGER PRIMARY KEY, plan TEXT NOT NULL, objective TEXT NOT NULL, seed INTEGER NOT NULL, began_at TEXT NOT NULL, ended_at TEXT,
  best INTEGER
);
CREATE TABLE search_run (
  search INTEGER NOT NULL REFERENCES search, number INTEGER NOT NULL, run INTEGER NOT NULL REFERENCES run,
  generation INTEGER NOT NULL, value REAL, violation REAL NOT NULL, PRIMARY KEY (search, number, run)
) WITHOUT ROWID;
CREATE TABLE picture (run INTEGER PRIMARY KEY REFERENCES run, svg TEXT NOT NULL);
CREATE VIEW evaluations AS
  SELECT search_run.number, search_run.generation, search_run.value, search_run.violation, run.* FROM search_run
  JOIN run ON run.id = search_run.run WHERE search_run.search = (SELECT max(id) FROM search) ORDER BY search_run.number;
)";
/// Columns of `run` that version 2 adds.
inline constexpr std::array kVersion2Columns{"clearance_mm", "deviation_mm", "joint_speed_share",
                                             "lower_bound_s"};

/// Columns by the names of version 3; views follow.
inline constexpr const char* kVersion3Names = R"(
ALTER TABLE run RENAME COLUMN least_s TO cycle_time_min_s;
ALTER TABLE run RENAME COLUMN most_s TO cycle_time_max_s;
ALTER TABLE run RENAME COLUMN jet_on_mm TO process_on_mm;
ALTER TABLE batch RENAME COLUMN whole TO complete;
)";

/// Tables and views of version 1 (docs/batch.md).
inline constexpr const char* kSchema = R"(
CREATE TABLE run (
  id INTEGER PRIMARY KEY,
  key TEXT NOT NULL,
  program TEXT NOT NULL, program_sha256 TEXT NOT NULL,
  machine TEXT NOT NULL, machine_sha256 TEXT NOT NULL, machine_name TEXT NOT NULL, controller TEXT NOT NULL,
  options TEXT NOT NULL, settings TEXT NOT NULL, version TEXT NOT NULL, ran_at TEXT NOT NULL,
  status TEXT NOT NULL, cause TEXT NOT NULL, message TEXT NOT NULL, file TEXT NOT NULL, line INTEGER NOT NULL,
  cycle_time_s REAL NOT NULL, least_s REAL, most_s REAL,
  rapid_s REAL NOT NULL, feed_s REAL NOT NULL, dwell_s REAL NOT NULL,
  rapid_mm REAL NOT NULL, feed_mm REAL NOT NULL, jet_on_mm REAL NOT NULL,
  blocks INTEGER NOT NULL, moves INTEGER NOT NULL,
  violations INTEGER NOT NULL, collisions INTEGER NOT NULL, process_findings INTEGER NOT NULL, warnings INTEGER NOT NULL,
  energy_j REAL, extents TEXT NOT NULL, findings TEXT NOT NULL, cpu_s REAL NOT NULL
);
CREATE INDEX run_key ON run (key);
CREATE TABLE setting (
  run INTEGER NOT NULL REFERENCES run, name TEXT NOT NULL, value NOT NULL,
  PRIMARY KEY (run, name)
) WITHOUT ROWID;
CREATE TABLE input (
  id INTEGER PRIMARY KEY, file TEXT NOT NULL, sha256 TEXT NOT NULL, UNIQUE (file, sha256)
);
CREATE TABLE run_input (
  run INTEGER NOT NULL REFERENCES run, input INTEGER NOT NULL REFERENCES input, PRIMARY KEY (run, input)
) WITHOUT ROWID;
CREATE TABLE report (run INTEGER PRIMARY KEY REFERENCES run, json TEXT NOT NULL);
CREATE TABLE batch (
  id INTEGER PRIMARY KEY, token TEXT NOT NULL, plan TEXT NOT NULL, version TEXT NOT NULL, began_at TEXT NOT NULL, ended_at TEXT,
  jobs INTEGER NOT NULL, whole INTEGER NOT NULL DEFAULT 0
);
CREATE TABLE batch_run (
  batch INTEGER NOT NULL REFERENCES batch, job INTEGER NOT NULL, run INTEGER NOT NULL REFERENCES run,
  reused INTEGER NOT NULL, PRIMARY KEY (batch, job)
) WITHOUT ROWID;

CREATE VIEW latest AS
  SELECT batch_run.job, batch_run.reused, run.* FROM batch_run JOIN run ON run.id = batch_run.run
  WHERE batch_run.batch = (SELECT max(id) FROM batch) ORDER BY batch_run.job;
CREATE VIEW clean AS SELECT * FROM latest WHERE status = 'completed' AND cause = '';
CREATE VIEW failed AS SELECT * FROM latest WHERE status <> 'completed' OR cause <> '';
CREATE VIEW causes AS
  SELECT status, cause, count(*) AS runs, count(DISTINCT program) AS programs, min(program) AS example, message
  FROM failed GROUP BY status, cause ORDER BY runs DESC;
CREATE VIEW programs AS
  SELECT program, count(*) AS runs, sum(status <> 'completed' OR cause <> '') AS failed,
    min(CASE WHEN status = 'completed' THEN cycle_time_s END) AS shortest_s,
    max(CASE WHEN status = 'completed' THEN cycle_time_s END) AS longest_s
  FROM latest GROUP BY program;
CREATE VIEW machines AS
  SELECT machine, controller, count(*) AS runs, sum(status <> 'completed' OR cause <> '') AS failed,
    sum(CASE WHEN status = 'completed' THEN cycle_time_s END) AS cycle_time_s
  FROM latest GROUP BY machine, controller;
CREATE VIEW slowest AS
  SELECT program, machine, settings, cycle_time_s, cpu_s FROM latest ORDER BY cycle_time_s DESC;
)";

}  // namespace gsim::batch
