/* The small module, but in one of its services, once it has moved for a while, it does to its process what
 * DOES says. */

#define _GNU_SOURCE
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#define gsim_rcs_call small_call
#define gsim_rcs_destroy small_destroy
#include "tests/controller/modules/small_module.c"
#undef gsim_rcs_call
#undef gsim_rcs_destroy

#define CRASHES 1
#define ABORTS 2
#define EXITS 3
#define HANGS 4
#define SLEEPS 5
#define HOGS_MEMORY 6
#define PRINTS 7
#define CLOSES_DESCRIPTORS 8
#define WRITES_EVERYWHERE 9
#define BLOCKS_SIGNALS 10
#define LEAVES_A_CHILD 11
#define CRASHES_IN_DESTROY 12
#define CRASHES_IN_TARGET 13
#define CRASHES_WHERE_TARGETS_ARE_TOLD 14
#define FILLS_SHARED_MEMORY 15
#define EXITS_IN_DESTROY 17
#define HANGS_IN_DESTROY 18
#define CRASHES_IN_SECOND_TRY 20
#define SPENDS_TIME 21

enum { FIRST_STEPS = 50, FIRST_DESCRIPTOR = 3, LAST_DESCRIPTOR = 1024 };

static int steps = 0;
static int full = 0;

static void crash(void) {
    raise(SIGSEGV);
}

static void block_signals(void) {
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, NULL);
    signal(SIGTERM, SIG_IGN);
    hang();
}

/* Allocates a gigabyte at most, so that a test without a limit fails and does not bring down the machine. */
static void hog_memory(void) {
    const size_t chunk = 64U << 20U;
    int i;
    for (i = 0; i < 16; ++i) {
        char* const more = malloc(chunk);
        if (more == NULL) abort();
        memset(more, 1, chunk);
    }
}

/* All that is open but the standard streams. */
static void write_everywhere(void) {
    int descriptor;
    const char rubbish[] = "0123456789abcdef01234567 and more";
    for (descriptor = FIRST_DESCRIPTOR; descriptor < LAST_DESCRIPTOR; ++descriptor)
        if (write(descriptor, rubbish, sizeof rubbish) < 0) continue;
}

static void close_descriptors(void) {
    int descriptor;
    for (descriptor = FIRST_DESCRIPTOR; descriptor < LAST_DESCRIPTOR; ++descriptor) close(descriptor);
}

/* It holds what its parent has open, and its parent is gone. */
static void leave_a_child(void) {
    if (fork() == 0) {
        sleep(600);
        _exit(0);
    }
    crash();
}

static void fill_shared_memory(void) {
    char line[512];
    FILE* const maps = fopen("/proc/self/maps", "r");
    while (maps != NULL && fgets(line, sizeof line, maps) != NULL) {
        unsigned long from = 0, to = 0;
        if (strstr(line, "memfd:gsim-rcs") != NULL && sscanf(line, "%lx-%lx", &from, &to) == 2)
            memset((void*)from, 0xff, to - from);
    }
    if (maps != NULL) fclose(maps);
}

/* 10 ms of the processor, a step. */
static void spend_time(void) {
    const clock_t from = clock();
    while (clock() - from < CLOCKS_PER_SEC / 100) continue;
}

static void misbehave(void) {
    if (DOES == CRASHES) crash();
    if (DOES == ABORTS) abort();
    if (DOES == EXITS) exit(3);
    if (DOES == HANGS) hang();
    if (DOES == SLEEPS) sleep(600);
    if (DOES == HOGS_MEMORY) hog_memory();
    if (DOES == CLOSES_DESCRIPTORS) close_descriptors();
    if (DOES == WRITES_EVERYWHERE) write_everywhere();
    if (DOES == BLOCKS_SIGNALS) block_signals();
    if (DOES == LEAVES_A_CHILD) leave_a_child();
    if (DOES == FILLS_SHARED_MEMORY) fill_shared_memory();
    if (DOES == SPENDS_TIME) spend_time();
}

GSIM_RCS_EXPORT int32_t gsim_rcs_call(gsim_rcs_module* m, int32_t opcode, const void* input, void* output) {
    if (opcode == GSIM_RCS_GET_NEXT_STEP && ++steps > FIRST_STEPS) misbehave();
    if (opcode == GSIM_RCS_SET_NEXT_TARGET && DOES == CRASHES_IN_TARGET) crash();
    if (opcode == GSIM_RCS_SET_NEXT_TARGET && DOES == CRASHES_IN_SECOND_TRY && full) crash();
    if (opcode == GSIM_RCS_SET_NEXT_TARGET && m->count == CAPACITY) full = 1;
    if (opcode == GSIM_RCS_GET_TARGET_OF_LAST_STEP && DOES == CRASHES_WHERE_TARGETS_ARE_TOLD) {
        if (steps > FIRST_STEPS) crash();
        ((gsim_rcs_target_id*)output)->id = 1;
        return GSIM_RCS_SUCCESS;
    }
    if (DOES == PRINTS) printf("rubbish %d\n", opcode), fflush(stdout);
    return small_call(m, opcode, input, output);
}

GSIM_RCS_EXPORT void gsim_rcs_destroy(gsim_rcs_module* m) {
    if (steps > 0) {
        if (DOES == CRASHES_IN_DESTROY) crash();
        if (DOES == EXITS_IN_DESTROY) exit(3);
        if (DOES == HANGS_IN_DESTROY) hang();
    }
    small_destroy(m);
}
