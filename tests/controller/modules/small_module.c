/*
 * Complete small controller module: joint targets in a queue of eight, each reached along a straight line at
 * the programmed speed without any acceleration, and dwells. If it is compiled with FAULT, it is broken in
 * one of several respects.
 */

#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "controller/module/rcs_module.h"

#define NO_FAULT 0
#define OTHER_VERSION 1
#define NO_INITIALIZE 2
#define NAN_ANSWER 3
#define BACKWARDS 4
#define CRASH_ON_LOAD 5
#define FEWER_JOINTS 6
#define NO_STATUS 7
#define WRONG_STATUS 8
#define JUMP 9
#define NO_MACHINE 10
#define ENDS_PROGRAM 11
#define NEVER_ARRIVES 12
#define LEAVES_OUTPUT 13
#define BREAKS_DOWN 14
#define CRASH_IN_CREATE 15
#define NO_RAPID 16
#define HANGS_ON_LOAD 17
#define ENDS_IN_CREATE 18
#define HANGS_IN_CREATE 19
#define HAS_BASE 20 /* no fault: it takes its base, too */
#define OVERSHOOTS 21

#ifndef FAULT
#define FAULT NO_FAULT
#endif

#define CAPACITY 8

typedef struct entry {
    double joints[GSIM_RCS_MAX_JOINTS]; /* where it ends */
    double duration_s;
} entry;

struct gsim_rcs_module {
    int32_t joint_count;
    double rapid_mm_s;
    int rapid;
    double speed_mm_s;
    double step_s;
    double position[GSIM_RCS_MAX_JOINTS]; /* at the start of the oldest entry */
    double spent_s;                       /* of the oldest entry */
    entry queue[CAPACITY];
    int first, count;
    const char* message;
};

static const entry* oldest(const gsim_rcs_module* m) {
    return &m->queue[m->first];
}

static const double* last_position(const gsim_rcs_module* m) {
    return m->count == 0 ? m->position : m->queue[(m->first + m->count - 1) % CAPACITY].joints;
}

static int32_t reject(gsim_rcs_module* m, int32_t status, const char* message) {
    m->message = message;
    return status;
}

static int32_t enqueue(gsim_rcs_module* m, const double* joints, double duration_s) {
    entry* e = &m->queue[(m->first + m->count) % CAPACITY];
    memcpy(e->joints, joints, sizeof e->joints);
    e->duration_s = duration_s;
    ++m->count;
    return GSIM_RCS_SUCCESS;
}

static int32_t put_target(gsim_rcs_module* m, const gsim_rcs_target* target) {
    const double speed = m->rapid ? m->rapid_mm_s : m->speed_mm_s;
    double square = 0;
    int i;
    if (m->count == CAPACITY) return reject(m, GSIM_RCS_QUEUE_FULL, "The queue is full.");
    if (!(speed > 0)) return reject(m, GSIM_RCS_ZERO_SPEED, "No speed is programmed.");
    for (i = 0; i < m->joint_count; ++i) {
        const double distance = target->position.joints.values[i] - last_position(m)[i];
        square += distance * distance;
    }
    return enqueue(m, target->position.joints.values, sqrt(square) / speed);
}

static int32_t enqueue_dwell(gsim_rcs_module* m, const gsim_rcs_rest* rest) {
    if (m->count == CAPACITY) return reject(m, GSIM_RCS_QUEUE_FULL, "The queue is full.");
    return enqueue(m, last_position(m), rest->rest_s);
}

/* Spends up to the time of a step on the entries of the queue. */
static int32_t step(gsim_rcs_module* m, double* elapsed_s) {
    int32_t status = m->count == 0 ? GSIM_RCS_NEED_MORE_DATA : GSIM_RCS_SUCCESS;
    double remaining_s = m->step_s;
    while (m->count > 0 && remaining_s > 0) {
        const double rest_s = oldest(m)->duration_s - m->spent_s;
        if (remaining_s < rest_s || FAULT == NEVER_ARRIVES) {
            m->spent_s += FAULT == NEVER_ARRIVES ? 0 : remaining_s;
            remaining_s = 0;
            break;
        }
        remaining_s -= rest_s;
        memcpy(m->position, oldest(m)->joints, sizeof m->position);
        m->spent_s = 0;
        m->first = (m->first + 1) % CAPACITY;
        --m->count;
        status = GSIM_RCS_TARGET_REACHED;
    }
    *elapsed_s = m->step_s - remaining_s;
    return status;
}

static void tell_position(const gsim_rcs_module* m, gsim_rcs_step* out) {
    const double share = m->spent_s > 0 ? m->spent_s / oldest(m)->duration_s : 0;
    int i;
    memset(out, 0, sizeof *out);
    out->joints.count = m->joint_count;
    for (i = 0; i < m->joint_count; ++i) {
        const double to = share > 0 ? oldest(m)->joints[i] : m->position[i];
        out->joints.values[i] = m->position[i] + share * (to - m->position[i]);
    }
    if (FAULT == OVERSHOOTS) out->joints.values[0] += 4 * share * (1 - share) * 10000;
    for (i = 0; i < 4; ++i) out->pose.matrix[5 * i] = 1;
}

static int32_t next_step(gsim_rcs_module* m, gsim_rcs_step* out) {
    double elapsed_s = 0;
    int32_t status;
    if (FAULT == LEAVES_OUTPUT) return GSIM_RCS_SUCCESS;
    if (FAULT == NO_STATUS) return 77;
    if (FAULT == BREAKS_DOWN) return reject(m, GSIM_RCS_FAULT, "out of memory");
    status = step(m, &elapsed_s);
    tell_position(m, out);
    out->elapsed_s = FAULT == BACKWARDS ? -elapsed_s : elapsed_s;
    if (FAULT == NAN_ANSWER) out->joints.values[m->joint_count - 1] = nan("");
    if (FAULT == FEWER_JOINTS) out->joints.count = 1;
    if (FAULT == JUMP && status == GSIM_RCS_NEED_MORE_DATA) out->joints.values[0] += 5;
    return status;
}

static int32_t set_initial_position(gsim_rcs_module* m, const gsim_rcs_position* position) {
    memcpy(m->position, position->joints.values, sizeof m->position);
    return GSIM_RCS_SUCCESS;
}

static void hang(void) {
    volatile int forever = 1;
    while (forever) {
    }
}

static int32_t initialize(gsim_rcs_module* m) {
    if (FAULT == NO_INITIALIZE) return GSIM_RCS_NOT_SUPPORTED;
    m->step_s = 0.01;
    m->message = "";
    return GSIM_RCS_SUCCESS;
}

GSIM_RCS_EXPORT int32_t gsim_rcs_version(void) {
    return FAULT == OTHER_VERSION ? GSIM_RCS_VERSION + 1 : GSIM_RCS_VERSION;
}

GSIM_RCS_EXPORT gsim_rcs_module* gsim_rcs_create(const gsim_rcs_machine* machine, gsim_rcs_message* message) {
    gsim_rcs_module* m = NULL;
    if (FAULT == NO_MACHINE) {
        strcpy(message->text, "It drives lathes alone.");
        return NULL;
    }
    if (FAULT == CRASH_IN_CREATE) abort();
    if (FAULT == ENDS_IN_CREATE) exit(0);
    if (FAULT == HANGS_IN_CREATE) hang();
    m = calloc(1, sizeof *m);
    if (m == NULL) return NULL;
    m->joint_count = machine->joint_count;
    m->rapid_mm_s = machine->max_rapid_mm_s;
    m->message = "";
    return m;
}

GSIM_RCS_EXPORT void gsim_rcs_destroy(gsim_rcs_module* m) {
    free(m);
}

GSIM_RCS_EXPORT int32_t gsim_rcs_call(gsim_rcs_module* m, int32_t opcode, const void* input, void* output) {
    switch (opcode) {
        case GSIM_RCS_INITIALIZE: return initialize(m);
        case GSIM_RCS_GET_MESSAGE: strcpy(((gsim_rcs_message*)output)->text, m->message); return 0;
        case GSIM_RCS_SELECT_TARGET_TYPE:
            return FAULT == WRONG_STATUS ? GSIM_RCS_TARGET_REACHED : GSIM_RCS_SUCCESS;
        case GSIM_RCS_SELECT_MOTION_TYPE: return GSIM_RCS_SUCCESS;
        case GSIM_RCS_SET_INITIAL_POSITION: return set_initial_position(m, input);
        case GSIM_RCS_SET_NEXT_TARGET: return put_target(m, input);
        case GSIM_RCS_SET_NEXT_REST: return enqueue_dwell(m, input);
        case GSIM_RCS_GET_NEXT_STEP: return next_step(m, output);
        case GSIM_RCS_SET_INTERPOLATION_TIME: m->step_s = ((const gsim_rcs_number*)input)->value; return 0;
        case GSIM_RCS_SET_CARTESIAN_POSITION_SPEED:
            m->speed_mm_s = ((const gsim_rcs_number*)input)->value;
            return GSIM_RCS_SUCCESS;
        case GSIM_RCS_SET_CARTESIAN_ORIENTATION_SPEED: return GSIM_RCS_SUCCESS;
        case GSIM_RCS_SET_RAPID:
            if (FAULT == NO_RAPID) return GSIM_RCS_NOT_SUPPORTED;
            m->rapid = ((const gsim_rcs_integer*)input)->value;
            return GSIM_RCS_SUCCESS;
        case GSIM_RCS_MODIFY_CELL_FRAME:
            if (FAULT == HAS_BASE && strcmp(((const gsim_rcs_frame*)input)->name, "base") == 0)
                return GSIM_RCS_SUCCESS;
            return GSIM_RCS_NOT_SUPPORTED;
        default: return GSIM_RCS_NOT_SUPPORTED;
    }
}

#if FAULT == CRASH_ON_LOAD || FAULT == ENDS_PROGRAM || FAULT == HANGS_ON_LOAD
__attribute__((constructor)) static void when_loaded(void) {
    if (FAULT == ENDS_PROGRAM) _Exit(0);
    if (FAULT == HANGS_ON_LOAD) hang();
    raise(SIGSEGV);
}
#endif
