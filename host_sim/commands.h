/* commands.h -- one function a command. Each returns the exit status: 0 done or sound, 1 the answer
 * is no, 2 usage, malformed input or no capacity. */
#ifndef COMMANDS_H
#define COMMANDS_H

#include "options.h"

int cmd_check(const options *o);
int cmd_make(const options *o);
int cmd_query(const options *o);
int cmd_hull(const options *o);
int cmd_smooth(const options *o);
int cmd_simplify(const options *o);

extern const char check_help[];
extern const char make_help[];
extern const char query_help[];
extern const char hull_help[];
extern const char smooth_help[];
extern const char simplify_help[];

#endif
