#ifndef GSIM_RCS_MODULE_H
#define GSIM_RCS_MODULE_H

/* The C interface of a controller module: a shared library in which the maker of a controller ships its own
 * planner, for gsim-run --rcs. C11 and C++, no dependencies. docs/controller-modules.md shows one.
 *
 * Units: mm for lengths and prismatic joints, rad for angles and revolute joints, s for times. All text is
 * UTF-8 and ends with a zero byte. What the host passes is valid during the call alone. A module may be
 * created several times in a process; a call comes from one thread at a time for each. No exception may leave
 * a function of a module. */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Raised with every change that breaks modules, such as a field in a structure; host and module must agree on
 * it. New opcodes do not raise it: a module answers GSIM_RCS_NOT_SUPPORTED for a number that it does not
 * know. 2: gsim_rcs_joint.max_deceleration and row. */
#define GSIM_RCS_VERSION 2

#define GSIM_RCS_MAX_JOINTS 16
#define GSIM_RCS_NAME_SIZE 128     /* of a name with its zero byte */
#define GSIM_RCS_MESSAGE_SIZE 1024 /* of a message with its zero byte */

#if defined(_WIN32)
#define GSIM_RCS_EXPORT __declspec(dllexport)
#else
#define GSIM_RCS_EXPORT __attribute__((visibility("default")))
#endif

/* --- What a service answers: 0 success; negative: an error after which nothing has changed; positive:
 * success with something to tell. Any other number is a fault of the module. --- */

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

/* --- The machine, as gsim_rcs_create() gets it --- */

enum gsim_rcs_joint_kind { GSIM_RCS_PRISMATIC = 0, GSIM_RCS_REVOLUTE = 1 };

/* How poses become joint values: not at all; three slides and up to two rotary joints; any chain. */
enum gsim_rcs_inverse { GSIM_RCS_NO_INVERSE = 0, GSIM_RCS_GANTRY = 1, GSIM_RCS_NUMERIC = 2 };

/* A joint and its row of the Denavit-Hartenberg table, Rz(theta) Tz(d) Tx(a) Rx(alpha), where the joint's
 * value is added to d (prismatic) or theta (revolute). Limits are infinite where there are none. The table
 * leads from the work to the tool; joints that carry the work come first in it, whatever their numbers. */
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

/* A parameter of the controller: a key of the machine file's table [controller] and its value as TOML writes
 * it (docs/machine-file.md). A key that is not given has its default. */
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

/* --- What services take and give --- */

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

/* A value of a numbered criterion, kind of accuracy or conveyor. */
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

/* --- Opcodes: a service each, with its input and output (- for none: a null pointer). What each does is told
 * in docs/controller-modules.md. The numbers are of this interface and never change. --- */

enum gsim_rcs_opcode {
    GSIM_RCS_INITIALIZE = 1,  /* - | - */
    GSIM_RCS_RESET = 2,       /* - | - */
    GSIM_RCS_TERMINATE = 3,   /* - | - */
    GSIM_RCS_GET_MESSAGE = 4, /* - | message: why the last answer was no plain success */

    GSIM_RCS_GET_INVERSE_KINEMATICS = 10, /* pose_and_joints (joints: near these) | joints */
    GSIM_RCS_GET_FORWARD_KINEMATICS = 11, /* joints | pose */
    GSIM_RCS_GET_CELL_FRAME = 12,         /* frame (its name) | pose */
    GSIM_RCS_MODIFY_CELL_FRAME = 13,      /* frame | - */
    GSIM_RCS_SELECT_WORK_FRAMES = 14,     /* work_frames | - */

    GSIM_RCS_SELECT_TARGET_TYPE = 20,     /* integer: 0 Cartesian, 1 joint | - */
    GSIM_RCS_SELECT_TRAJECTORY_MODE = 21, /* integer | - */
    GSIM_RCS_SET_INITIAL_POSITION = 22,   /* position | - */
    GSIM_RCS_SET_NEXT_TARGET = 23,        /* target | - */
    GSIM_RCS_SET_NEXT_NAMED_TARGET = 24,  /* target | - */

    GSIM_RCS_GET_NEXT_STEP = 30,          /* - | step */
    GSIM_RCS_SET_INTERPOLATION_TIME = 31, /* number: s | - */
    GSIM_RCS_STOP_MOTION = 32,            /* - | - */
    GSIM_RCS_CONTINUE_MOTION = 33,        /* - | - */
    GSIM_RCS_CANCEL_MOTION = 34,          /* - | - */

    GSIM_RCS_SELECT_MOTION_TYPE = 40,                    /* integer: 1 joint, 2 linear, 4 circular | - */
    GSIM_RCS_SELECT_ORIENTATION_INTERPOLATION_MODE = 41, /* integer | - */
    GSIM_RCS_SELECT_DOMINANT_INTERPOLATION = 42, /* integer: 0 automatic, 1 position, 2 orientation | - */

    GSIM_RCS_SET_JOINT_SPEEDS = 50,                       /* joint_values | - */
    GSIM_RCS_SET_JOINT_ACCELERATIONS = 51,                /* joint_values | - */
    GSIM_RCS_SET_JOINT_JERKS = 52,                        /* joint_values | - */
    GSIM_RCS_SET_CARTESIAN_POSITION_SPEED = 53,           /* number: mm/s | - */
    GSIM_RCS_SET_CARTESIAN_ORIENTATION_SPEED = 54,        /* number: rad/s | - */
    GSIM_RCS_SET_CARTESIAN_POSITION_ACCELERATION = 55,    /* number: mm/s2 | - */
    GSIM_RCS_SET_CARTESIAN_ORIENTATION_ACCELERATION = 56, /* number: rad/s2 | - */
    GSIM_RCS_SET_OVERRIDE_SPEED = 57,                     /* number: percent | - */
    GSIM_RCS_SET_OVERRIDE_ACCELERATION = 58,              /* number: percent | - */
    GSIM_RCS_SET_MOTION_TIME = 59,                        /* number: s | - */
    GSIM_RCS_SET_REST_PARAMETER = 60,                     /* number: s | - */

    GSIM_RCS_SELECT_FLYBY_MODE = 70,            /* integer: switch | - */
    GSIM_RCS_SELECT_FLYBY_CRITERIA = 71,        /* integer | - */
    GSIM_RCS_SET_FLYBY_CRITERIA_PARAMETER = 72, /* parameter_value | - */
    GSIM_RCS_CANCEL_FLYBY_CRITERIA = 73,        /* integer | - */
    GSIM_RCS_SELECT_POINT_ACCURACY = 74,        /* integer | - */
    GSIM_RCS_SET_POINT_ACCURACY_PARAMETER = 75, /* parameter_value | - */

    GSIM_RCS_DEFINE_EVENT = 80,           /* event_definition | - */
    GSIM_RCS_CANCEL_EVENT = 81,           /* integer | - */
    GSIM_RCS_GET_EVENT = 82,              /* integer: number from 0 | event */
    GSIM_RCS_SELECT_TRACKING = 83,        /* tracking | - */
    GSIM_RCS_SET_CONVEYOR_POSITION = 84,  /* parameter_value: mm | - */
    GSIM_RCS_SET_OBJECT_SPEED = 85,       /* number: mm/s | - */
    GSIM_RCS_SET_OBJECT_NEXT_TARGET = 86, /* object_target | - */
    GSIM_RCS_GET_NEXT_OBJECT_STEP = 87,   /* - | object_step */

    /* Extensions: not services of RRS. */
    GSIM_RCS_SET_RAPID = 100,               /* integer: switch | - */
    GSIM_RCS_SET_NEXT_ARC_TARGET = 101,     /* arc_target | - */
    GSIM_RCS_SET_PATH_MODE = 102,           /* path_mode | - */
    GSIM_RCS_SET_NEXT_REST = 103,           /* rest | - */
    GSIM_RCS_GET_TARGET_OF_LAST_STEP = 104, /* - | target_id: whose motion or rest the last step ended in */
    GSIM_RCS_COME_TO_REST = 105,  /* integer: 0 more may come, 1 the controller waits, 2 the end | - */
    GSIM_RCS_SET_RAMP_MODE = 106, /* integer: 0 the machine's own, 1 linear, 2 S-curve, 3 infinite | - */
    GSIM_RCS_SET_JOINT_RAMP_LIMITS = 107, /* ramp_limits | - */
    GSIM_RCS_DEFINE_PATH_EVENT = 108      /* path_event_definition | - */
};

/* --- What a module exports, under these names --- */

typedef struct gsim_rcs_module gsim_rcs_module; /* the module's own */

/* GSIM_RCS_VERSION of the header that the module was compiled with. */
GSIM_RCS_EXPORT int32_t gsim_rcs_version(void);
/* A controller for the machine; null where it cannot be, then with a sentence in `message`. */
GSIM_RCS_EXPORT gsim_rcs_module* gsim_rcs_create(const gsim_rcs_machine* machine, gsim_rcs_message* message);
GSIM_RCS_EXPORT void gsim_rcs_destroy(gsim_rcs_module* module);
/* Calls a service; returns a gsim_rcs_status. */
GSIM_RCS_EXPORT int32_t gsim_rcs_call(gsim_rcs_module* module, int32_t opcode, const void* input,
                                      void* output);

#ifdef __cplusplus
}
#endif

#endif
