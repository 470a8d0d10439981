// Functions of gsim.h by their names of version 0.1, so that programs that were linked with it still run.
// Removed in 0.3.
#include "engine/gsim.h"

int32_t gsim_bytes_put(gsim_bytes* bytes, const void* data, size_t size) {
    return gsim_bytes_append(bytes, data, size);
}

size_t gsim_run_robots(const gsim_run* run) {
    return gsim_run_robot_count(run);
}

const char* gsim_run_robot(const gsim_run* run, size_t robot) {
    return gsim_run_robot_name(run, robot);
}

int32_t gsim_run_take_moves(gsim_run* run, size_t robot, gsim_on_moves handler, void* user) {
    return gsim_run_on_moves(run, robot, handler, user);
}

int32_t gsim_run_take_segments(gsim_run* run, size_t robot, gsim_on_segments handler, void* user) {
    return gsim_run_on_segments(run, robot, handler, user);
}

int32_t gsim_run_take_samples(gsim_run* run, size_t robot, double step_s, gsim_on_samples handler,
                              void* user) {
    return gsim_run_on_samples(run, robot, step_s, handler, user);
}

int32_t gsim_run_show_progress(gsim_run* run, gsim_on_progress handler, void* user) {
    return gsim_run_on_progress(run, handler, user);
}
