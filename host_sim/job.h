/* job.h -- what commands have in common that make a mesh file, OUT, of another, IN:
 *
 *     if (!job_begin(&j, o)) return 2;
 *     if (job_load(&j) && ... && job_write(&j)) ... what else there is to say goes to j.to ...
 *     return job_end(&j);                                                                        */
#ifndef JOB_H
#define JOB_H

#include "options.h"

typedef struct job {
    const char *in, *out;
    load_options load;
    file_format format;
    model m;              /* IN, and what becomes of it */
    uint32_t vertices_in; /* as loaded */
    const char *refused;  /* why there can be no OUT, which is an answer; or null */
    FILE *to;             /* standard output, unless OUT goes there */
    bool json;
    int status; /* 2 until job_write() */
} job;

/* The command line: IN, OUT, and the options of all these commands. False after saying what is wrong. */
bool job_begin(job *j, const options *o);
bool job_load(job *j);
/* Of a mesh with a border: that it may be none. */
void job_hint(const job *j);
/* Says that f stands in the way; returns false. */
bool job_fail(const job *j, const failure *f);
/* Writes OUT, or says why there is none, and begins the report: a JSON object or a line for people. True if there is
 * more to put into it. */
bool job_write(job *j);
/* The exit status; *j is freed. */
int job_end(job *j);

#endif
