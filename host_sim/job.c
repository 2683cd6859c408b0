/* job.c -- IN, OUT, and a report that goes where the mesh does not. */
#include "job.h"

#include "files.h"
#include "json.h"
#include "report.h"

bool job_begin(job *j, const options *o) {
    memset(j, 0, sizeof *j);
    j->status = 2;
    if (o->operands != 3) {
        (void)fprintf(stderr, "nook: %s needs IN and OUT (see nook %s --help)\n", o->operand[0],
                      o->operand[0]);
        return false;
    }
    j->in = o->operand[1];
    j->out = o->operand[2];
    j->json = o->given[OPTION_JSON];
    j->to = strcmp(j->out, "-") == 0 ? stderr : stdout;
    if (is_same_file(j->in, j->out)) return usage_error("OUT must be another file than IN: ", j->out);
    return options_for_load(o, &j->load) && option_format(o, j->out, &j->format);
}

bool job_load(job *j) {
    failure f;
    if (!model_load(&j->m, j->in, &j->load, 0, &f)) return job_fail(j, &f);
    j->vertices_in = j->m.mesh.nv;
    return true;
}

void job_hint(const job *j) {
    char hint[160];
    if (model_hint(&j->m, hint, sizeof hint)) print_message(stderr, j->in, hint);
}

bool job_fail(const job *j, const failure *f) {
    print_failure(stderr, j->in, f);
    if (j->json) report_json_unreadable(j->to, j->in, j->m.format, f);
    return false;
}

bool job_write(job *j) {
    bool none = j->refused != NULL;
    if (none) print_message(stderr, j->in, j->refused);
    if (!none && !write_mesh(&j->m.mesh, j->out, j->format)) return false;
    j->status = none ? 1 : 0;
    if (!j->json) {
        print_name(j->to, none ? "" : j->out);
        return !none;
    }
    (void)fputs("{\"file\":", j->to);
    put_string(j->to, j->in);
    put_count(j->to, "vertices_in", j->vertices_in);
    put_count(j->to, "triangles_in", j->m.triangles_in);
    put_count(j->to, "vertices", none ? NOOK_UNKNOWN : j->m.mesh.nv);
    put_count(j->to, "triangles", none ? NOOK_UNKNOWN : j->m.mesh.nt);
    return true;
}

int job_end(job *j) {
    if (j->status != 2 && j->json) (void)fputc('}', j->to);
    if (j->status != 2 && (j->json || j->refused == NULL)) (void)fputc('\n', j->to);
    model_free(&j->m);
    return j->status;
}
