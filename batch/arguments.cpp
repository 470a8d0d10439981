#include "batch/arguments.h"

namespace gsim::batch {

void add_options(apps::CommandLine& line, Arguments& a) {
    using apps::FileKind;
    line.add("plan.toml|programs", &a.inputs,
             "a plan, or part programs, folders of them and patterns; without any, the existing results are "
             "reported")
        .takes_file(FileKind::input, {".toml", ".nc", ".ngc"});
    line.begin_group("Without a plan");
    line.add("--machine", &a.machines, "machine file or name; may be given more than once")
        .takes_file(FileKind::input, {".toml"});
    line.add("--machine-data", &a.machine_data, "machine data (NCFILE) of all runs")
        .takes_file(FileKind::input, {".txt"});
    line.add("--cell", &a.cell, "cell file of all runs").takes_file(FileKind::input, {".toml"});
    line.add("--dialect", &a.dialect, "language of the programs; default: as in the machine files")
        .with_value_name("NAME");
    line.add("--no-collisions", &a.no_collisions, "do not check for collisions and near misses");
    line.begin_group("Results");
    line.add("--results", &a.results, "file of all runs (SQLite): runs that it contains are not repeated")
        .takes_file(FileKind::changed, {".sqlite"})
        .with_value_name("FILE")
        .show_default();
    line.add("--reports", &a.reports, "also store the full report of each run");
    line.add("--pictures", &a.pictures, "also store a picture (SVG) of each run; it requires gnuplot");
    line.add("--csv", &a.outputs.csv, "write the runs of this batch as CSV; -: standard output")
        .takes_file(FileKind::output, {".csv"});
    line.add("--json-lines", &a.outputs.json_lines, "write the runs as JSON, one object per line")
        .takes_file(FileKind::output, {".jsonl"});
    line.add("--junit", &a.outputs.junit, "write the runs as a test report (JUnit)")
        .takes_file(FileKind::output, {".xml"});
    line.add("--sarif", &a.outputs.sarif, "write the errors of the programs as SARIF 2.1.0")
        .takes_file(FileKind::output, {".sarif"});
    line.add(
        "--statistics", &a.outputs.statistics,
        "print statistics of the variants of each program: mean, percentiles and failures with their "
        "intervals, and the settings that matter; compare machines with the first one, for each program");
    line.add("--statistics-json", &a.outputs.statistics_json, "write the statistics as JSON, with histograms")
        .takes_file(FileKind::output, {".json"});
    line.add("--page", &a.outputs.page, "write the statistics as a page with pictures")
        .takes_file(FileKind::output, {".html"});
    line.add("--pages", &a.outputs.pages,
             "write a front page, with the changes since the previous batch and the failures, and a page for "
             "each program to this folder; pages written there before are replaced, other files are kept")
        .takes_file(FileKind::folder);
    line.add("--views", &a.outputs.views,
             "with --pages: also write a page of the finished run (gsim run --view) for up to 200 runs that "
             "have changed or fail");
    line.add("--since", &a.outputs.since,
             "with statistics and pages: compare with this batch; 0: the previous one, the default of pages")
        .with_value_name("BATCH");
    line.add("-q,--quiet", &a.quiet, "no progress, no summary");
    line.begin_group("Execution of the runs");
    add_worker_options(line, a);
    line.begin_group("On a cluster (Slurm)");
    add_cluster_options(line, a,
                        "submit the batch: an array of tasks, each with a part of the runs in a separate "
                        "file next to the results, and a job that merges all; the same command submits only "
                        "the lost runs of an earlier batch again");
    line.add("--wait", &a.cluster.wait, "wait until all results are merged");
    line.add("--status", &a.cluster.status, "print the state of the batch");
    line.add("--cancel", &a.cluster.cancel, "cancel its tasks; the finished runs are kept");
    line.add_example("gsim-batch --machine mine.toml --machine other.toml programs/",
                     "each program of a folder on two machines");
    line.add_example("gsim-batch plan.toml --results nightly.sqlite --junit nightly.xml",
                     "the runs of a plan");
    line.add_example("gsim-batch programs/ --results nightly.sqlite --pages site",
                     "a nightly check, shown in a browser");
    line.add_example("gsim-batch plan.toml --slurm --results /shared/study.sqlite", "on a cluster");
    line.add_example("gsim-batch --results nightly.sqlite --csv -", "the runs of the last batch, as CSV");
    line.add_example("sqlite3 nightly.sqlite 'SELECT * FROM causes'",
                     "causes of failed runs, with their counts");
}

}  // namespace gsim::batch
