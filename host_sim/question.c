/* question.c -- {"point":[x,y,z]}, {"ray":{"origin":[..],"direction":[..]}},
 * {"segment":[[..],[..]],"radius":r}. Keys stand in any order; those of no meaning here are skipped. */
#include "question.h"

#include "json.h"

static bool read_vector(json *j, nook_point *p) {
    float x[3];
    if (!json_floats(j, x, 3)) return false;
    *p = nook_make(x[0], x[1], x[2]);
    return true;
}

static bool read_place(json *j, nook_point *p) {
    if (!read_vector(j, p)) return false;
    return nook_point_status(*p) == NOOK_OK ? true : json_fail(j, "a coordinate larger than 2^30");
}

static bool read_ray(json *j, question *q) {
    bool first = true, origin = false, direction = false;
    word key;
    if (!json_take(j, '{')) return json_fail(j, "a ray must be an object");
    while (json_member(j, &first, &key)) {
        if (word_is(key, "origin")) {
            origin = read_place(j, &q->a);
        } else if (word_is(key, "direction")) {
            direction = read_vector(j, &q->b);
        } else {
            (void)json_skip(j);
        }
        if (j->wrong != NULL) return false;
    }
    if (!origin) return json_fail(j, "a ray without an origin");
    if (!direction) return json_fail(j, "a ray without a direction");
    return q->b.x != 0 || q->b.y != 0 || q->b.z != 0 ? true : json_fail(j, "a direction of 0");
}

static bool read_segment(json *j, question *q) {
    if (!json_take(j, '[')) return json_fail(j, "a segment must be an array of two points");
    if (!read_place(j, &q->a)) return false;
    if (!json_take(j, ',')) return json_fail(j, "a segment must be an array of two points");
    if (!read_place(j, &q->b)) return false;
    return json_take(j, ']') ? true : json_fail(j, "a segment must be an array of two points");
}

static bool read_radius(json *j, float *radius) {
    if (!json_float(j, radius)) return false;
    return *radius >= 0 ? true : json_fail(j, "a negative radius");
}

static question_kind kind_of(word key) {
    if (word_is(key, "point")) return ASK_POINT;
    if (word_is(key, "ray")) return ASK_RAY;
    if (word_is(key, "segment")) return ASK_SEGMENT;
    return ASK_NOTHING;
}

static bool read_member(json *j, word key, question *q) {
    question_kind kind = kind_of(key);
    if (word_is(key, "radius")) return read_radius(j, &q->radius);
    if (kind == ASK_NOTHING) return json_skip(j);
    if (q->kind != ASK_NOTHING) return json_fail(j, "more than one question on a line");
    q->kind = kind;
    if (kind == ASK_POINT) return read_place(j, &q->a);
    return kind == ASK_RAY ? read_ray(j, q) : read_segment(j, q);
}

static bool read_question(json *j, question *q) {
    bool first = true;
    word key;
    if (!json_take(j, '{')) return json_fail(j, "not a JSON object");
    while (json_member(j, &first, &key)) {
        if (!read_member(j, key, q)) return false;
    }
    if (j->wrong != NULL) return false;
    if (!json_at_end(j)) return json_fail(j, "more on the line than an object");
    return q->kind != ASK_NOTHING ? true : json_fail(j, "neither a point nor a ray nor a segment");
}

bool question_read(question *q, const char *text, size_t length, const char **wrong) {
    json j;
    memset(q, 0, sizeof *q);
    json_begin(&j, text, length);
    (void)read_question(&j, q);
    *wrong = j.wrong;
    return j.wrong == NULL;
}
