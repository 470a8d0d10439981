#include "batch/arguments.h"

namespace gsim::batch {

void add_options(apps::CommandLine& line, Arguments& a) {
    using apps::FileKind;
    line.add("plan.toml|programs", &a.inputs,
             "a plan, or part programs, folders of them and patterns; without any the results that are there "
             "are told")
        .takes_file(FileKind::input, {".toml", ".nc", ".ngc"});
    line.begin_group("Without a plan");
    line.add("--machine", &a.machines, "machine file or name; as often as there are machines")
        .takes_file(FileKind::input, {".toml"});
    line.add("--machine-data", &a.machine_data, "machine data (NCFILE) of all runs")
        .takes_file(FileKind::input, {".txt"});
    line.add("--cell", &a.cell, "cell file of all runs").takes_file(FileKind::input, {".toml"});
    line.add("--dialect", &a.dialect, "language of the programs; else as the machine files say")
        .with_value_name("NAME");
    line.add("--no-collisions", &a.no_collisions, "do not look for collisions and near misses");
    line.begin_group("Results");
    line.add("--results", &a.results, "file of all runs (SQLite): what is in it is not run again")
        .takes_file(FileKind::changed, {".sqlite"})
        .with_value_name("FILE")
        .show_default();
    line.add("--reports", &a.reports, "keep the whole report of each run, too");
    line.add("--pictures", &a.pictures, "keep a picture (SVG) of each run, too; it needs gnuplot");
    line.add("--csv", &a.csv, "write the runs of this batch as CSV; -: standard output")
        .takes_file(FileKind::output, {".csv"});
    line.add("--json-lines", &a.json_lines, "the same as JSON, an object a line")
        .takes_file(FileKind::output, {".jsonl"});
    line.add("--junit", &a.junit, "write them as a test report (JUnit)")
        .takes_file(FileKind::output, {".xml"});
    line.add("--sarif", &a.sarif, "write what is wrong with the programs as SARIF 2.1.0")
        .takes_file(FileKind::output, {".sarif"});
    line.add("--statistics", &a.statistics,
             "tell what the variants of each program come to: mean, percentiles and failures with their "
             "intervals, "
             "which settings count; and machines against the first one, program by program");
    line.add("--statistics-json", &a.statistics_json, "write that as JSON, with histograms")
        .takes_file(FileKind::output, {".json"});
    line.add("--page", &a.page, "write it as a page with pictures").takes_file(FileKind::output, {".html"});
    line.add(
            "--pages", &a.pages,
            "write a front page, with what has changed since the batch before and what fails, and a page for "
            "each program into this folder; pages written there before are replaced, other files stay")
        .takes_file(FileKind::folder);
    line.add(
        "--views", &a.views,
        "with pages: also one that shows the finished run (gsim run --view) of each of up to 200 that have "
        "changed or fail");
    line.add("--since", &a.since,
             "with statistics and pages: against the batch of that number; 0: the one before, as pages have "
             "it "
             "without")
        .with_value_name("BATCH");
    line.add("-q,--quiet", &a.quiet, "no word on the way, no summary");
    line.begin_group("How it is run");
    add_worker_options(line, a);
    line.begin_group("On a cluster (Slurm)");
    add_cluster_options(
        line, a,
        "submit it: an array of tasks, each with a part of the runs in a file of its own beside the "
        "results, and a "
        "job that puts all together; what was lost of a batch before is all that the same command "
        "submits again");
    line.add("--wait", &a.wait, "stay until all is put together");
    line.add("--status", &a.status, "tell how far the batch is");
    line.add("--cancel", &a.cancel, "end its tasks; what they have done is kept");
    line.add_example("gsim-batch --machine mine.toml --machine other.toml programs/",
                     "each program of a folder on two machines");
    line.add_example("gsim-batch plan.toml --results nightly.sqlite --junit nightly.xml", "what a plan says");
    line.add_example("gsim-batch programs/ --results nightly.sqlite --pages site",
                     "a nightly check, to be read in a browser");
    line.add_example("gsim-batch plan.toml --slurm --results /shared/study.sqlite", "on a cluster");
    line.add_example("gsim-batch --results nightly.sqlite --csv -", "the runs of the batch before, as CSV");
    line.add_example("sqlite3 nightly.sqlite 'SELECT * FROM causes'", "why runs fail, and how many");
}

}  // namespace gsim::batch
