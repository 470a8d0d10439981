/* What a part program does on a machine, from C: each move with its line, then the report.
 * cc run.c $(pkg-config --cflags --libs libgsim) -o run && ./run /usr/share/gsim/samples/wheel.nc */
#include <gsim/gsim.h>
#include <stdio.h>

static void tell(void* user, const gsim_diagnostic* told) {
    (void)user;
    fprintf(stderr, "%s:%u: %s\n", told->file, told->line, told->text);
}

static void take_moves(void* user, const gsim_move* moves, size_t count) {
    size_t* total = user;
    for (size_t i = 0; i < count; ++i) {
        printf("%8.3f s  line %-4u %9.3f mm  X%.3f Y%.3f Z%.3f\n", moves[i].start_s, moves[i].line,
               moves[i].length_mm, moves[i].end[0], moves[i].end[1], moves[i].end[2]);
    }
    *total += count;
}

int main(int argc, char** argv) {
    if (argc < 2) return fprintf(stderr, "usage: run PROGRAM [MACHINE]\n"), 2;
    gsim_request* request = gsim_request_create();
    gsim_request_set_text(request, "program", argv[1]);
    if (argc > 2) gsim_request_set_text(request, "machine", argv[2]);
    gsim_run* run = gsim_run_open(request, tell, NULL);
    gsim_request_destroy(request);
    size_t moves = 0;
    int status = gsim_run_status(run);
    if (status == GSIM_OK) status = gsim_run_on_moves(run, 0, take_moves, &moves);
    if (status == GSIM_OK) status = gsim_run_go(run);
    if (status == GSIM_OK) {
        printf("%zu moves\n%s", moves, gsim_run_report_text(run));
        status = gsim_run_outcome(run) == GSIM_COMPLETED ? 0 : 1;
    } else {
        fprintf(stderr, "%s\n", gsim_run_error(run));
    }
    gsim_run_destroy(run);
    return status;
}
