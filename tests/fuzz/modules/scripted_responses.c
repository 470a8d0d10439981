/*
 * Controller module with given answers: it makes each motion in one step, and answers as the bytes of its
 * parameter "answers" (as many as "answers_size" says) define. A byte below KEEPS leaves an answer as it is.
 * Any other one decides if the status and eight bytes of the output are overwritten with those that follow.
 */

#include <stdlib.h>
#include <string.h>

#include "controller/module/rcs_module.h"

#define KEEPS 0xC0
#define CHANGES_STATUS 1
#define CHANGES_OUTPUT 2
#define WORD 8

struct gsim_rcs_module {
    int32_t joint_count;
    double step_s;
    gsim_rcs_joints at;
    int64_t target;
    int arrives; /* the next step ends at the target */
    unsigned char* response_bytes;
    size_t size, read;
};

static unsigned char next_byte(gsim_rcs_module* m) {
    return m->read < m->size ? m->response_bytes[m->read++] : 0;
}

static size_t output_size(int32_t opcode) {
    switch (opcode) {
#define GSIM_RCS_SERVICE(method, opcode, number, rrs, input, response_bytes, parameters, arguments)
#define GSIM_RCS_QUERY(method, opcode, number, rrs, input, output, response_bytes, parameters, arguments) \
    case GSIM_RCS_##opcode: return sizeof(gsim_rcs_##output);
#include "controller/module/rcs_services.def"
        default: return 0;
    }
}

static void set_identity(gsim_rcs_pose* pose) {
    int i;
    memset(pose, 0, sizeof *pose);
    for (i = 0; i < 16; i += 5) pose->matrix[i] = 1;
}

static int32_t go_to(gsim_rcs_module* m, int64_t id, const gsim_rcs_joints* joints) {
    m->target = id;
    m->at = *joints;
    m->arrives = 1;
    return GSIM_RCS_SUCCESS;
}

static int32_t next_step(gsim_rcs_module* m, gsim_rcs_step* step) {
    const int arrives = m->arrives;
    step->joints = m->at;
    set_identity(&step->pose);
    step->elapsed_s = arrives ? m->step_s : 0;
    m->arrives = 0;
    return arrives ? GSIM_RCS_TARGET_REACHED : GSIM_RCS_NEED_MORE_DATA;
}

static int32_t plain_answer(gsim_rcs_module* m, int32_t opcode, const void* input, void* output) {
    switch (opcode) {
        case GSIM_RCS_SET_INITIAL_POSITION: m->at = ((const gsim_rcs_position*)input)->joints; return 0;
        case GSIM_RCS_SET_NEXT_TARGET:
        case GSIM_RCS_SET_NEXT_NAMED_TARGET: {
            const gsim_rcs_target* target = (const gsim_rcs_target*)input;
            return go_to(m, target->id, &target->position.joints);
        }
        case GSIM_RCS_SET_NEXT_ARC_TARGET: {
            const gsim_rcs_arc_target* target = (const gsim_rcs_arc_target*)input;
            return go_to(m, target->id, &target->end.joints);
        }
        case GSIM_RCS_SET_NEXT_REST: return go_to(m, ((const gsim_rcs_rest*)input)->id, &m->at);
        case GSIM_RCS_SET_INTERPOLATION_TIME: m->step_s = ((const gsim_rcs_number*)input)->value; return 0;
        case GSIM_RCS_GET_NEXT_STEP: return next_step(m, (gsim_rcs_step*)output);
        case GSIM_RCS_GET_TARGET_OF_LAST_STEP: ((gsim_rcs_target_id*)output)->id = m->target; return 0;
        case GSIM_RCS_GET_INVERSE_KINEMATICS: *(gsim_rcs_joints*)output = m->at; return 0;
        case GSIM_RCS_GET_FORWARD_KINEMATICS:
        case GSIM_RCS_GET_CELL_FRAME: set_identity((gsim_rcs_pose*)output); return 0;
        default: return GSIM_RCS_SUCCESS;
    }
}

static void change_output(gsim_rcs_module* m, unsigned char* output, size_t size) {
    const size_t words = size / WORD;
    size_t at, i;
    if (words == 0) return;
    at = next_byte(m) % words * WORD;
    for (i = 0; i < WORD; ++i) output[at + i] = next_byte(m);
}

GSIM_RCS_EXPORT int32_t gsim_rcs_version(void) {
    return GSIM_RCS_VERSION;
}

static const char* parameter(const gsim_rcs_machine* machine, const char* key) {
    size_t i;
    for (i = 0; i < machine->parameter_count; ++i) {
        if (strcmp(machine->parameters[i].key, key) == 0) return machine->parameters[i].value;
    }
    return NULL;
}

GSIM_RCS_EXPORT gsim_rcs_module* gsim_rcs_create(const gsim_rcs_machine* machine, gsim_rcs_message* message) {
    const char* const response_bytes = parameter(machine, "answers");
    const char* const size = parameter(machine, "answers_size");
    gsim_rcs_module* m = calloc(1, sizeof *m);
    if (m == NULL) return NULL;
    message->text[0] = 0;
    m->joint_count = machine->joint_count;
    m->at.count = machine->joint_count;
    m->step_s = 0.01;
    m->size = response_bytes != NULL && size != NULL ? strtoul(size, NULL, 10) : 0;
    m->response_bytes = malloc(m->size + 1);
    if (m->response_bytes == NULL) {
        free(m);
        return NULL;
    }
    if (m->size > 0) memcpy(m->response_bytes, response_bytes, m->size);
    return m;
}

GSIM_RCS_EXPORT void gsim_rcs_destroy(gsim_rcs_module* m) {
    free(m->response_bytes);
    free(m);
}

GSIM_RCS_EXPORT int32_t gsim_rcs_call(gsim_rcs_module* m, int32_t opcode, const void* input, void* output) {
    const size_t size = output_size(opcode);
    const unsigned char how = next_byte(m);
    int32_t status;
    if (size > 0) memset(output, 0, size);
    status = plain_answer(m, opcode, input, output);
    if (how < KEEPS) return status;
    if ((how & CHANGES_STATUS) != 0) status = (signed char)next_byte(m);
    if ((how & CHANGES_OUTPUT) != 0) change_output(m, (unsigned char*)output, size);
    return status;
}
