#ifndef GSIM_RCS_MODULE_H
#define GSIM_RCS_MODULE_H

/*
 *  The C interface of a controller module: a shared library in which the maker of a controller ships its own
 * planner, for gsim-run --rcs. C11 and C++, no dependencies. docs/controller-modules.md shows one.
 *
 * Units: mm for lengths and prismatic joints, rad for angles and revolute joints, s for times. All text is
 * UTF-8 and ends with a zero byte. Data that the host passes are valid only during the call. A module may be
 * created several times in a process; for each instance, calls come from one thread at a time. No exception
 * may leave a function of a module.
 */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/*
 *  Version, raised with every change that breaks modules, such as a field in a structure; host and module
 *  must agree on it. New opcodes do not raise it: a module returns GSIM_RCS_NOT_SUPPORTED for a number that
 *  it does not know. 2: gsim_rcs_joint.max_deceleration and row.
 */
#define GSIM_RCS_VERSION 2

#define GSIM_RCS_MAX_JOINTS 16
#define GSIM_RCS_NAME_SIZE 128     /* of a name with its zero byte */
#define GSIM_RCS_MESSAGE_SIZE 1024 /* of a message with its zero byte */

#if defined(_WIN32)
#define GSIM_RCS_EXPORT __declspec(dllexport)
#else
#define GSIM_RCS_EXPORT __attribute__((visibility("default")))
#endif

/*
 *  --- Status of a service: 0 success; negative: an error after which nothing has changed; positive: success
 *  with additional information. Any other number is an error of the module. ---
 */

enum gsim_rcs_status {
    GSIM_RCS_SUCCESS = 0,
    GSIM_RCS_NEED_MORE_DATA = 1,     /* step: the queue is empty, the robot is at rest */
    GSIM_RCS_TARGET_REACHED = 2,     /* step: a target was reached in it */
    GSIM_RCS_MOTION_TIME_RAISED = 3, /* target: queued, but takes longer than SET_MOTION_TIME asked */
    GSIM_RCS_NOT_INITIALIZED = -1,
    GSIM_RCS_NOT_SUPPORTED = -2, /* the service is not offered at all */
    GSIM_RCS_MOTION_TYPE_NOT_SUPPORTED = -3,
    GSIM_RCS_INVALID_PARAMETER = -4,
    GSIM_RCS_NO_INITIAL_POSITION = -5,
    GSIM_RCS_NO_SOLUTION = -6,
    GSIM_RCS_JOINT_LIMIT = -7,
    GSIM_RCS_CIRCLE_IMPOSSIBLE = -8,
    GSIM_RCS_MODE_NOT_SUPPORTED = -9,
    GSIM_RCS_UNKNOWN_FRAME = -10,
    GSIM_RCS_ZERO_SPEED = -11,
    GSIM_RCS_QUEUE_FULL = -12, /* target: steps must be taken before more targets are put */
    GSIM_RCS_FAULT = -13       /* the module is broken, such as out of memory; the run ends */
};

/*  --- The machine, as passed to gsim_rcs_create() --- */

enum gsim_rcs_joint_kind { GSIM_RCS_PRISMATIC = 0, GSIM_RCS_REVOLUTE = 1 };

/*  Inverse kinematics of the machine: none; three slides and up to two rotary joints; any chain. */
enum gsim_rcs_inverse { GSIM_RCS_NO_INVERSE = 0, GSIM_RCS_GANTRY = 1, GSIM_RCS_NUMERIC = 2 };

/*
 *  A joint and its row of the Denavit-Hartenberg table, Rz(theta) Tz(d) Tx(a) Rx(alpha), in which the joint's
 *  value is added to d (prismatic) or theta (revolute). A missing limit is infinite. The table leads from the
 *  work to the tool; joints that carry the work come first in it, whatever their numbers.
 */
typedef struct gsim_rcs_joint {
    int32_t kind; /* gsim_rcs_joint_kind */
    int32_t row;  /* which row of the table is the joint's, from 0 up; its own number where none carry work */
    double min, max;
    double max_speed, max_acceleration, max_deceleration, max_jerk;
    double max_speed_step; /* jump of speed that the joint stands at a corner */
    double step;           /* smallest step; 0: none */
    double dh_theta_rad, dh_d_mm, dh_a_mm, dh_alpha_rad;
} gsim_rcs_joint;

/* A homogeneous 4x4 matrix by rows, mm. */
typedef struct gsim_rcs_pose {
    double matrix[16];
} gsim_rcs_pose;

/*
 *  A parameter of the controller: a key of the machine file's table [controller] and its value in TOML syntax
 *  (docs/machine-file.md). A missing key has its default.
 */
typedef struct gsim_rcs_parameter {
    const char* key;
    const char* value;
} gsim_rcs_parameter;

typedef struct gsim_rcs_machine {
    int32_t joint_count; /* 1 to GSIM_RCS_MAX_JOINTS */
    int32_t has_inverse; /* gsim_rcs_inverse */
    gsim_rcs_joint joints[GSIM_RCS_MAX_JOINTS];
    int32_t position_joints[3]; /* prismatic joints that carry the tool along x, y, z; -1 where absent */
    int32_t queue_capacity;     /* targets that the module should hold before it answers QUEUE_FULL */
    gsim_rcs_pose base;         /* work to the first row of the table */
    gsim_rcs_pose tool;         /* last row to the tool centre point */
    double max_feed_mm_s;       /* of the tool's path */
    double max_rapid_mm_s;
    double max_acceleration_mm_s2;
    double arc_tolerance_mm; /* how far the end of an arc may lie off its circle */
    const gsim_rcs_parameter* parameters;
    size_t parameter_count;
} gsim_rcs_machine;

/*  --- Inputs and outputs of services --- */

typedef struct gsim_rcs_number {
    double value;
} gsim_rcs_number;

typedef struct gsim_rcs_integer {
    int32_t value; /* of a switch 0 or 1 */
} gsim_rcs_integer;

typedef struct gsim_rcs_joints {
    int32_t count;
    int32_t reserved;
    double values[GSIM_RCS_MAX_JOINTS];
} gsim_rcs_joints;

typedef struct gsim_rcs_message {
    char text[GSIM_RCS_MESSAGE_SIZE];
} gsim_rcs_message;

typedef struct gsim_rcs_pose_and_joints {
    gsim_rcs_pose pose;
    gsim_rcs_joints joints;
} gsim_rcs_pose_and_joints;

typedef struct gsim_rcs_frame {
    char name[GSIM_RCS_NAME_SIZE];
    gsim_rcs_pose pose;
} gsim_rcs_frame;

typedef struct gsim_rcs_work_frames {
    char tool[GSIM_RCS_NAME_SIZE];
    char object[GSIM_RCS_NAME_SIZE];
} gsim_rcs_work_frames;

typedef struct gsim_rcs_position {
    gsim_rcs_pose pose;
    gsim_rcs_joints joints;
    char configuration[GSIM_RCS_NAME_SIZE];
} gsim_rcs_position;

typedef struct gsim_rcs_target {
    int64_t id;
    int32_t param; /* 0: end of a motion, 1: via point of a circular motion */
    int32_t reserved;
    gsim_rcs_position position;
    double param_value;
    char name[GSIM_RCS_NAME_SIZE]; /* of SET_NEXT_NAMED_TARGET; else empty */
} gsim_rcs_target;

typedef struct gsim_rcs_arc_target {
    int64_t id;
    double center_mm[3]; /* any point of the circle's axis */
    double axis[3];      /* unit vector; travel is counter-clockwise about it */
    double sweep_rad;    /* > 0, more than 2 pi for several turns */
    gsim_rcs_pose_and_joints end;
} gsim_rcs_arc_target;

typedef struct gsim_rcs_rest {
    int64_t id;
    double rest_s;
} gsim_rcs_rest;

typedef struct gsim_rcs_step {
    gsim_rcs_joints joints;
    gsim_rcs_pose pose;
    double elapsed_s; /* of this step: from 0 to the interpolation time */
} gsim_rcs_step;

typedef struct gsim_rcs_target_id {
    int64_t id;
} gsim_rcs_target_id;

/* `joint_count` indices from 0, or none for all joints in order; one value each. */
typedef struct gsim_rcs_joint_values {
    int32_t joint_count;
    int32_t value_count;
    int32_t joints[GSIM_RCS_MAX_JOINTS];
    double values[GSIM_RCS_MAX_JOINTS];
} gsim_rcs_joint_values;

/*  A value of a numbered criterion, a kind of accuracy or a conveyor. */
typedef struct gsim_rcs_parameter_value {
    int32_t number;
    int32_t joint; /* of SET_FLYBY_CRITERIA_PARAMETER: from 0, -1 for all; else 0 */
    double value;
} gsim_rcs_parameter_value;

typedef struct gsim_rcs_event_definition {
    int64_t target;
    int32_t event;
    int32_t reserved;
    double offset_s;
} gsim_rcs_event_definition;

typedef struct gsim_rcs_path_event_definition {
    int64_t target;
    int32_t event;
    int32_t reserved;
    double offset_mm; /* of the tool's way; negative: before the target */
} gsim_rcs_path_event_definition;

typedef struct gsim_rcs_event {
    int32_t event;
    int32_t reserved;
    double time_s; /* since the start of the last step; negative where it was known too late for its step */
} gsim_rcs_event;

typedef struct gsim_rcs_tracking {
    int32_t conveyor;
    int32_t on;
} gsim_rcs_tracking;

typedef struct gsim_rcs_object_target {
    int64_t id;
    gsim_rcs_pose pose;
} gsim_rcs_object_target;

typedef struct gsim_rcs_object_step {
    gsim_rcs_pose pose;
    double elapsed_s;
} gsim_rcs_object_step;

typedef struct gsim_rcs_conveyor {
    int32_t conveyor;
    int32_t reserved;
    double direction[3]; /* of the world, of any length */
    double speed_mm_s;   /* negative: backwards */
} gsim_rcs_conveyor;

typedef struct gsim_rcs_tip_control {
    int32_t on;
    int32_t reserved;
    double tip_mm[3]; /* in the frame of the tool centre point */
} gsim_rcs_tip_control;

typedef struct gsim_rcs_ramp_limits {
    int32_t limit; /* 0: acceleration, 1: deceleration, 2: jerk */
    int32_t reserved;
    gsim_rcs_joint_values values; /* infinite: the joint's own limit */
} gsim_rcs_ramp_limits;

typedef struct gsim_rcs_path_mode {
    int32_t mode; /* 0: exact stop, 1: exact path, 2: continuous */
    int32_t reserved;
    double tolerance_mm;
    double merge_tolerance_mm;
} gsim_rcs_path_mode;

/*
 *  --- Opcodes: one for each service, with its input and output (none: a null pointer). rcs_services.def
 *  lists and describes them; docs/services.md is the same for reading. The numbers belong to this interface
 *  and never change. ---
 */

enum gsim_rcs_opcode {
#define GSIM_RCS_SERVICE(method, opcode, number, rrs, input, answers, parameters, arguments) \
    GSIM_RCS_##opcode = (number),
#include "rcs_services.def"
};

/*  --- Exports of a module, under these names --- */

typedef struct gsim_rcs_module gsim_rcs_module; /* the module's own */

/*  Returns GSIM_RCS_VERSION of the header that the module was compiled with. */
GSIM_RCS_EXPORT int32_t gsim_rcs_version(void);
/*  Creates a controller for the machine; returns null if that is impossible, with the reason in `message`. */
GSIM_RCS_EXPORT gsim_rcs_module* gsim_rcs_create(const gsim_rcs_machine* machine, gsim_rcs_message* message);
GSIM_RCS_EXPORT void gsim_rcs_destroy(gsim_rcs_module* module);
/* Calls a service; returns a gsim_rcs_status. */
GSIM_RCS_EXPORT int32_t gsim_rcs_call(gsim_rcs_module* module, int32_t opcode, const void* input,
                                      void* output);

#ifdef __cplusplus
}
#endif

#endif
