#ifndef GSIM_H
#define GSIM_H

/*
 *  The engine of gsim for C, and for languages that call C. Handles are opaque; texts are UTF-8 and end in a
 *  zero byte. The result of a function belongs to its handle and is valid until the handle's next call,
 *  unless stated otherwise. Functions that can fail return GSIM_OK or another status; gsim_run_error() has
 *  the message. A handle is for one thread at a time, except for gsim_run_cancel().
 */

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#pragma GCC visibility push(default)
#endif

#ifdef __cplusplus
extern "C" {
#endif

/*  Increases with additions; existing functions do not change. */
#define GSIM_API_VERSION 1

/*  Marks names of version 0.1, which have new ones. They are removed in 0.3. */
#if defined(__GNUC__)
#define GSIM_RENAMED(new_name) __attribute__((deprecated("use " #new_name)))
#else
#define GSIM_RENAMED(new_name)
#endif

#define GSIM_MAX_AXES 16

/* Statuses. */
#define GSIM_OK 0
#define GSIM_REJECTED 1 /* The program has errors, which have been reported. */
#define GSIM_FAILED 2   /* A file, an argument, a lack of memory. */

/* How a run ended. */
#define GSIM_COMPLETED 0
#define GSIM_VIOLATIONS 1 /* At its end, past limits of the machine. */
#define GSIM_STOPPED 2    /* By a limit of the run, or gsim_run_cancel(). */
#define GSIM_ALARM 3

/* Severities. */
#define GSIM_ERROR 0
#define GSIM_WARNING 1
#define GSIM_NOTE 2

/* Kinds of moves. */
#define GSIM_RAPID 0
#define GSIM_LINEAR 1
#define GSIM_ARC_CW 2
#define GSIM_ARC_CCW 3
#define GSIM_DWELL 4
#define GSIM_PROBE 5
#define GSIM_THREAD 6
#define GSIM_SPLINE 7

/* Kinds of segments. */
#define GSIM_JOINT_SEGMENT 0
#define GSIM_LINEAR_SEGMENT 1
#define GSIM_CIRCULAR_SEGMENT 2
#define GSIM_STANDSTILL_SEGMENT 3

typedef struct gsim_request gsim_request;
typedef struct gsim_run gsim_run;
typedef struct gsim_bytes gsim_bytes;

/*  One message about an input or a run. Lines and columns count from 1; 0: not known. */
typedef struct gsim_diagnostic {
    int32_t severity;
    uint32_t line;
    uint32_t column;
    uint32_t end_column;
    const char* code; /* "axis-limit" */
    const char* file;
    const char* text;
    const char* hint;
} gsim_diagnostic;

/*  An executed move. Axes are in the order of gsim_run_axis(), in mm or deg. */
typedef struct gsim_move {
    uint64_t n; /* From 1. */
    double start_s;
    double end_s;
    double length_mm;
    double feed_per_min; /* As programmed, mm/min or deg/min; 0 in rapids and dwells. */
    double deviation_mm; /* Distance of the tool from its corners if they are rounded. */
    double end[GSIM_MAX_AXES];
    double center_mm[3]; /* Of a circle, with its axis (right hand), radius and angle. */
    double axis[3];
    double radius_mm;
    double sweep_rad; /* 0: not circular. */
    int32_t kind;
    union {
        int32_t process_on; /* The jet, plasma, laser or spindle was on. */
        int32_t jet_on GSIM_RENAMED(process_on);
    };
    uint32_t line;
    uint32_t file; /* For gsim_run_file(). */
} gsim_move;

/*  A part of motion; `exact` is valid in the call alone. */
typedef struct gsim_segment {
    double start_s;
    double duration_s;
    double length_mm;
    double start[GSIM_MAX_AXES];
    double end[GSIM_MAX_AXES];
    int32_t kind;
    union {
        int32_t process_on; /* The jet, plasma, laser or spindle was on. */
        int32_t jet_on GSIM_RENAMED(process_on);
    };
    uint32_t line;
    uint32_t reserved;
    const void* exact;
} gsim_segment;

/* An instant of the run. */
typedef struct gsim_sample {
    double t_s;
    double speed_mm_s; /* Of the tool along its path. */
    double axes[GSIM_MAX_AXES];
    uint32_t line;
    uint32_t reserved;
} gsim_sample;

/*  Passes the bytes of a file to gsim_bytes_append() and returns 1, or 0 if no such file exists. */
typedef int32_t (*gsim_read_file)(void* user, const char* name, gsim_bytes* bytes);
typedef void (*gsim_on_diagnostic)(void* user, const gsim_diagnostic* diagnostic);
typedef void (*gsim_on_moves)(void* user, const gsim_move* moves, size_t count);
typedef void (*gsim_on_segments)(void* user, const gsim_segment* segments, size_t count);
typedef void (*gsim_on_samples)(void* user, const gsim_sample* samples, size_t count);
/*  Returns 0 if the text cannot be written: no more is passed then. */
typedef int32_t (*gsim_write_text)(void* user, const char* text, size_t size);
/* `total` 0: not known. */
typedef void (*gsim_on_progress)(void* user, uint64_t done, uint64_t total);

/*  Returns GSIM_API_VERSION of the library, and its version as text. */
int32_t gsim_api_version(void);
const char* gsim_version(void);

/*  Creates a request: a program and its environment. Null: no memory. */
gsim_request* gsim_request_create(void);
void gsim_request_destroy(gsim_request* request);
/* Keys: program, machine, machine_data, cell, setup, robots, variables, library, probe (names of files and
 * words, as the options of gsim-run), dialect, unknown, overrides. */
int32_t gsim_request_set_text(gsim_request* request, const char* key, const char* value);
/*
 *  Keys: machine_s, cpu_s, blocks, steps, memory_bytes, passes, feed_override_percent,
 *  rapid_override_percent, spindle_override_percent, and those that are 0 or 1: stop_at_first, collisions,
 *  block_delete, optional_stop, explain. GSIM_FAILED: unknown key, or a value out of its range.
 */
int32_t gsim_request_set_number(gsim_request* request, const char* key, double value);
/*  Sets this text as the program instead of a file; `name` is for messages. */
int32_t gsim_request_set_program(gsim_request* request, const char* text, size_t size, const char* name);
/*  Reads files by their names from `read` only; without it from the system. It must outlive the run. */
int32_t gsim_request_set_files(gsim_request* request, gsim_read_file read, void* user);
int32_t gsim_bytes_append(gsim_bytes* bytes, const void* data, size_t size);

/*
 *  Reads machine and cell, the program and the files that it names. `on_diagnostic` receives errors until the
 *  run is destroyed; it may be null. The request may be destroyed at once. Null: no memory. gsim_run_status()
 *  returns if it can run.
 */
gsim_run* gsim_run_open(const gsim_request* request, gsim_on_diagnostic on_diagnostic, void* user);
void gsim_run_destroy(gsim_run* run);
/*  Returns GSIM_OK, or the reason why it has not been opened or run. */
int32_t gsim_run_status(const gsim_run* run);
/*  Returns the message of the last failure; empty: none. */
const char* gsim_run_error(const gsim_run* run);

/*  Returns the number of machines, one except in a run of several robots. */
size_t gsim_run_robot_count(const gsim_run* run);
const char* gsim_run_robot_name(const gsim_run* run, size_t robot);
/*
 *  Return for an axis: the letter, 0 past the last one; 1 if its values are deg; its position at the start.
 */
char gsim_run_axis(const gsim_run* run, size_t robot, size_t axis);
int32_t gsim_run_axis_is_rotary(const gsim_run* run, size_t robot, size_t axis);
double gsim_run_home(const gsim_run* run, size_t robot, size_t axis);

/*  Request results during the run; to be called before gsim_run_go(). */
int32_t gsim_run_on_moves(gsim_run* run, size_t robot, gsim_on_moves handler, void* user);
int32_t gsim_run_on_segments(gsim_run* run, size_t robot, gsim_on_segments handler, void* user);
/*  Delivers samples each `step_s` (1e-6 at least), and at the last instant. */
int32_t gsim_run_on_samples(gsim_run* run, size_t robot, double step_s, gsim_on_samples handler, void* user);
/*  Writes an output, by the words of gsim/engine/outputs.def: "moves", "dxf", ... */
int32_t gsim_run_write(gsim_run* run, size_t robot, const char* output, double step_s, gsim_write_text write,
                       void* user);
int32_t gsim_run_on_progress(gsim_run* run, gsim_on_progress handler, void* user);

/*  Runs to the end, an alarm, a limit, or gsim_run_cancel(). GSIM_OK: a report is available in any case. */
int32_t gsim_run_go(gsim_run* run);
/*  Cancels from any thread, from a callback, and before the run has begun. */
void gsim_run_cancel(gsim_run* run);

/*  Available after gsim_run_go(), or after a program that was rejected. */
int32_t gsim_run_outcome(const gsim_run* run); /* GSIM_COMPLETED, ... */
double gsim_run_cycle_time_s(const gsim_run* run);
const char* gsim_run_report_json(gsim_run* run);
const char* gsim_run_report_text(gsim_run* run);
const char* gsim_run_file(const gsim_run* run, uint32_t file);
/*
 *  Returns the data that the controller keeps: files of permanent variables and of machine data. Null:
 *  gsim_run_error().
 */
const char* gsim_run_variables(gsim_run* run);
const char* gsim_run_machine_data(gsim_run* run);

/*  For the call of gsim_on_segments: `t_s` counts from the segment's start. */
void gsim_segment_axes(const gsim_segment* segment, double t_s, double axes[GSIM_MAX_AXES]);
double gsim_segment_speed_mm_s(const gsim_segment* segment, double t_s);

/*
 *  Translates a part program to a Lua script, by the request's program, machine, machine_data, dialect,
 *  unknown and cpu_s.
 */
int32_t gsim_translate(const gsim_request* request, gsim_on_diagnostic on_diagnostic, void* diagnostic_user,
                       gsim_write_text write, void* write_user);

#ifndef GSIM_NO_OLD_NAMES
/* Names of version 0.1, until 0.3. GSIM_NO_OLD_NAMES omits them. */
enum {
    GSIM_MOST_AXES GSIM_RENAMED(GSIM_MAX_AXES) = GSIM_MAX_AXES,
    GSIM_REFUSED GSIM_RENAMED(GSIM_REJECTED) = GSIM_REJECTED,
    GSIM_REST_SEGMENT GSIM_RENAMED(GSIM_STANDSTILL_SEGMENT) = GSIM_STANDSTILL_SEGMENT
};
typedef gsim_on_diagnostic gsim_tell GSIM_RENAMED(gsim_on_diagnostic);
typedef gsim_on_moves gsim_take_moves GSIM_RENAMED(gsim_on_moves);
typedef gsim_on_segments gsim_take_segments GSIM_RENAMED(gsim_on_segments);
typedef gsim_on_samples gsim_take_samples GSIM_RENAMED(gsim_on_samples);
typedef gsim_write_text gsim_take_text GSIM_RENAMED(gsim_write_text);
typedef gsim_on_progress gsim_show_progress GSIM_RENAMED(gsim_on_progress);

GSIM_RENAMED(gsim_bytes_append) int32_t gsim_bytes_put(gsim_bytes* bytes, const void* data, size_t size);
GSIM_RENAMED(gsim_run_robot_count) size_t gsim_run_robots(const gsim_run* run);
GSIM_RENAMED(gsim_run_robot_name) const char* gsim_run_robot(const gsim_run* run, size_t robot);
GSIM_RENAMED(gsim_run_on_moves)
int32_t gsim_run_take_moves(gsim_run* run, size_t robot, gsim_on_moves handler, void* user);
GSIM_RENAMED(gsim_run_on_segments)
int32_t gsim_run_take_segments(gsim_run* run, size_t robot, gsim_on_segments handler, void* user);
GSIM_RENAMED(gsim_run_on_samples)
int32_t gsim_run_take_samples(gsim_run* run, size_t robot, double step_s, gsim_on_samples handler,
                              void* user);
GSIM_RENAMED(gsim_run_on_progress)
int32_t gsim_run_show_progress(gsim_run* run, gsim_on_progress handler, void* user);
#endif

#ifdef __cplusplus
}
#endif

#if defined(__GNUC__)
#pragma GCC visibility pop
#endif

#endif
